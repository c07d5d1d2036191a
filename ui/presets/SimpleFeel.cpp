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

constexpr double kFarthest = 4.0;      ///< largest factor of a rate or a threshold
constexpr double kStiffest = 2.0;      ///< largest factor of the stiffness
constexpr double kWithinBound = 0.99;  ///< share of the stability limit
constexpr double kThousandths = 1000.0;

void scale(FeelPreset& preset, const Field& field, double factor)
{
    double& value = preset.*field.value;
    if (factor != 1.0)
        value = std::clamp(std::round(value * factor * kThousandths) / kThousandths, field.minimum, field.maximum);
}

int differing(const FeelPreset& a, const FeelPreset& b)
{
    const auto fields = core::settings::feelFields();
    return static_cast<int>(std::count_if(fields.begin(), fields.end(),
                                          [&](const Field& field) { return a.*field.value != b.*field.value; }));
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
        // A preset that exceeds the limit already is not made stiffer.
        preset.stiffnessNPerMm =
            std::round(std::min(wanted, std::max(most, std::min(wanted, base.stiffnessNPerMm))) * kThousandths) /
            kThousandths;
        preset.stiffnessNPerMm = std::max(preset.stiffnessNPerMm, 0.2);
    }
    if (differing(preset, base) > 0)
        preset.hash.clear();
    return preset;
}

std::optional<Dials> dialsFor(const FeelPreset& base, const FeelPreset& preset)
{
    // Each dial changes numbers of its own, so the dials can be found one after the other.
    Dials found{};
    for (double& dial : found) {
        double best = 0.0;
        int fewest = differing(turned(base, found), preset);
        for (int step = 1; step <= kDialSteps; ++step)
            for (const int side : {-1, 1}) {
                dial = static_cast<double>(side * step) / kDialSteps;
                if (const int left = differing(turned(base, found), preset); left < fewest) {
                    fewest = left;
                    best = dial;
                }
            }
        dial = best;
    }
    return differing(turned(base, found), preset) == 0 ? std::optional(found) : std::nullopt;
}

}  // namespace ui::presets
