// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/settings/PedalSettings.h"

#include <algorithm>
#include <cmath>

namespace core::settings {
namespace {

constexpr double kFullAt = 0.97;  ///< share of the travel that counts as full, because pedals wear

}  // namespace

double PedalSettings::travelAt(double reading) const noexcept
{
    const double from = isInverted ? fullReading : restReading;
    const double to = isInverted ? restReading : fullReading;
    if (!std::isfinite(reading) || !(std::abs(to - from) >= kLeastTravel))
        return 0.0;
    return std::clamp((reading - from) / (to - from), 0.0, 1.0);
}

double PedalSettings::speedAt(double travel) const noexcept
{
    const double dead = std::clamp(deadZone, 0.0, kMostDeadZone);
    const double pressed = std::clamp((travel - dead) / (kFullAt - dead), 0.0, 1.0);
    return std::pow(pressed, std::clamp(curve, kLeastCurve, kMostCurve));
}

}  // namespace core::settings
