// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>

#include "app/cli/bench/Contestants.h"
#include "app/cli/bench/Suites.h"
#include "lab/Stability.h"

namespace app::cli::bench {
namespace {

constexpr std::array<double, 4> kStiffnessNPerMm{0.5, 1.0, 2.0, 3.0};
constexpr std::array<int, 4> kDelaysMs{0, 1, 2, 4};

/// How many trials ended how, [lab::Outcome].
using Tally = std::array<int, 6>;

QLatin1String latin(std::string_view text)
{
    return {text.data(), static_cast<qsizetype>(text.size())};
}

/// How the chart shows an outcome. From harmless to worst: the last that was found is a cell's.
struct Sign
{
    lab::Outcome outcome;
    const char* letter;
    const char* colour;
};
constexpr std::array<Sign, 6> kSigns{{
    {lab::Outcome::Holds, "h", "#DDEDEA"},
    {lab::Outcome::Buzzes, "b", "#F5E6A3"},
    {lab::Outcome::Sticks, "S", "#56B4E9"},
    {lab::Outcome::LimitCycle, "L", "#E69F00"},
    {lab::Outcome::Crosses, "X", "#8A3F73"},
    {lab::Outcome::Diverges, "D", "#A33A00"},
}};

MapChart::Cell cellOf(const Tally& tally)
{
    MapChart::Cell cell;
    int trials = 0;
    for (std::size_t k = 0; k < kSigns.size(); ++k) {
        const int found = tally[static_cast<std::size_t>(kSigns[k].outcome)];
        trials += found;
        if (found > 0)
            cell.finding = static_cast<int>(k);
    }
    cell.note = QStringLiteral("%1/%2").arg(tally[0]).arg(trials);
    return cell;
}

QString othersOf(const Tally& tally)
{
    QStringList found;
    for (std::size_t k = 1; k < tally.size(); ++k)
        if (tally[k] > 0)
            found << QStringLiteral("%1 %2").arg(tally[k]).arg(latin(lab::nameOf(static_cast<lab::Outcome>(k))));
    return found.join(QStringLiteral(", "));
}

MapChart emptyMap()
{
    MapChart map;
    for (const Sign& sign : kSigns)
        map.findings << MapChart::Finding{QLatin1String(sign.letter), QLatin1String(sign.colour),
                                          latin(lab::nameOf(sign.outcome))};
    for (const std::string_view scene : lab::stabilityScenes()) {
        map.rows << latin(scene);
        map.cells << QList<MapChart::Cell>();
    }
    for (const int delayMs : kDelaysMs)
        map.columns << QString::number(delayMs);
    map.columnTitle = QStringLiteral("delay, ms");
    return map;
}

/// The hands of all kinds try one stiffness.
core::Result<Tally> tryHands(const Contestant& one, std::string_view scene, int delayMs, double stiffnessNPerMm)
{
    Tally tally{};
    for (const haptics::HandFigures& hand : haptics::kHands) {
        lab::StabilityTrial trial;
        trial.settings = one.settings;
        trial.settings.force.stiffnessNPerMm = stiffnessNPerMm;
        trial.falcon.delayS = delayMs * 0.001;
        trial.falcon.delayJitterS = 0.0;
        trial.hand = hand;
        const auto result = lab::tryStability(scene, trial);
        if (!result)
            return tl::unexpected(result.error());
        ++tally[static_cast<std::size_t>(result->outcome)];
    }
    return tally;
}

}  // namespace

core::Result<Figures> stabilitySuite(const Context& context)
{
    Figures figures;
    MapChart map = emptyMap();
    const auto scenes = lab::stabilityScenes();
    int done = 0;
    for (const Contestant& one : contestants()) {
        map.groups << one.text();
        for (std::size_t row = 0; row < scenes.size(); ++row) {
            context.progress(QStringLiteral("%1, %2").arg(one.text(), latin(scenes[row])), done++,
                             static_cast<int>(contestants().size() * scenes.size()));
            for (const int delayMs : kDelaysMs) {
                Tally all{};
                for (const double stiffness : kStiffnessNPerMm) {
                    const auto tally = tryHands(one, scenes[row], delayMs, stiffness);
                    if (!tally)
                        return tl::unexpected(tally.error());
                    std::transform(all.begin(), all.end(), tally->begin(), all.begin(), std::plus());
                }
                const auto shipped = tryHands(one, scenes[row], delayMs, one.settings.force.stiffnessNPerMm);
                if (!shipped)
                    return tl::unexpected(shipped.error());
                map.cells[static_cast<qsizetype>(row)] << cellOf(*shipped);
                const auto add = [&](const char* key, const char* what, const Tally& tally) {
                    figures << Figure{QStringLiteral("stability_%1_%2_%3ms_%4")
                                          .arg(one.key(), latin(scenes[row]))
                                          .arg(delayMs)
                                          .arg(QLatin1String(key)),
                                      QStringLiteral("%1, %2, %3 ms: %4")
                                          .arg(one.text(), latin(scenes[row]))
                                          .arg(delayMs)
                                          .arg(QLatin1String(what)),
                                      static_cast<double>(tally[0]),
                                      {},
                                      othersOf(tally)};
                };
                add("holds", "of 12 hold", all);
                add("shipped_holds", "of 3 at the shipped stiffness", *shipped);
            }
        }
    }
    context.show(
        {QStringLiteral("stability"), QStringLiteral("Where loops fail: scene by method and delay"),
         QStringLiteral("Simulated Falcon at 1 kHz, spring of %1 N/mm; a light, a medium and a firm hand. In each "
                        "cell: the worst that became\nof a hand, and how many of the three come to rest or follow "
                        "the hand without a tremble that can be felt.")
             .arg(core::contact::ForceSettings().stiffnessNPerMm),
         map});
    return figures;
}

}  // namespace app::cli::bench
