// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>

#include "core/base/Result.h"
#include "core/terrain/Tooth.h"

namespace core::settings {

/// The removal of one material: dV/dt = rate * max(0, F - threshold) (Preston's law) up to the full load of the preset,
/// at the speed cutting::kReferenceRpmMm.
struct MaterialHardness
{
    double rateMm3PerNs = 0.7;  ///< volume per second for each newton above the threshold, pushing sideways
    double thresholdN = 0.15;   ///< a smaller force removes nothing
    bool operator==(const MaterialHardness&) const = default;
};

/// The hardness of the lower zones of decay, in a tooth whose decay has zones (terrain::DecayZones).
struct DecayZoneHardness
{
    MaterialHardness leathery;
    MaterialHardness firm;
    bool operator==(const DecayZoneHardness&) const = default;
};

/// The full load of a preset whose rate grows without limit: the largest force limit that a preset may have.
inline constexpr double kNoFullLoadN = 20.0;

/// The hardness of a tooth. docs/method.md has the sources of the shipped values.
struct HardnessPreset
{
    std::string name = "natural";
    std::array<MaterialHardness, terrain::kMaterialCount> material{{
        {5.0, 0.05},  // caries
        {0.7, 0.15},  // enamel
        {2.2, 0.10},  // dentin
        {20.0, 0.0},  // pulp gives way
    }};
    /// Hardness of the leathery and the firm zone; the row of caries is then that of the soft one. Empty: the row of
    /// caries applies to all decay.
    std::optional<DecayZoneHardness> decayZones = {};
    /// Share of the rate when a bur is pushed along its axis: the end cuts more slowly than the side.
    double axialShare = 0.65;
    /// Factor of axialShare for a bur with a flat end, such as a pear or a fissure bur (Bur::hasFlatEnd()): 0.40 of the
    /// rate. 1: the shape of the end has no effect.
    double flatEndShare = 0.615;
    /// Load beyond which a bur removes no more, N. From kNoFullLoadN on the rate grows with any load.
    double fullLoadN = 1.5;
    bool operator==(const HardnessPreset&) const = default;

    /// Returns the share of the rate when a bur is pushed along its axis.
    [[nodiscard]] double shareOfEnd(bool isFlat) const noexcept
    {
        return isFlat ? axialShare * flatEndShare : axialShare;
    }
    /// Copies all members but the name. Allocates nothing.
    void takeFigures(const HardnessPreset& other) noexcept
    {
        material = other.material;
        decayZones = other.decayZones;
        axialShare = other.axialShare;
        flatEndShare = other.flatEndShare;
        fullLoadN = other.fullLoadN;
    }
};

/// Returns the material values with cutting as in Cusp before flat ends and full loads: the meaning of a recording or a
/// preset without them.
[[nodiscard]] inline HardnessPreset withoutEndsAndFullLoad(HardnessPreset preset)
{
    preset.flatEndShare = 1.0;
    preset.fullLoadN = kNoFullLoadN;
    return preset;
}

inline constexpr double kMinRateMm3PerNs = 0.0;
inline constexpr double kMaxRateMm3PerNs = 100.0;
inline constexpr double kMaxThresholdN = 10.0;
inline constexpr double kMinShare = 0.01;  ///< for axialShare and flatEndShare; the largest is 1
inline constexpr double kMinFullLoadN = 0.2;

/// Returns "natural" or "typodont" (one plastic throughout); UnknownName otherwise.
[[nodiscard]] Result<HardnessPreset> findHardnessPreset(std::string_view name);

/// Checks a preset. OutOfRange names the first value outside its limits.
[[nodiscard]] Status check(const HardnessPreset& preset);

}  // namespace core::settings
