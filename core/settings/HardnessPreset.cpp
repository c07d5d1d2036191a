// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/settings/HardnessPreset.h"

#include <string_view>

#include "core/settings/Within.h"

namespace core::settings {
Result<HardnessPreset> findHardnessPreset(std::string_view name)
{
    if (name == "natural")
        return HardnessPreset{};
    if (name == "typodont") {
        HardnessPreset plastic;
        plastic.name = "typodont";
        plastic.material.fill({2.5, 0.12});
        return plastic;
    }
    return unexpected(ErrorCode::UnknownName,
                      LocalizableText{"There is no hardness preset '%1'; choose natural or typodont, or name a file.",
                                      {noted(std::string(name))}});
}

namespace {

Status checkRow(const HardnessPreset& preset, const MaterialHardness& row, std::string_view name)
{
    if (!within(row.rateMm3PerNs, kMinRateMm3PerNs, kMaxRateMm3PerNs))
        return unexpected(ErrorCode::OutOfRange, "Hardness preset '" + preset.name + "': the rate of " +
                                                     std::string(name) + " must lie between 0 and 100 mm3/(N s).");
    if (!within(row.thresholdN, 0.0, kMaxThresholdN))
        return unexpected(ErrorCode::OutOfRange, "Hardness preset '" + preset.name + "': the threshold of " +
                                                     std::string(name) + " must lie between 0 and 10 N.");
    return {};
}

}  // namespace

Status check(const HardnessPreset& preset)
{
    static constexpr std::array<std::string_view, terrain::kMaterialCount> kNames{"caries", "enamel", "dentin", "pulp"};
    for (std::size_t m = 0; m < kNames.size(); ++m)
        if (Status row = checkRow(preset, preset.material[m], kNames[m]); !row)
            return row;
    if (preset.decayZones) {
        if (Status row = checkRow(preset, preset.decayZones->leathery, "leathery caries"); !row)
            return row;
        if (Status row = checkRow(preset, preset.decayZones->firm, "firm caries"); !row)
            return row;
    }
    if (!within(preset.axialShare, kMinShare, 1.0))
        return unexpected(ErrorCode::OutOfRange,
                          "Hardness preset '" + preset.name + "': the axial share must lie between 0.01 and 1.");
    if (!within(preset.flatEndShare, kMinShare, 1.0))
        return unexpected(ErrorCode::OutOfRange,
                          "Hardness preset '" + preset.name + "': the share of flat ends must lie between 0.01 and 1.");
    if (!within(preset.fullLoadN, kMinFullLoadN, kNoFullLoadN))
        return unexpected(ErrorCode::OutOfRange,
                          "Hardness preset '" + preset.name + "': the full load must lie between 0.2 and 20 N.");
    return {};
}

}  // namespace core::settings
