// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cutting/Feed.h"

#include <numbers>

#include "core/cutting/Drill.h"

namespace core::cutting {

double feedMmPerS(const settings::HardnessPreset& preset, const settings::MaterialHardness& hardness,
                  const settings::Handpiece& handpiece, const bur::Bur& bur, double forceN) noexcept
{
    const double radius = bur.headRadiusMm;
    const auto speedAt = [&](double newtons) {
        return handpiece.rpmUnder(kCuttingFriction * newtons * radius) * radius / kReferenceRpmMm;
    };
    return paceMm3PerS(preset, hardness, forceN, preset.shareOfEnd(bur.hasFlatEnd()), speedAt) /
           (std::numbers::pi * radius * radius);
}

}  // namespace core::cutting
