// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/Sweeps.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "bench/Contestants.h"
#include "core/bur/Bur.h"
#include "lab/Block.h"
#include "lab/SweepVolume.h"

namespace bench {
namespace {

constexpr std::array kSides{75, 150, 300, 600};
constexpr std::array kSweeps{lab::Sweep::Trench, lab::Sweep::Arc, lab::Sweep::Plunge};
constexpr double kReachPercent = 1.0;
constexpr LookIndex kMeanLook = 4;

QLatin1String latin(std::string_view text)
{
    return {text.data(), static_cast<qsizetype>(text.size())};
}

}  // namespace

void addSweeps(Figures& figures, const Context& context, int steps)
{
    const auto burs = core::bur::burs().first(core::bur::kCommonBurs);
    ui::charts::Curve chart;
    chart.x = {QStringLiteral("columns a side of the grid over 10.5 mm, and their cell"), -0.2, 3.2};
    for (const int side : kSides)
        chart.x.labels << QStringLiteral("%1: %2 mm").arg(side).arg(lab::kBlockExtentMm / side, 0, 'g', 2);
    chart.y = {QStringLiteral("volume removed, off closed form by (%)"), 0.001, 20.0};
    chart.y.base = 10.0;
    chart.limits = {{kReachPercent, false, QStringLiteral("asked for at grid 150, on the average")}};
    for (std::size_t bur = 0; bur < burs.size(); ++bur)
        chart.lines << lineOf(QStringLiteral("bur ") + latin(burs[bur].id), static_cast<LookIndex>(bur));
    ui::charts::Line mean = lineOf(QStringLiteral("mean of 32, any bur"), kMeanLook);
    const auto point = [](double x, double y) { return pointAt(x, y, QString::number(y, 'g', 2)); };
    int done = 0;
    for (const int side : kSides) {
        const auto place = static_cast<double>(chart.lines.front().dots.size());
        double farthestMean = 0.0;
        for (std::size_t bur = 0; bur < burs.size(); ++bur) {
            double worst = 0.0;
            for (const lab::Sweep sweep : kSweeps) {
                context.progress(
                    QStringLiteral("grid %1, bur %2, %3").arg(side).arg(latin(burs[bur].id), latin(lab::nameOf(sweep))),
                    done++, steps);
                const lab::SweepErrors errors = lab::measureSweep(sweep, side, bur);
                const auto add = [&](const char* what, double value, const char* unit, const QString& reach = {}) {
                    figures << Figure{QStringLiteral("cutting_%1_%2_grid_%3_%4")
                                          .arg(latin(lab::nameOf(sweep)), latin(burs[bur].id))
                                          .arg(side)
                                          .arg(QLatin1String(what)),
                                      QStringLiteral("%1, bur %2, grid %3: %4")
                                          .arg(latin(lab::nameOf(sweep)), latin(burs[bur].id))
                                          .arg(side)
                                          .arg(QLatin1String(what)),
                                      value, QLatin1String(unit), reach};
                };
                add("volume_percent", errors.volumePercent, "%", side == 150 ? QStringLiteral("within 1") : QString());
                add("worst_percent", errors.worstPercent, "%");
                add("depth_rms_um", errors.depthRmsUm, "um");
                worst = std::max(worst, errors.worstPercent);
                farthestMean = std::max(farthestMean, std::abs(errors.volumePercent));
            }
            chart.lines[static_cast<qsizetype>(bur)].dots << point(place, worst);
        }
        mean.dots << point(place, farthestMean);
    }
    chart.lines << mean;
    context.show(
        {QStringLiteral("cutting"),
         {QStringLiteral("Volume error of a cut against the grid"),
          QStringLiteral("Trench 3 mm long, half circle of 1.2 mm, plunge; 0.4 mm deep, in 32 lies of the lattice. "
                         "Bur: the worst single lie of\nthe worst of the three. Mean: the farthest off of any "
                         "bur's and sweep's averages over the lies."),
          {},
          chart}});
}

}  // namespace bench
