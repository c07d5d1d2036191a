// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/PresetTexts.h"

#include <algorithm>
#include <cmath>

#include <QCoreApplication>

#include "ui/text/Texts.h"
#include "ui/text/ValidationTexts.h"

namespace ui::text {
namespace {

struct Words
{
    Q_DECLARE_TR_FUNCTIONS(ui::text::PresetTexts)
};

constexpr int kHashShown = 8;

bool isRate(const QString& id)
{
    return id.endsWith(QLatin1String("rate_mm3_per_ns"));
}

}  // namespace

QString substanceName(core::settings::Substance substance)
{
    using core::settings::Substance;
    switch (substance) {
    case Substance::SoftCaries:
        return Words::tr("Soft caries");
    case Substance::FirmCaries:
        return Words::tr("Firm caries");
    case Substance::Enamel:
        return Words::tr("Enamel");
    case Substance::Dentin:
        return Words::tr("Dentin");
    case Substance::Pulp:
        return Words::tr("Pulp");
    case Substance::Plastic:
        break;
    }
    //: What the teeth of a typodont are made of
    return Words::tr("Plastic tooth");
}

QString feelFieldName(const char* id)
{
    const auto fields = core::settings::feelFields();
    for (std::size_t k = 0; k < 2 * core::settings::kSubstances; ++k)
        if (qstrcmp(fields[k].id, id) == 0) {
            const QString substance = substanceName(static_cast<core::settings::Substance>(k / 2));
            //: %1 is a material of a tooth
            return (k % 2 == 0 ? Words::tr("%1: rate") : Words::tr("%1: from")).arg(substance);
        }
    const QString name = QLatin1String(id);
    if (name == u"axial_share")
        return Words::tr("Share along the bur");
    if (name == u"flat_end_share")
        //: Of a bur whose end is flat, such as a pear or a fissure bur
        return Words::tr("Share of flat ends");
    if (name == u"full_load_n")
        //: The load on the bur beyond which it cuts no faster
        return Words::tr("Full load");
    if (name == u"force.stiffness_n_per_mm")
        return Words::tr("Stiffness");
    if (name == u"force.damping_ns_per_m")
        return Words::tr("Damping");
    if (name == u"force.fast_damping_ns_per_m")
        return Words::tr("Damping of fast motion");
    if (name == u"force.friction")
        return Words::tr("Friction");
    return Words::tr("Force limit");
}

QString fieldHelp(const char* id)
{
    const QString name = QLatin1String(id);
    if (isRate(name))
        return Words::tr("Volume that a newton beyond the threshold takes away in a second, pushing sideways.");
    if (name.endsWith(QLatin1String("threshold_n")))
        return Words::tr("A lighter touch leaves no mark.");
    if (name == u"axial_share")
        return Words::tr("What is left of the rate when the bur is pushed along its axis.");
    if (name == u"flat_end_share")
        return Words::tr("What a pear or a fissure bur has of the share along the bur. At 1 the end makes no "
                         "difference.");
    if (name == u"full_load_n")
        return Words::tr("A bur pressed harder cuts no faster. At 20 N there is no such limit.");
    if (name == u"force.stiffness_n_per_mm")
        return Words::tr("Of the spring between hand and bur: how hard a wall feels.");
    if (name == u"force.damping_ns_per_m")
        return Words::tr("What calms the hand at rest. Too much is felt as a buzz.");
    if (name == u"force.fast_damping_ns_per_m")
        return Words::tr("What calms a fast hand besides, as when the bur is thrown at the tooth.");
    if (name == u"force.friction")
        return Words::tr("Of the bur that slides on the tooth.");
    return Words::tr("The largest force that is ever given to the hand.");
}

QString rangeWords(const core::NumberField<core::settings::FeelPreset>& field)
{
    const auto plain = [](double value) { return text::number(value, value == std::floor(value) ? 0 : 2); };
    //: A range: %1 to %2, %3 is a unit
    return Words::tr("%1 to %2 %3")
        .arg(plain(field.minimum), plain(field.maximum), QString::fromUtf8(field.unit))
        .trimmed();
}

QString presetWords(const lessons::PresetUsed& used)
{
    //: %1 is the name of a hardness preset, %2 its version
    QString words =
        used.version > 0 ? Words::tr("%1, version %2").arg(used.name, QString::number(used.version)) : used.name;
    if (!used.hash.isEmpty())
        words += QStringLiteral(" (%1)").arg(used.hash.left(kHashShown));
    //: After the name of a hardness preset whose numbers were changed during the attempt
    return used.isChanged ? Words::tr("%1, changed by hand").arg(words) : words;
}

QString presetWords(const core::settings::FeelPreset& preset)
{
    return presetWords(lessons::PresetUsed{QString::fromStdString(preset.name), preset.version,
                                           QString::fromStdString(preset.hash).left(kHashShown), preset.hash.empty()});
}

QString boundWords(const core::settings::FeelPreset& preset)
{
    using Set = core::settings::StabilityBound::Set;
    const core::settings::LoopFigures loop;
    if (preset.clampN > loop.forceLimitN)
        return Words::tr("The force limit is %1 N, and the device gives at most %2 N: lower it.")
            .arg(text::number(preset.clampN, 1), text::number(loop.forceLimitN, 1));
    const core::settings::StabilityBound bound = core::settings::stabilityBound(preset);
    const QString most = text::number(std::floor(bound.stiffnessNPerMm * 100.0) / 100.0, 2);
    const QString delay = text::number(1000.0 * loop.delayS, 0);
    if (preset.stiffnessNPerMm <= bound.stiffnessNPerMm)
        return Words::tr("Holds: a light hand at %1 ms of delay is steady up to %2 N/mm, and this is %3.")
            .arg(delay, most, text::number(preset.stiffnessNPerMm, 2));
    const QString said =
        Words::tr("Would tremble: a light hand at %1 ms of delay is steady up to %2 N/mm, and this is %3.")
            .arg(delay, most, text::number(preset.stiffnessNPerMm, 2));
    return said + u' ' +
           (bound.set == Set::Damping ? Words::tr("Lower the stiffness, or damp more.")
                                      : Words::tr("Lower the stiffness."));
}

QString faultWords(const lessons::ReadPreset& read)
{
    if (read.beyondBound)
        return boundWords(*read.beyondBound);
    const auto grave = std::find_if(read.faults.begin(), read.faults.end(),
                                    [](const lessons::ValidationIssue& fault) { return fault.grave; });
    return text::faultWords(grave != read.faults.end() ? *grave : read.faults.front());
}

bool isHeld(const core::settings::FeelPreset& preset)
{
    return core::settings::checkStability(preset).has_value();
}

}  // namespace ui::text
