// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/falcon/Calibration.h"

#include <cmath>

namespace haptics::falcon {
namespace {

/// Largest permitted difference from the default values, as a share and as an angle.
constexpr double kLengthShare = 0.2;
constexpr double kHomeDifferenceRad = 20.0 * std::numbers::pi / 180.0;

bool isNear(double value, double usual)
{
    return std::abs(value - usual) <= kLengthShare * std::abs(usual);
}

}  // namespace

core::Status check(const Calibration& calibration)
{
    const Geometry& is = calibration.geometry;
    const Geometry usual;
    const auto refused = [](const char* what) { return core::unexpected(core::ErrorCode::OutOfRange, what); };
    // Only the differences of c, f, r and s matter.
    if (!isNear(is.a, usual.a) || !isNear(is.b, usual.b) || !isNear(is.de, usual.de) ||
        !(std::abs((is.r - is.c) - (usual.r - usual.c)) <= 10.0) ||
        !(std::abs((is.s - is.f) - (usual.s - usual.f)) <= 10.0))
        return refused("The lengths of the arms differ by more than a fifth from those of a Falcon.");
    if (!isNear(calibration.countRad, kCountRad))
        return refused("The angle of one count differs by more than a fifth from that of a Falcon.");
    for (int leg = 0; leg < 3; ++leg)
        if (!(std::abs(calibration.homeRad[leg] - kHomeRad) <= kHomeDifferenceRad))
            return refused("The angle at the index mark must be from 15 to 55 degrees.");
    if (!(calibration.commandPerNm >= 1000.0 && calibration.commandPerNm <= 30000.0))
        return refused("The motor command for 1 Nm must be from 1000 to 30000.");
    if (!(calibration.gripWeightN >= 0.0 && calibration.gripWeightN <= 3.0))
        return refused("The weight of the grip must be from 0 to 3 N.");
    return {};
}

}  // namespace haptics::falcon
