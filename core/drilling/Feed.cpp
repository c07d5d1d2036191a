// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/drilling/Feed.h"

#include <algorithm>
#include <numbers>

#include "core/drilling/Drill.h"

namespace core::drilling {

double feedMmPerS(const settings::MaterialHardness& hardness, double axialShare, const settings::Handpiece& handpiece,
                  const Bur& bur, double forceN) noexcept
{
    const double radius = bur.headRadiusMm;
    const double speed = handpiece.rpmUnder(kCuttingFriction * forceN * radius) * radius / kReferenceRpmMm;
    const double mm3PerS = hardness.rateMm3PerNs * std::max(0.0, forceN - hardness.thresholdN) * axialShare * speed;
    return mm3PerS / (std::numbers::pi * radius * radius);
}

}  // namespace core::drilling
