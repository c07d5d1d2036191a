// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>

#include "bench/Contestants.h"
#include "bench/InParallel.h"
#include "bench/Suites.h"
#include "lab/StiffnessLimit.h"

namespace bench {
namespace {

constexpr std::array<int, 4> kDelaysMs{0, 1, 2, 4};

/// Friction with which the pipeline of 2011 is stable at the highest stiffness in almost every cell. The price is a
/// tremble of 0.3 N rms in a hand that presses on a spring of 2 N/mm.
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
    return lab::stiffnessLimit(loop).value();  // none of them is refused
}

/// Adds the ratio of our loop's limit to that of 2011.
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

/// Returns the text in a cell of the chart.
QString noteOf(double nPerMm)
{
    if (nPerMm >= lab::kStiffestNPerMm)
        return QStringLiteral("%1+").arg(lab::kStiffestNPerMm);
    return QString::number(nPerMm, 'f', nPerMm < 9.95 ? 1 : 0);
}

/// Colour of a range of stiffness in the chart.
struct Shade
{
    double fromNPerMm;
    const char* colour;
};
constexpr std::array<Shade, 5> kShades{
    {{0.0, "#F5E6A3"}, {3.0, "#DDEDEA"}, {6.0, "#A9D3CD"}, {12.0, "#5AA39A"}, {24.0, "#1F6F68"}}};

NamedChart chartOf(const std::vector<Cell>& cells)
{
    ui::charts::Map map;
    map.columnTitle = QStringLiteral("delay, ms");
    for (const int delayMs : kDelaysMs)
        map.columns << QString::number(delayMs);
    for (const Contestant& one : contestants()) {
        map.rows << one.text();
        QList<ui::charts::Map::Cell> row;
        for (const Cell& cell : cells)
            if (cell.contestant == &one) {
                const auto above = std::find_if(kShades.begin(), kShades.end(),
                                                [&](const Shade& shade) { return shade.fromNPerMm > cell.nPerMm; });
                row << ui::charts::Map::Cell{QColor(QLatin1String(std::prev(above)->colour)), {}, noteOf(cell.nPerMm)};
                if (map.rows.size() == 1 && cell.delayMs == kDelaysMs.front())
                    map.groups << QStringLiteral("%1 hand").arg(cell.handName());
            }
        map.cells << row;
    }
    return {QStringLiteral("stiffness"),
            {QStringLiteral("K_max: the stiffest wall that comes to rest, N/mm"),
             QStringLiteral(
                 "Simulated Falcon at 1 kHz; the hand throws the bur at a flat tooth with 50 mm/s and leans on it "
                 "with 2 N; at rest: moves\nless than 0.15 mm in the last 0.5 s of 2 s. %2+: even the stiffest "
                 "that was tried. Shipped: %1 N/mm. Delay: from a sample to its force at the motor.")
                 .arg(core::contact::ForceSettings().stiffnessNPerMm)
                 .arg(lab::kStiffestNPerMm),
             {},
             map}};
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

}  // namespace bench
