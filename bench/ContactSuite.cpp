// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <map>

#include "bench/ContactAverage.h"
#include "bench/Contestants.h"
#include "bench/Suites.h"
#include "core/bur/Bur.h"
#include "core/terrain/Grid.h"
#include "lab/Block.h"
#include "lab/ContactScene.h"

namespace bench {
namespace {

constexpr std::array kSides{38, 75, 150, 300};

/// The charted averages of a method: by grid, then by ground.
using Averages = std::map<int, std::map<Ground, ContactAverage>>;

QString nameOf(Ground ground)
{
    return ground == Ground::Smooth ? QStringLiteral("ground") : QStringLiteral("walls");
}

bool isOurs(const Contestant& method)
{
    return method.settings.method == "continuous";
}

void addFamily(Figures& figures, const Contestant& method, const QString& bur, const lab::ContactFamily& family,
               const lab::ContactErrors& errors)
{
    const QString name = QString::fromStdString(family.name);
    const auto add = [&](const char* what, double value, const char* unit, double reach) {
        QString key = QStringLiteral("contact_%1_%2_%3_%4").arg(method.key(), bur, name, QLatin1String(what));
        figures << Figure{key.replace(u' ', u'_').replace(u'.', u'_'),
                          QStringLiteral("%1, bur %2, %3: %4").arg(method.text(), bur, name, QLatin1String(what)),
                          value, QLatin1String(unit),
                          isOurs(method) ? QStringLiteral("under %1").arg(reach) : QString()};
    };
    add("rms_um", errors.rmsUm, "um", family.reachRmsUm);
    add("most_um", errors.mostUm, "um", family.reachMostUm);
    add("jump_n", errors.jumpN, "N", family.reachJumpN);
    add("tick_us", errors.tickUs, "us", 5.0);
}

void addRidges(Figures& figures, const QString& bur, std::size_t index)
{
    for (const int cells : {1, 2})
        for (const Contestant* method : contactMethods())
            figures << Figure{
                QStringLiteral("contact_%1_%2_ridge_%3_holds_n").arg(method->key(), bur).arg(cells),
                QStringLiteral("%1, bur %2, ridge of %3 cells: holds").arg(method->text(), bur).arg(cells),
                lab::ridgeHoldsN(method->settings.method, cells, index, kChartStiffnessNPerMm), QStringLiteral("N"),
                isOurs(*method) ? QStringLiteral("at least 4") : QString()};
}

void addAverages(Figures& figures, const Contestant& method, const Averages& averages)
{
    for (const auto& [side, grounds] : averages)
        for (const auto& [ground, average] : grounds) {
            const QString key = QStringLiteral("contact_%1_%2_grid_%3_").arg(method.key(), nameOf(ground)).arg(side);
            const QString what = QStringLiteral("%1, %2, grid %3: ").arg(method.text(), nameOf(ground)).arg(side);
            figures << Figure{key + QStringLiteral("rms_um"),
                              what + QStringLiteral("rms"),
                              average.rmsUm(),
                              QStringLiteral("um"),
                              {}}
                    << Figure{key + QStringLiteral("p99_us"),
                              what + QStringLiteral("tick, p99"),
                              average.p99Us(),
                              QStringLiteral("us"),
                              {}};
        }
}

NamedChart chartOf(Ground ground, const std::vector<Averages>& averages)
{
    const bool smooth = ground == Ground::Smooth;
    ui::charts::Curve curves;
    curves.x = {QStringLiteral("thread CPU time of contact in a tick, 99th percentile (us)"), 1.0, 2000.0};
    curves.y = {QStringLiteral("error of the anchor, rms (um)"), smooth ? 0.1 : 1.0, smooth ? 1000.0 : 10'000.0};
    curves.x.base = curves.y.base = 10.0;
    curves.limits = {{kNoticedUm, false, QStringLiteral("just noticeable: 0.1 N at 2 N/mm")},
                     {1000.0, true, QStringLiteral("1 ms: the whole tick")}};
    for (std::size_t k = 0; k < contactMethods().size(); ++k) {
        ui::charts::Line line = lineOf(contactMethods()[k]->text(), contactMethods()[k]->look);
        for (const auto& [side, grounds] : averages[k])
            line.dots << pointAt(grounds.at(ground).p99Us(), grounds.at(ground).rmsUm(),
                                 QString::number(lab::kBlockExtentMm / side, 'g', 2));
        curves.lines << line;
    }
    const QString where =
        smooth ? QStringLiteral(
                     "Planes at 0 to 75 degrees, fossa, cusp and V grooves, hand at 20 to 300 mm/s: root mean square "
                     "of 13 families.")
               : QStringLiteral(
                     "Wall, pit corner and steps of 0.07, 0.2 and 0.5 mm, hand at 2 to 100 mm/s: root mean square over "
                     "5 families.");
    return {QStringLiteral("contact-") + nameOf(ground),
            {QStringLiteral("Error of the anchor against time a tick: ") +
                 (smooth ? QStringLiteral("smooth ground") : QStringLiteral("walls and steps")),
             where + QStringLiteral("\nRound bur No. 2, without cutting. Beside a marker: the cell of the grid, mm."),
             {},
             curves}};
}

}  // namespace

core::Result<Figures> contactSuite(const Context& context)
{
    Figures figures;
    std::vector<Averages> averages(contactMethods().size());
    const std::vector<std::string> names = lab::contactFamilyNames();
    const auto steps = static_cast<int>(names.size() * (kSides.size() + 1));
    int done = 0;
    const auto measure = [&](const QString& bur, std::size_t index, int side, bool isCharted) {
        for (const std::string& name : names) {
            context.progress(QStringLiteral("bur %1, grid %2, %3").arg(bur).arg(side).arg(QString::fromStdString(name)),
                             done++, steps);
            const lab::ContactFamily family = lab::contactFamily(name, {side, index});
            for (std::size_t k = 0; k < contactMethods().size(); ++k) {
                const Contestant& method = *contactMethods()[k];
                const lab::ContactErrors errors =
                    lab::measureContact(family, method.settings.method, kChartStiffnessNPerMm);
                if (side == core::terrain::kDefaultGridSide)
                    addFamily(figures, method, bur, family, errors);
                if (isCharted)
                    averages[k][side][groundOf(name)].add(errors);
            }
        }
    };
    for (const char* bur : {"2", "330"}) {
        const auto index = core::bur::findBur(bur);
        if (!index)
            return tl::unexpected(index.error());
        const bool isCharted = qstrcmp(bur, "2") == 0;
        for (const int side : kSides)
            if (isCharted || side == core::terrain::kDefaultGridSide)
                measure(QLatin1String(bur), *index, side, isCharted);
        addRidges(figures, QLatin1String(bur), *index);
    }
    for (std::size_t k = 0; k < contactMethods().size(); ++k)
        addAverages(figures, *contactMethods()[k], averages[k]);
    for (const Ground ground : {Ground::Smooth, Ground::Edged})
        context.show(chartOf(ground, averages));
    return figures;
}

}  // namespace bench
