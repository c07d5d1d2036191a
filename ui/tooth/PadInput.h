// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec2.hpp>

#include "core/session/ControllerReport.h"

namespace ui::tooth {

/// Movement of the bur and the view that a gamepad requests.
struct PadInput
{
    glm::dvec2 move{0.0};  ///< movement of the bur to the right and away from the eye; -1 to 1 times the highest speed
    glm::dvec2 turn{0.0};  ///< rotation of the eye to the right and upwards, likewise
    double press = 0.0;    ///< share of the force, 0 to 1; 0: the bur does not push
    bool operator==(const PadInput&) const = default;
};

/// Converts the sticks and the right trigger. Ignores a stick within a fifth of its travel, a trigger within a tenth,
/// and values that are not finite. Most of the travel is for slow movements.
[[nodiscard]] PadInput padInput(const core::session::Controller& gamepad);

}  // namespace ui::tooth
