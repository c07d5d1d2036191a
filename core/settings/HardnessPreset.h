// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>

#include "core/base/Result.h"
#include "core/terrain/Tooth.h"

namespace core::settings {

/// How one material yields: dV/dt = rate * max(0, F - threshold) (haptics.md 8.1, Preston's law), at the speed that
/// drilling::kReferenceRpmMm stands for.
struct MaterialHardness
{
    double rateMm3PerNs = 0.7;  ///< volume a second for each newton above the threshold, pushing sideways
    double thresholdN = 0.15;   ///< a lighter touch leaves no mark
    bool operator==(const MaterialHardness&) const = default;
};

/// What a tooth feels like to cut. Values of the shipped presets: haptics.md 8.1, teeth.md section 5 (weak, so
/// settings).
struct HardnessPreset
{
    std::string name = "natural";
    std::array<MaterialHardness, terrain::kMaterialCount> material{{
        {5.0, 0.05},  // caries
        {0.7, 0.15},  // enamel
        {2.2, 0.10},  // dentin
        {20.0, 0.0},  // pulp gives way
    }};
    /// Share of the rate that is left when pushing along the bur's axis: end cutting is slower than side cutting. With
    /// 0.65 ten light strokes make the trench that dentists asked for (haptics.md 8.3).
    double axialShare = 0.65;
    bool operator==(const HardnessPreset&) const = default;
};

inline constexpr double kMinRateMm3PerNs = 0.0;
inline constexpr double kMaxRateMm3PerNs = 100.0;
inline constexpr double kMaxThresholdN = 10.0;

/// "natural" or "typodont" (one plastic throughout); UnknownName otherwise.
[[nodiscard]] Result<HardnessPreset> findHardnessPreset(std::string_view name);

/// OutOfRange naming the first value outside its limits.
[[nodiscard]] Status check(const HardnessPreset& preset);

}  // namespace core::settings
