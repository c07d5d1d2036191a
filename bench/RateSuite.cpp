// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <map>

#include "bench/ContactAverage.h"
#include "bench/Contestants.h"
#include "bench/Suites.h"
#include "core/terrain/Grid.h"
#include "lab/ContactScene.h"

namespace bench {
namespace {

constexpr std::array kRatesHz{250, 500, 1000, 2000, 4000};

/// Averages of a method, by rate.
using Averages = std::map<int, ContactAverage>;

QString figure(double um)
{
    return QString::number(um, 'f', um < 10.0 ? 1 : 0);
}

/// Returns a chart with the rate along x.
NamedChart chartOf(const QString& name, const QString& title, const ui::charts::Axis& y,
                   const std::vector<Averages>& averages, double (ContactAverage::*value)() const)
{
    ui::charts::Curve curves;
    curves.x = {QStringLiteral("rate of the servo (kHz)"), 0.22, 4.6};
    curves.x.base = 2.0;
    curves.y = y;
    curves.limits = {{kNoticedUm, false, QStringLiteral("just noticeable: 0.1 N at 2 N/mm")}};
    for (std::size_t k = 0; k < contactMethods().size(); ++k) {
        ui::charts::Line line = lineOf(contactMethods()[k]->text(), contactMethods()[k]->look);
        for (const auto& [rate, average] : averages[k])
            line.dots << pointAt(0.001 * rate, (average.*value)(), figure((average.*value)()));
        curves.lines << line;
    }
    return {name,
            {title,
             QStringLiteral("Planes at 0 to 75 degrees, fossa, cusp and V grooves, hand at 20 to 300 mm/s: mean of 13 "
                            "families, each counting the same.\nRound bur No. 2, grid 150 (cell 0.07 mm), without "
                            "cutting."),
             {},
             curves}};
}

}  // namespace

core::Result<Figures> rateSuite(const Context& context)
{
    Figures figures;
    std::vector<Averages> averages(contactMethods().size());
    const std::vector<std::string> names = lab::contactFamilyNames();
    int done = 0;
    for (const int rate : kRatesHz)
        for (const std::string& name : names) {
            context.progress(QStringLiteral("%1 Hz, %2").arg(rate).arg(QString::fromStdString(name)), done++,
                             static_cast<int>(names.size() * kRatesHz.size()));
            if (groundOf(name) != Ground::Smooth)
                continue;
            const lab::ContactFamily family =
                lab::contactFamily(name, {core::terrain::kDefaultGridSide, 0, static_cast<double>(rate)});
            for (std::size_t k = 0; k < contactMethods().size(); ++k)
                averages[k][rate].add(
                    lab::measureContact(family, contactMethods()[k]->settings.method, kChartStiffnessNPerMm));
        }
    for (std::size_t k = 0; k < contactMethods().size(); ++k)
        for (const auto& [hz, average] : averages[k]) {
            const int rate = hz;  // a binding cannot be captured with Clang
            const Contestant& method = *contactMethods()[k];
            const auto add = [&](const char* what, double value) {
                figures << Figure{
                    QStringLiteral("rate_%1_%2hz_%3_um").arg(method.key()).arg(rate).arg(QLatin1String(what)),
                    QStringLiteral("%1, %2 Hz: %3").arg(method.text()).arg(rate).arg(QLatin1String(what)),
                    value,
                    QStringLiteral("um"),
                    {}};
            };
            add("rms", average.rmsUm());
            add("lag", average.lagUm());
        }
    context.show(chartOf(QStringLiteral("rate-error"),
                         QStringLiteral("Error of the anchor against the rate of the servo: smooth ground"),
                         {QStringLiteral("error of the anchor, rms (um)"), 0.1, 1000.0, false, 10.0}, averages,
                         &ContactAverage::rmsUm));
    context.show(chartOf(
        QStringLiteral("rate-lag"), QStringLiteral("Lag of the anchor against the rate of the servo: smooth ground"),
        {QStringLiteral("behind on its way, mean (um)"), -12.0, 350.0}, averages, &ContactAverage::lagUm));
    return figures;
}

}  // namespace bench
