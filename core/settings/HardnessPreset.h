// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>

#include "core/base/Result.h"
#include "core/terrain/Tooth.h"

namespace core::settings {

/// How one material yields: dV/dt = rate * max(0, F - threshold) (Preston's law) up to the full load of the preset, at
/// the speed that cutting::kReferenceRpmMm stands for.
struct MaterialHardness
{
    double rateMm3PerNs = 0.7;  ///< volume a second for each newton above the threshold, pushing sideways
    double thresholdN = 0.15;   ///< a lighter touch leaves no mark
    bool operator==(const MaterialHardness&) const = default;
};

/// How the lower zones of decay yield, in a tooth whose decay has zones (terrain::DecayZones).
struct DecayZoneHardness
{
    MaterialHardness leathery;
    MaterialHardness firm;
    bool operator==(const DecayZoneHardness&) const = default;
};

/// The full load of a preset whose pace grows with the load without end: the largest force limit that a preset may
/// have.
inline constexpr double kNoFullLoadN = 20.0;

/// What a tooth feels like to cut. docs/method.md names the sources of the shipped values.
struct HardnessPreset
{
    std::string name = "natural";
    std::array<MaterialHardness, terrain::kMaterialCount> material{{
        {5.0, 0.05},  // caries
        {0.7, 0.15},  // enamel
        {2.2, 0.10},  // dentin
        {20.0, 0.0},  // pulp gives way
    }};
    /// Of the leathery and the firm zone; the row of caries is then that of the soft one. Without it, the row of caries
    /// holds for all decay.
    std::optional<DecayZoneHardness> decayZones = {};
    /// Share of the rate that is left when a bur is pushed along its axis: the end cuts more slowly than the side.
    double axialShare = 0.65;
    /// Share of axialShare that a bur with a flat end has, as a pear or a fissure bur (Bur::hasFlatEnd()): 0.40 of the
    /// rate is left. 1: the shape of the end makes no difference.
    double flatEndShare = 0.615;
    /// Load beyond which a bur removes no more, N. From kNoFullLoadN on the pace grows with any load.
    double fullLoadN = 1.5;
    bool operator==(const HardnessPreset&) const = default;

    /// Returns what is left of the rate when a bur is pushed along its axis.
    [[nodiscard]] double shareOfEnd(bool isFlat) const noexcept
    {
        return isFlat ? axialShare * flatEndShare : axialShare;
    }
    /// Takes everything but the name of another preset. Allocates nothing.
    void takeFigures(const HardnessPreset& other) noexcept
    {
        material = other.material;
        decayZones = other.decayZones;
        axialShare = other.axialShare;
        flatEndShare = other.flatEndShare;
        fullLoadN = other.fullLoadN;
    }
};

/// The same material figures, cut as by Cusp before there were flat ends and full loads: what a recording or a preset
/// means that says nothing of them.
[[nodiscard]] inline HardnessPreset withoutEndsAndFullLoad(HardnessPreset preset)
{
    preset.flatEndShare = 1.0;
    preset.fullLoadN = kNoFullLoadN;
    return preset;
}

inline constexpr double kMinRateMm3PerNs = 0.0;
inline constexpr double kMaxRateMm3PerNs = 100.0;
inline constexpr double kMaxThresholdN = 10.0;
inline constexpr double kMinShare = 0.01;  ///< of axialShare and flatEndShare; the largest is 1
inline constexpr double kMinFullLoadN = 0.2;

/// "natural" or "typodont" (one plastic throughout); UnknownName otherwise.
[[nodiscard]] Result<HardnessPreset> findHardnessPreset(std::string_view name);

/// OutOfRange naming the first value outside its limits.
[[nodiscard]] Status check(const HardnessPreset& preset);

}  // namespace core::settings
