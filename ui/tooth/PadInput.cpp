// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tooth/PadInput.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace ui::tooth {
namespace {

using core::session::Controller;

constexpr double kStickDeadZone = 0.2;
constexpr double kTriggerDeadZone = 0.1;

double axisOf(const Controller& gamepad, std::size_t axis)
{
    const double reading = static_cast<double>(gamepad.axes[axis]);
    return std::isfinite(reading) ? std::clamp(reading, -1.0, 1.0) : 0.0;
}

/// Returns the deflection of a stick. The dead zone is round: it applies to the distance and not to each axis.
glm::dvec2 stickOf(const Controller& gamepad, std::size_t x, std::size_t y)
{
    const glm::dvec2 reading(axisOf(gamepad, x), -axisOf(gamepad, y));
    const double way = glm::length(reading);
    if (way <= kStickDeadZone)
        return glm::dvec2(0.0);
    const double share = std::min(1.0, (way - kStickDeadZone) / (1.0 - kStickDeadZone));
    return reading * (share * share / way);
}

}  // namespace

PadInput padInput(const Controller& gamepad)
{
    if (!gamepad.isGamepad || gamepad.axes.size() < core::session::kGamepadAxes)
        return {};
    PadInput input;
    input.move = stickOf(gamepad, core::session::kLeftStickX, core::session::kLeftStickY);
    input.turn = stickOf(gamepad, core::session::kRightStickX, core::session::kRightStickY);
    input.press =
        std::max(0.0, (axisOf(gamepad, core::session::kRightTrigger) - kTriggerDeadZone) / (1.0 - kTriggerDeadZone));
    return input;
}

}  // namespace ui::tooth
