// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/console/ParameterWords.h"

#include <algorithm>
#include <cmath>

#include <QCoreApplication>
#include <QLocale>

namespace ui::console {
namespace {

constexpr double kWholeFrom = 1000.0;

struct Words
{
    Q_DECLARE_TR_FUNCTIONS(ui::console::Words)
};

QString withUnit(const QString& number, const core::settings::Parameter& parameter)
{
    return parameter.unit.empty() ? number : number + u' ' + QString::fromStdString(parameter.unit);
}

/// Returns a number in the format of the window's language without group separators, so that it can be typed again.
QString written(double value, char format, int digits)
{
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    return locale.toString(value, format, digits);
}

/// Returns a number without trailing zeros.
QString plain(double value)
{
    return written(value, 'g', 6);
}

}  // namespace

QString valueWords(const core::settings::Parameter& parameter, double value)
{
    if (!std::isfinite(value))
        return QStringLiteral("–");
    if (parameter.isSwitch)
        return value != 0.0 ? Words::tr("on") : Words::tr("off");
    if (!parameter.isLive())
        return withUnit(plain(value), parameter);
    // Shows few digits, because the value changes all the time. Large numbers, as the 320,000 rpm of a turbine, are not
    // written as a power of ten.
    return withUnit(std::abs(value) < kWholeFrom ? written(value, 'g', 4) : written(value, 'f', 0), parameter);
}

QString rangeWords(const core::settings::Parameter& parameter)
{
    if (parameter.isLive())
        return Words::tr("a live value, to be read, watched or plotted");
    if (parameter.isSwitch)
        return Words::tr("0 (off) or 1 (on)");
    //: %1 and %2 are numbers, %2 with a unit
    return Words::tr("%1 to %2").arg(plain(parameter.minimum), withUnit(plain(parameter.maximum), parameter));
}

QString answerWords(const core::settings::SetAnswer& answer, const QString& name,
                    const core::settings::Parameter* parameter)
{
    using Outcome = core::settings::SetAnswer::Outcome;
    switch (answer.outcome) {
    case Outcome::Done:
        return {};
    case Outcome::Unknown:
        return Words::tr("There is no parameter \"%1\". Type \"list\" for those there are.").arg(name);
    case Outcome::ReadOnly:
        return Words::tr("%1 is a live value: it can be watched and plotted, not set.").arg(name);
    case Outcome::NotANumber:
    case Outcome::OutOfRange:
        break;
    case Outcome::Refused:
        return QString::fromStdString(answer.why);
    }
    return Words::tr("%1 takes %2.").arg(name, parameter != nullptr ? rangeWords(*parameter) : QString());
}

QString withheldWords(const core::settings::Parameter& parameter)
{
    return parameter.withheld ? QString::fromStdString(parameter.withheld()) : QString();
}

bool isFeelVeiled(const core::settings::Parameters& parameters)
{
    const auto felt = parameters.beginningWith("force.");
    return std::any_of(felt.begin(), felt.end(), [](const auto* one) { return !withheldWords(*one).isEmpty(); });
}

QString blindWords()
{
    return Words::tr("A blind comparison of two presets is running, so their values are hidden. \"End the comparison\" "
                     "beside the tooth ends it.");
}

QString groupName(const QString& group)
{
    if (group == u"hardness")
        return Words::tr("Hardness");
    if (group == u"force")
        return Words::tr("Force");
    if (group == u"view")
        return Words::tr("View");
    if (group == u"hand")
        return Words::tr("Mouse and keys");
    return Words::tr("Live values");
}

}  // namespace ui::console
