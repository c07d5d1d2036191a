// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/servo/ServoParameters.h"
#include "core/servo/ServoState.h"

#include <bit>

namespace core::servo {
namespace {

using settings::FeelPreset;

/// The row of a preset for each material; caries has that of soft caries.
constexpr std::array<std::size_t, terrain::kMaterialCount> kRows{
    static_cast<std::size_t>(settings::Substance::SoftCaries), static_cast<std::size_t>(settings::Substance::Enamel),
    static_cast<std::size_t>(settings::Substance::Dentin), static_cast<std::size_t>(settings::Substance::Pulp)};
constexpr std::size_t kOfMaterials = 2 * terrain::kMaterialCount;
constexpr std::size_t kFirstNumbers = kOfMaterials + 6;
/// The indices in feelFields() of the numbers that do not belong to a material.
constexpr std::array<std::size_t, kServoNumbers - kOfMaterials> kRest{
    2 * settings::kSubstances,     settings::kCuttingFields,     settings::kCuttingFields + 1,
    settings::kCuttingFields + 2,  settings::kCuttingFields + 3, settings::kCuttingFields + 4,
    2 * settings::kSubstances + 1, 2 * settings::kSubstances + 2};

const NumberField<FeelPreset>& fieldOf(std::size_t index) noexcept
{
    if (index < kOfMaterials)
        return settings::feelFields()[2 * kRows[index / 2] + index % 2];
    return settings::feelFields()[kRest[index - kOfMaterials]];
}

double& numberOf(ServoSettings& settings, std::size_t index) noexcept
{
    if (index < kOfMaterials) {
        settings::MaterialHardness& material = settings.hardness.material[index / 2];
        return index % 2 == 0 ? material.rateMm3PerNs : material.thresholdN;
    }
    switch (index - kOfMaterials) {
    case 0:
        return settings.hardness.axialShare;
    case 1:
        return settings.force.stiffnessNPerMm;
    case 2:
        return settings.force.dampingNSPerM;
    case 3:
        return settings.force.fastDampingNSPerM;
    case 4:
        return settings.force.friction;
    case 5:
        return settings.force.clampN;
    case 6:
        return settings.hardness.flatEndShare;
    default:
        return settings.hardness.fullLoadN;
    }
}

}  // namespace

ServoParameters parametersOf(const ServoSettings& settings)
{
    ServoSettings copy = settings;
    ServoParameters numbers{};
    for (std::size_t k = 0; k < numbers.size(); ++k)
        numbers[k] = numberOf(copy, k);
    return numbers;
}

bool isServoNumber(const SetParameter& number) noexcept
{
    if (number.index >= kServoNumbers)
        return false;
    const NumberField<FeelPreset>& field = fieldOf(number.index);
    return number.value >= static_cast<float>(field.minimum) && number.value <= static_cast<float>(field.maximum);
}

void setServoNumber(ServoSettings& settings, const SetParameter& number) noexcept
{
    if (isServoNumber(number))
        numberOf(settings, number.index) = static_cast<double>(number.value);
}

std::uint64_t packNumber(const SetParameter& number) noexcept
{
    return std::uint64_t{number.index} << 32U | std::bit_cast<std::uint32_t>(number.value);
}

std::optional<SetParameter> unpackParameter(std::uint64_t packed) noexcept
{
    const SetParameter number{static_cast<std::uint8_t>(packed >> 32U),
                              std::bit_cast<float>(static_cast<std::uint32_t>(packed))};
    const bool isSound = packed >> 32U < kServoNumbers && isServoNumber(number);
    return isSound ? std::optional(number) : std::nullopt;
}

bool isOfFirstParameters(std::uint64_t packed) noexcept
{
    return packed >> 32U < kFirstNumbers;
}

}  // namespace core::servo
