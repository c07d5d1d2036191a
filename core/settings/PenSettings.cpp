// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/settings/PenSettings.h"

#include <algorithm>
#include <cmath>

namespace core::settings {

double PenSettings::shareAt(double pressure) const noexcept
{
    if (std::isnan(pressure) || std::isnan(curve))
        return kLeastShare;
    const double exponent = std::clamp(curve, kLeastCurve, kMostCurve);
    return std::max(kLeastShare, std::pow(std::clamp(pressure, 0.0, 1.0), exponent));
}

}  // namespace core::settings
