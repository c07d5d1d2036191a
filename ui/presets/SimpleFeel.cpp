// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/presets/SimpleFeel.h"

#include <algorithm>
#include <cmath>

#include "core/settings/StabilityBound.h"

namespace ui::presets {
namespace {

using core::settings::FeelPreset;
using core::settings::Substance;
using Field = core::NumberField<FeelPreset>;

constexpr double kFarthest = 4.0;      ///< times a rate or a threshold
constexpr double kStiffest = 2.0;      ///< times the stiffness
constexpr double kWithinBound = 0.99;  ///< of it
constexpr double kThousandths = 1000.0;

void scale(FeelPreset& preset, const Field& field, double factor)
{
    double& value = preset.*field.value;
    if (factor != 1.0)
        value = std::clamp(std::round(value * factor * kThousandths) / kThousandths, field.minimum, field.maximum);
}

}  // namespace

FeelPreset turned(const FeelPreset& base, const Dials& dials)
{
    FeelPreset preset = base;
    const auto dial = [&](Dial which) { return dials.at(static_cast<std::size_t>(which)); };
    const auto harder = [&](Substance substance, Dial which) {
        scale(preset, core::settings::rateField(substance), std::pow(kFarthest, -dial(which)));
    };
    harder(Substance::Enamel, Dial::Enamel);
    harder(Substance::Dentin, Dial::Dentin);
    harder(Substance::SoftCaries, Dial::Caries);
    harder(Substance::FirmCaries, Dial::Caries);
    harder(Substance::Plastic, Dial::Plastic);
    for (std::size_t k = 0; k < core::settings::kSubstances; ++k)
        scale(preset, core::settings::thresholdField(static_cast<Substance>(k)),
              std::pow(kFarthest, dial(Dial::Touch)));
    if (const double wall = dial(Dial::Wall); wall != 0.0) {
        const double most = kWithinBound * core::settings::stabilityBound(preset).stiffnessNPerMm;
        const double wanted = base.stiffnessNPerMm * std::pow(kStiffest, wall);
        // One that is beyond the bound already is not stiffened.
        preset.stiffnessNPerMm =
            std::round(std::min(wanted, std::max(most, std::min(wanted, base.stiffnessNPerMm))) * kThousandths) /
            kThousandths;
        preset.stiffnessNPerMm = std::max(preset.stiffnessNPerMm, 0.2);
    }
    return preset;
}

}  // namespace ui::presets
