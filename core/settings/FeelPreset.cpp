// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/settings/FeelPreset.h"

#include <cmath>

namespace core::settings {
namespace {

constexpr const char* kRateUnit = "mm³/(N s)";
constexpr std::size_t kShownHash = 8;

using Field = NumberField<FeelPreset>;

// The damping is limited by CHAI3D's value for a Falcon (docs/facts/haptics.md, section 5). With more, or with more
// than 60 for fast motion, the damper itself oscillates when the device answers late (StabilityBound.h).
const std::array<Field, kCuttingFields + 5> kFields{{
    {"soft_caries.rate_mm3_per_ns", "rate of soft caries", kRateUnit, &FeelPreset::softCariesRate, kMinRateMm3PerNs,
     kMaxRateMm3PerNs},
    {"soft_caries.threshold_n", "threshold of soft caries", "N", &FeelPreset::softCariesFromN, 0.0, kMaxThresholdN},
    {"firm_caries.rate_mm3_per_ns", "rate of firm caries", kRateUnit, &FeelPreset::firmCariesRate, kMinRateMm3PerNs,
     kMaxRateMm3PerNs},
    {"firm_caries.threshold_n", "threshold of firm caries", "N", &FeelPreset::firmCariesFromN, 0.0, kMaxThresholdN},
    {"enamel.rate_mm3_per_ns", "rate of enamel", kRateUnit, &FeelPreset::enamelRate, kMinRateMm3PerNs,
     kMaxRateMm3PerNs},
    {"enamel.threshold_n", "threshold of enamel", "N", &FeelPreset::enamelFromN, 0.0, kMaxThresholdN},
    {"dentin.rate_mm3_per_ns", "rate of dentin", kRateUnit, &FeelPreset::dentinRate, kMinRateMm3PerNs,
     kMaxRateMm3PerNs},
    {"dentin.threshold_n", "threshold of dentin", "N", &FeelPreset::dentinFromN, 0.0, kMaxThresholdN},
    {"pulp.rate_mm3_per_ns", "rate of pulp", kRateUnit, &FeelPreset::pulpRate, kMinRateMm3PerNs, kMaxRateMm3PerNs},
    {"pulp.threshold_n", "threshold of pulp", "N", &FeelPreset::pulpFromN, 0.0, kMaxThresholdN},
    {"plastic.rate_mm3_per_ns", "rate of plastic", kRateUnit, &FeelPreset::plasticRate, kMinRateMm3PerNs,
     kMaxRateMm3PerNs},
    {"plastic.threshold_n", "threshold of plastic", "N", &FeelPreset::plasticFromN, 0.0, kMaxThresholdN},
    {"axial_share", "axial share", "", &FeelPreset::axialShare, kMinShare, 1.0},
    {"flat_end_share", "share of flat ends", "", &FeelPreset::flatEndShare, kMinShare, 1.0},
    {"full_load_n", "full load", "N", &FeelPreset::fullLoadN, kMinFullLoadN, kNoFullLoadN},
    {"force.stiffness_n_per_mm", "stiffness", "N/mm", &FeelPreset::stiffnessNPerMm, 0.2, 20.0},
    {"force.damping_ns_per_m", "damping", "N s/m", &FeelPreset::dampingNSPerM, 0.0, 20.0},
    {"force.fast_damping_ns_per_m", "damping of fast motion", "N s/m", &FeelPreset::fastDampingNSPerM, 0.0, 60.0},
    {"force.friction", "friction", "", &FeelPreset::friction, 0.0, 0.6},
    {"force.limit_n", "force limit", "N", &FeelPreset::clampN, 0.5, 20.0},
}};

std::string labelWith(const FeelPreset& preset, std::size_t digits)
{
    const std::string label = preset.name + " v" + std::to_string(preset.version);
    return label + (preset.hash.empty() ? ", changed" : " #" + preset.hash.substr(0, digits));
}

/// Returns the row of the preset for the tooth's decay; for decay with zones, that of the soft zone.
Substance decayOf(const ToothKind& tooth)
{
    return tooth.decay == DecayKind::Firm ? Substance::FirmCaries : Substance::SoftCaries;
}

}  // namespace

std::span<const Field> feelFields()
{
    return kFields;
}

const Field& rateField(Substance substance)
{
    return kFields[2 * static_cast<std::size_t>(substance)];
}

const Field& thresholdField(Substance substance)
{
    return kFields[2 * static_cast<std::size_t>(substance) + 1];
}

MaterialHardness hardnessOf(const FeelPreset& preset, Substance substance)
{
    return {preset.*rateField(substance).value, preset.*thresholdField(substance).value};
}

FeelPreset withoutEndsAndFullLoad(FeelPreset preset)
{
    preset.flatEndShare = 1.0;
    preset.fullLoadN = kNoFullLoadN;
    return preset;
}

std::string labelOf(const FeelPreset& preset)
{
    return labelWith(preset, kShownHash);
}

HardnessPreset hardnessFor(const FeelPreset& preset, const ToothKind& tooth)
{
    HardnessPreset hardness;
    hardness.name = labelWith(preset, std::string::npos);  // the label by which an attempt refers to it
    hardness.axialShare = preset.axialShare;
    hardness.flatEndShare = preset.flatEndShare;
    hardness.fullLoadN = preset.fullLoadN;
    if (tooth.isPlastic)
        hardness.material.fill(hardnessOf(preset, Substance::Plastic));
    else
        hardness.material = {hardnessOf(preset, decayOf(tooth)), hardnessOf(preset, Substance::Enamel),
                             hardnessOf(preset, Substance::Dentin), hardnessOf(preset, Substance::Pulp)};
    if (!tooth.isPlastic && tooth.decay == DecayKind::Graded) {
        const MaterialHardness soft = hardnessOf(preset, Substance::SoftCaries);
        const MaterialHardness firm = hardnessOf(preset, Substance::FirmCaries);
        hardness.decayZones = {
            {std::sqrt(soft.rateMm3PerNs * firm.rateMm3PerNs), 0.5 * (soft.thresholdN + firm.thresholdN)}, firm};
    }
    return hardness;
}

void putForces(const FeelPreset& preset, contact::ForceSettings& force)
{
    force.stiffnessNPerMm = preset.stiffnessNPerMm;
    force.dampingNSPerM = preset.dampingNSPerM;
    force.fastDampingNSPerM = preset.fastDampingNSPerM;
    force.friction = preset.friction;
    force.clampN = preset.clampN;
}

FeelPreset feltAs(FeelPreset base, const HardnessPreset& hardness, const contact::ForceSettings& force,
                  const ToothKind& tooth)
{
    const auto putRow = [&](Substance substance, const MaterialHardness& yields) {
        base.*rateField(substance).value = yields.rateMm3PerNs;
        base.*thresholdField(substance).value = yields.thresholdN;
    };
    const auto put = [&](Substance substance, terrain::Material material) {
        putRow(substance, hardness.material[static_cast<std::size_t>(material)]);
    };
    if (tooth.isPlastic) {
        put(Substance::Plastic, terrain::Material::Enamel);
    } else {
        put(decayOf(tooth), terrain::Material::Caries);
        if (hardness.decayZones)
            putRow(Substance::FirmCaries, hardness.decayZones->firm);
        put(Substance::Enamel, terrain::Material::Enamel);
        put(Substance::Dentin, terrain::Material::Dentin);
        put(Substance::Pulp, terrain::Material::Pulp);
    }
    base.axialShare = hardness.axialShare;
    base.flatEndShare = hardness.flatEndShare;
    base.fullLoadN = hardness.fullLoadN;
    base.stiffnessNPerMm = force.stiffnessNPerMm;
    base.dampingNSPerM = force.dampingNSPerM;
    base.fastDampingNSPerM = force.fastDampingNSPerM;
    base.friction = force.friction;
    base.clampN = force.clampN;
    return base;
}

Status check(const FeelPreset& preset)
{
    return validateNumbers(feelFields(), preset);
}

}  // namespace core::settings
