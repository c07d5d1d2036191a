// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/console/Registration.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include <QCoreApplication>

#include "core/settings/StabilityBound.h"
#include "ui/console/ParameterWords.h"
#include "ui/kit/Actions.h"
#include "ui/presets/BlindTrial.h"
#include "ui/text/PresetTexts.h"
#include "ui/tooth/PointerControl.h"

namespace ui::console {
namespace {

using core::settings::FeelPreset;
using core::settings::Parameter;
using core::settings::Parameters;

struct RegistrationWords
{
    Q_DECLARE_TR_FUNCTIONS(ui::console::Words)
};

/// Returns the name that users type for a field. The field's id ends with its unit, which the name omits.
std::string nameOf(const core::NumberField<FeelPreset>& field)
{
    QString name = QLatin1String(field.id);
    for (const char* unit : {"_mm3_per_ns", "_n_per_mm", "_ns_per_m", "_n"})
        if (name.endsWith(QLatin1String(unit))) {
            name.chop(static_cast<qsizetype>(qstrlen(unit)));
            break;
        }
    return (name.startsWith(QLatin1String("force.")) ? name : QStringLiteral("hardness.") + name).toStdString();
}

}  // namespace

void PeriodMeter::take(const core::servo::ServoState& state)
{
    std::vector<std::int64_t> taken;
    for (const core::servo::Pose& pose : state.trail)
        if (pose.takenNs > 0)
            taken.push_back(pose.takenNs);
    std::sort(taken.begin(), taken.end());
    for (std::size_t k = 1; k < taken.size(); ++k) {
        if (taken[k] <= m_newestNs)
            continue;
        const std::int64_t period = taken[k] - taken[k - 1];
        m_periodsNs[m_next] =
            static_cast<std::int32_t>(std::min<std::int64_t>(period, std::numeric_limits<std::int32_t>::max()));
        m_next = (m_next + 1) % kPeriods;
        m_count = std::min(m_count + 1, kPeriods);
    }
    if (!taken.empty())
        m_newestNs = std::max(m_newestNs, taken.back());
}

double PeriodMeter::percentileUs(double share) const
{
    if (m_count == 0)
        return std::numeric_limits<double>::quiet_NaN();
    std::vector<std::int32_t> sorted(m_periodsNs.begin(), m_periodsNs.begin() + static_cast<std::ptrdiff_t>(m_count));
    const auto at = sorted.begin() + std::lround(share * static_cast<double>(m_count - 1));
    std::nth_element(sorted.begin(), at, sorted.end());
    return 0.001 * static_cast<double>(*at);
}

void registerFeel(Parameters& parameters, const std::function<FeelPreset()>& now,
                  const std::function<FeelPreset()>& initial, const std::function<std::string(const FeelPreset&)>& feel)
{
    for (const auto& field : core::settings::feelFields()) {
        Parameter parameter;
        parameter.name = nameOf(field);
        parameter.unit = field.unit;
        parameter.minimum = field.minimum;
        parameter.maximum = field.maximum;
        parameter.read = [now, value = field.value] {
            const FeelPreset preset = now();
            return presets::isVeiled(preset) ? std::numeric_limits<double>::quiet_NaN() : preset.*value;
        };
        parameter.initial = [initial, value = field.value] { return initial().*value; };
        parameter.write = [now, feel, value = field.value](double number) -> std::string {
            FeelPreset next = now();
            if (presets::isVeiled(next))  // does not reveal whether the value is the current one or within the limits
                return blindWords().toStdString();
            if (next.*value == number)
                return {};
            next.*value = number;
            next.hash.clear();  // the numbers differ from those of the saved version
            if (!core::settings::checkStability(next))
                return text::boundWords(next).toStdString();
            return feel(next);
        };
        parameter.label = [id = field.id] { return text::feelFieldName(id).toStdString(); };
        parameter.help = [id = field.id] { return text::fieldHelp(id).toStdString(); };
        parameter.withheld = [now] { return presets::isVeiled(now()) ? blindWords().toStdString() : std::string(); };
        parameters.add(std::move(parameter));
    }
}

void registerSwitch(Parameters& parameters, const char* name, QAction* action, bool initially)
{
    Parameter parameter;
    parameter.name = name;
    parameter.isSwitch = true;
    parameter.read = [action] { return action->isChecked() ? 1.0 : 0.0; };
    parameter.initial = [initially] { return initially ? 1.0 : 0.0; };
    parameter.write = [action](double on) -> std::string {
        if (action->isChecked() == (on != 0.0))
            return {};
        if (!action->isEnabled())
            return RegistrationWords::tr("This cannot be changed here and now.").toStdString();
        action->trigger();
        return {};
    };
    parameter.label = [action] { return action->text().toStdString(); };
    parameter.help = [action] { return action->statusTip().toStdString(); };
    parameters.add(std::move(parameter));
}

void registerHand(Parameters& parameters, const tooth::PointerControl& hand,
                  const std::function<void(double mmPerS)>& setFeed, const std::function<void(double newtons)>& setPush)
{
    using tooth::PointerControl;
    const auto written = [](const std::function<void(double)>& set) {
        return [set](double value) {
            set(value);
            return std::string();
        };
    };
    parameters.add(
        {"hand.feed", "mm/s", PointerControl::kSlowestMmPerS, PointerControl::kFastestMmPerS, false,
         [&hand] { return hand.feedMmPerS(); }, [] { return PointerControl::kFirstMmPerS; }, written(setFeed),
         [] { return RegistrationWords::tr("Feed").toStdString(); },
         [] { return RegistrationWords::tr("How fast the bur goes down at most while you press.").toStdString(); }});
    parameters.add(
        {"hand.push", "N", PointerControl::kWeakestN, PointerControl::kStrongestN, false,
         [&hand] { return hand.forceN(); }, [] { return PointerControl::kFirstN; }, written(setPush),
         [] { return RegistrationWords::tr("Push").toStdString(); },
         [] {
             return RegistrationWords::tr("How hard the mouse button presses the bur against the tooth.").toStdString();
         }});
}

void registerLive(Parameters& parameters, const std::function<core::servo::ServoState()>& servo,
                  const PeriodMeter& meter, const std::function<Told()>& told)
{
    const auto add = [&](const char* name, const char* unit, const std::function<double()>& read,
                         const std::function<QString()>& help, bool Told::*which = nullptr) {
        Parameter parameter;
        parameter.name = name;
        parameter.unit = unit;
        parameter.read = read;
        parameter.label = [help] { return help().toStdString(); };
        parameter.help = parameter.label;
        if (which != nullptr) {
            parameter.read = [read, told, which] {
                return told().*which ? read() : std::numeric_limits<double>::quiet_NaN();
            };
            parameter.withheld = [told, which] {
                return told().*which ? std::string() : kit::Actions::tr("This lesson does not allow it.").toStdString();
            };
        }
        parameters.add(std::move(parameter));
    };
    add(
        "live.force", "N", [servo] { return glm::length(servo().forceN); },
        [] { return RegistrationWords::tr("Force that the hand is given."); });
    add(
        "live.depth", "mm",
        [servo] {
            const core::servo::ServoState state = servo();
            return state.hasDepth ? state.depthMm : std::numeric_limits<double>::quiet_NaN();
        },
        [] { return RegistrationWords::tr("Depth of the bur's tip below the uncut surface."); }, &Told::depth);
    add(
        "live.removed", "mm³",
        [servo] {
            double sum = 0.0;
            for (const double volume : servo().removedMm3)
                sum += volume;
            return sum;
        },
        [] { return RegistrationWords::tr("Volume removed since the tooth was taken, undone or not."); },
        &Told::removed);
    add(
        "live.rpm", "rpm", [servo] { return servo().burRpm; },
        [] { return RegistrationWords::tr("Turns of the bur under its load."); });
    add(
        "live.missed", "", [servo] { return static_cast<double>(servo().missedPeriods); },
        [] { return RegistrationWords::tr("Periods of the servo that were missed since the start."); });
    add(
        "live.period_p50", "µs", [&meter] { return meter.percentileUs(0.5); },
        [] {
            return RegistrationWords::tr(
                "Time between two ticks of the servo: half of the last second's were shorter.");
        });
    add(
        "live.period_p99", "µs", [&meter] { return meter.percentileUs(0.99); },
        [] {
            return RegistrationWords::tr(
                "Time between two ticks of the servo: 99 in 100 of the last second's were shorter.");
        });
}

}  // namespace ui::console
