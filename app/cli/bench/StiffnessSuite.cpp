// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "app/cli/bench/InParallel.h"
#include "app/cli/bench/Suites.h"
#include "lab/StiffnessLimit.h"

namespace app::cli::bench {
namespace {

constexpr std::array<int, 4> kDelayMs{0, 1, 2, 4};
constexpr std::size_t kCellsOfOne = kDelayMs.size() * haptics::kHands.size();

QString latin(std::string_view text)
{
    return QString::fromLatin1(text.data(), static_cast<qsizetype>(text.size()));
}

struct Cell
{
    std::string_view method;
    haptics::HandFigures hand;
    int delayMs;
    double nPerMm = 0.0;
};

double limitOf(const Cell& cell)
{
    lab::ClosedLoop loop;
    loop.settings.method = cell.method;
    loop.hand = cell.hand;
    loop.falcon.delayS = cell.delayMs * 0.001;
    loop.falcon.delayJitterS = 0.0;
    return lab::stiffnessLimit(loop).value();  // nothing here is refused
}

}  // namespace

core::Result<Figures> stiffnessSuite(const Context& context)
{
    std::vector<Cell> cells;
    for (const std::string_view method : lab::contestants())
        for (const haptics::HandFigures& hand : haptics::kHands)
            for (const int delayMs : kDelayMs)
                cells.push_back({method, hand, delayMs});
    inParallel(
        cells.size(), [&](std::size_t k) { cells[k].nPerMm = limitOf(cells[k]); },
        [&](std::size_t done) { context.progress(QStringLiteral("%1 of %2 limits").arg(done).arg(cells.size())); });

    Figures figures;
    for (const Cell& cell : cells)
        figures << Figure{QStringLiteral("stiffness_%1_%2_%3ms_n_per_mm")
                              .arg(latin(cell.method).replace(u' ', u'_'), latin(cell.hand.name))
                              .arg(cell.delayMs),
                          QStringLiteral("largest, %1, %2 hand, delay %3 ms")
                              .arg(latin(cell.method), latin(cell.hand.name))
                              .arg(cell.delayMs),
                          cell.nPerMm,
                          QStringLiteral("N/mm"),
                          {}};
    for (std::size_t k = 0; k < kCellsOfOne; ++k) {
        const Cell& ours = cells[k];
        const Cell& old = cells[cells.size() - kCellsOfOne + k];
        if (!(old.nPerMm > 0.0) || old.nPerMm >= lab::kStiffestNPerMm)
            continue;
        figures << Figure{
            QStringLiteral("stiffness_ratio_%1_%2ms").arg(latin(ours.hand.name)).arg(ours.delayMs),
            QStringLiteral("ours to that of 2011, %1 hand, delay %2 ms").arg(latin(ours.hand.name)).arg(ours.delayMs),
            ours.nPerMm / old.nPerMm,
            {},
            QStringLiteral("2")};
    }
    return figures;
}

}  // namespace app::cli::bench
