// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>

#include "app/cli/bench/Contestants.h"
#include "app/cli/bench/InParallel.h"
#include "app/cli/bench/Suites.h"
#include "lab/StiffnessLimit.h"

namespace app::cli::bench {
namespace {

constexpr std::array<int, 4> kDelaysMs{0, 1, 2, 4};

/// Friction of the pipeline of 2011 that holds the stiffest wall in about every cell, if nobody minds that it trembles
/// by 0.3 N rms in a hand that leans on 2 N/mm.
constexpr double kRoughNSPerM = 30.0;

/// Contestants, then hands, then delays: the order of the cells.
struct Cell
{
    const Contestant* contestant;
    const haptics::HandFigures* hand;
    int delayMs;
    lab::CedsFigures ceds;
    double nPerMm = 0.0;

    [[nodiscard]] QString handName() const
    {
        return QString::fromLatin1(hand->name.data(), static_cast<qsizetype>(hand->name.size()));
    }
};

double limitOf(const Cell& cell)
{
    lab::ClosedLoop loop;
    loop.settings = cell.contestant->settings;
    loop.hand = *cell.hand;
    loop.falcon.delayS = cell.delayMs * 0.001;
    loop.falcon.delayJitterS = 0.0;
    loop.ceds = cell.ceds;
    return lab::stiffnessLimit(loop).value();  // nothing here is refused
}

/// What our own loop holds beside that of 2011.
void addRatios(Figures& figures, const std::vector<Cell>& cells)
{
    for (const Cell& ours : cells) {
        if (ours.contestant != &contestants().front())
            continue;
        const auto old = std::find_if(cells.begin(), cells.end(), [&](const Cell& cell) {
            return cell.contestant->name == lab::kCeds2011 && cell.hand == ours.hand && cell.delayMs == ours.delayMs;
        });
        if (old == cells.end() || !(old->nPerMm > 0.0) || old->nPerMm >= lab::kStiffestNPerMm)
            continue;
        figures << Figure{
            QStringLiteral("stiffness_ratio_%1_%2ms").arg(ours.handName()).arg(ours.delayMs),
            QStringLiteral("ours to that of 2011, %1 hand, delay %2 ms").arg(ours.handName()).arg(ours.delayMs),
            ours.nPerMm / old->nPerMm,
            {},
            QStringLiteral("2")};
    }
}

/// Above a bar.
QString noteOf(double nPerMm)
{
    if (nPerMm >= lab::kStiffestNPerMm)
        return QStringLiteral("%1+").arg(lab::kStiffestNPerMm);
    return QString::number(nPerMm, 'f', nPerMm < 9.95 ? 1 : 0);
}

Chart chartOf(const std::vector<Cell>& cells)
{
    BarChart bars;
    bars.valueTitle = QStringLiteral("N/mm");
    bars.most = 1.2 * lab::kStiffestNPerMm;
    bars.interval = 10.0;
    bars.groupTitle = QStringLiteral("delay from a sample to its force at the motor (ms)");
    for (const int delayMs : kDelaysMs)
        bars.groups << QString::number(delayMs);
    for (const haptics::HandFigures& hand : haptics::kHands) {
        BarChart::Panel panel;
        for (const Contestant& one : contestants()) {
            BarChart::Bars method{one.text(), one.look, {}, {}};
            for (const Cell& cell : cells)
                if (cell.contestant == &one && cell.hand == &hand) {
                    panel.title = QStringLiteral("%1 hand").arg(cell.handName());
                    method.values << cell.nPerMm;
                    method.notes << noteOf(cell.nPerMm);
                }
            panel.bars << method;
        }
        bars.panels << panel;
    }
    return {QStringLiteral("stiffness"), QStringLiteral("K_max: the stiffest wall that comes to rest, N/mm"),
            QStringLiteral(
                "Simulated Falcon at 1 kHz; the hand throws the bur at a flat tooth with 50 mm/s and leans on it "
                "with 2 N; at rest: moves\nless than 0.15 mm in the last 0.5 s of 2 s. %2+: even the stiffest "
                "that was tried. Shipped: %1 N/mm.")
                .arg(core::contact::ForceSettings().stiffnessNPerMm)
                .arg(lab::kStiffestNPerMm),
            bars};
}

}  // namespace

core::Result<Figures> stiffnessSuite(const Context& context)
{
    std::vector<Cell> cells;
    for (const Contestant& one : contestants())
        for (const haptics::HandFigures& hand : haptics::kHands)
            for (const int delayMs : kDelaysMs)
                cells.push_back({&one, &hand, delayMs, {}});
    const std::size_t shown = cells.size();
    for (std::size_t k = 0; k < shown; ++k)
        if (cells[k].contestant->name == lab::kCeds2011) {
            cells.push_back(cells[k]);
            cells.back().ceds.frictionNSPerM = kRoughNSPerM;
        }
    inParallel(
        cells.size(), [&](std::size_t k) { cells[k].nPerMm = limitOf(cells[k]); },
        [&](std::size_t done) {
            const Cell& now = cells[std::min(done, cells.size() - 1)];
            context.progress(QStringLiteral("%1, %2 hand").arg(now.contestant->text(), now.handName()),
                             static_cast<int>(done), static_cast<int>(cells.size()));
        });
    const std::vector<Cell> rough(cells.begin() + static_cast<std::ptrdiff_t>(shown), cells.end());
    cells.resize(shown);

    Figures figures;
    for (const Cell& cell : cells)
        figures << Figure{QStringLiteral("stiffness_%1_%2_%3ms_n_per_mm")
                              .arg(cell.contestant->key(), cell.handName())
                              .arg(cell.delayMs),
                          QStringLiteral("largest, %1, %2 hand, delay %3 ms")
                              .arg(cell.contestant->text(), cell.handName())
                              .arg(cell.delayMs),
                          cell.nPerMm,
                          QStringLiteral("N/mm"),
                          {}};
    for (const Cell& cell : rough)
        figures << Figure{
            QStringLiteral("stiffness_rough_%1_%2_%3ms_n_per_mm")
                .arg(cell.contestant->key(), cell.handName())
                .arg(cell.delayMs),
            QStringLiteral("largest, %1 with a friction of %2 N s/m, which trembles, %3 hand, delay %4 ms")
                .arg(cell.contestant->text())
                .arg(kRoughNSPerM)
                .arg(cell.handName())
                .arg(cell.delayMs),
            cell.nPerMm,
            QStringLiteral("N/mm"),
            {}};
    addRatios(figures, cells);
    context.show(chartOf(cells));
    return figures;
}

}  // namespace app::cli::bench
