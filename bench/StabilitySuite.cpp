// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <numeric>

#include "bench/Contestants.h"
#include "bench/InParallel.h"
#include "bench/Suites.h"
#include "lab/Stability.h"

namespace bench {
namespace {

/// The third is the shipped stiffness: the chart shows only that one.
const std::array<double, 4> kStiffnessNPerMm{0.5, 1.0, core::contact::ForceSettings().stiffnessNPerMm, 3.0};
constexpr std::size_t kShipped = 2;
constexpr std::array<int, 4> kDelaysMs{0, 1, 2, 4};

/// Number of trials by their outcome, [lab::Outcome].
using Tally = std::array<int, 6>;

QString latin(std::string_view text)
{
    return QString::fromLatin1(text.data(), static_cast<qsizetype>(text.size()));
}

/// Returns the key: "impact 50" -> "impact_50".
QString keyOf(std::string_view scene)
{
    return latin(scene).remove(u',').replace(u' ', u'_').replace(u'.', u'_');
}

/// Returns the row of the chart: "impact 50", "impact 200" -> "impact".
QString familyOf(std::string_view scene)
{
    return latin(scene.substr(0, scene.find_first_of(",0123456789"))).trimmed();
}

/// One scene, contestant and delay, with every stiffness and hand.
struct Trials
{
    const Contestant* contestant;
    std::string_view scene;
    int delayMs;
    std::array<std::array<lab::StabilityResult, haptics::kHands.size()>, kStiffnessNPerMm.size()> results;
};

void tryAll(Trials& trials)
{
    for (std::size_t k = 0; k < kStiffnessNPerMm.size(); ++k)
        for (std::size_t hand = 0; hand < haptics::kHands.size(); ++hand) {
            lab::StabilityTrial trial;
            trial.settings = trials.contestant->settings;
            trial.settings.force.stiffnessNPerMm = kStiffnessNPerMm[k];
            trial.falcon.delayS = trials.delayMs * 0.001;
            trial.falcon.delayJitterS = 0.0;
            trial.hand = haptics::kHands[hand];
            // On a given path the hand has no effect.
            const bool isAgain = hand > 0 && trials.scene.starts_with("loops");
            trials.results[k][hand] =
                isAgain ? trials.results[k][0] : lab::tryStability(trials.scene, trial).value();  // none of them is
                                                                                                  // refused
        }
}

Tally tallyOf(const Trials& trials, std::size_t stiffness)
{
    Tally tally{};
    for (const lab::StabilityResult& result : trials.results[stiffness])
        ++tally[static_cast<std::size_t>(result.outcome)];
    return tally;
}

void add(Tally& sum, const Tally& other)
{
    std::transform(sum.begin(), sum.end(), other.begin(), sum.begin(), std::plus());
}

/// Returns "2 buzzes, 1 diverges; jump over the bar 3".
QString told(const Trials& trials, const Tally& tally)
{
    QStringList found;
    for (std::size_t k = 1; k < tally.size(); ++k)
        if (tally[k] > 0)
            found << QStringLiteral("%1 %2").arg(tally[k]).arg(latin(lab::nameOf(static_cast<lab::Outcome>(k))));
    std::map<std::string_view, int> misses;
    for (const auto& hands : trials.results)
        for (const lab::StabilityResult& result : hands)
            if (!result.missed.empty())
                ++misses[result.missed];
    QStringList missed;
    for (const auto& [name, count] : misses)
        missed << QStringLiteral("%1 over the bar %2").arg(latin(name)).arg(count);
    QString text = found.join(QStringLiteral(", "));
    if (!missed.isEmpty())
        text += (text.isEmpty() ? QString() : QStringLiteral("; ")) + missed.join(QStringLiteral(", "));
    return text;
}

/// Sign of an outcome in the chart, from harmless to worst: a cell shows the worst outcome found.
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

const Sign& worstOf(const Tally& tally)
{
    const Sign* worst = &kSigns.front();
    for (const Sign& sign : kSigns)
        if (tally[static_cast<std::size_t>(sign.outcome)] > 0)
            worst = &sign;
    return *worst;
}

ui::charts::Map::Cell cellOf(const Tally& tally)
{
    const Sign& worst = worstOf(tally);
    const int trials = std::accumulate(tally.begin(), tally.end(), 0);
    return {QColor(QLatin1String(worst.colour)), QLatin1String(worst.letter),
            tally[0] < trials ? QStringLiteral("%1/%2").arg(tally[0]).arg(trials) : QString()};
}

NamedChart chartOf(const std::vector<Trials>& all)
{
    ui::charts::Map map;
    QStringList signs;
    for (const Sign& sign : kSigns)
        signs << QStringLiteral("%1 %2").arg(QLatin1String(sign.letter), latin(lab::nameOf(sign.outcome)));
    for (const Contestant& one : contestants())
        map.groups << one.text();
    for (const int delayMs : kDelaysMs)
        map.columns << QString::number(delayMs);
    map.columnTitle = QStringLiteral("delay, ms");
    // [row][column], in the order of the trials.
    std::vector<std::vector<Tally>> tallies;
    for (const Trials& trials : all) {
        const QString family = familyOf(trials.scene);
        if (!map.rows.contains(family)) {
            map.rows << family;
            tallies.emplace_back(static_cast<std::size_t>(map.groups.size() * map.columns.size()));
        }
        const auto row = static_cast<std::size_t>(map.rows.indexOf(family));
        const auto group = static_cast<std::size_t>(trials.contestant - contestants().data());
        const auto column =
            static_cast<std::size_t>(std::find(kDelaysMs.begin(), kDelaysMs.end(), trials.delayMs) - kDelaysMs.begin());
        add(tallies[row][group * kDelaysMs.size() + column], tallyOf(trials, kShipped));
    }
    for (const std::vector<Tally>& row : tallies) {
        QList<ui::charts::Map::Cell> cells;
        for (const Tally& tally : row)
            cells << cellOf(tally);
        map.cells << cells;
    }
    return {
        QStringLiteral("stability"),
        {QStringLiteral("Where loops fail: scene by method and delay"),
         QStringLiteral(
             "Simulated Falcon at 1 kHz, spring of %1 N/mm; a light, a medium and a firm hand, all variants of "
             "a scene. In a cell: the worst\nthat became of a trial, and unless it is all, how many come to rest or "
             "follow the hand without a tremble that can be felt.\n%2.")
             .arg(kStiffnessNPerMm[kShipped])
             .arg(signs.join(QStringLiteral(", "))),
         {},
         map}};
}

}  // namespace

core::Result<Figures> stabilitySuite(const Context& context)
{
    std::vector<Trials> all;
    for (const Contestant& one : contestants())
        for (const std::string_view scene : lab::stabilityScenes())
            for (const int delayMs : kDelaysMs)
                all.push_back({&one, scene, delayMs, {}});
    inParallel(
        all.size(), [&](std::size_t k) { tryAll(all[k]); },
        [&](std::size_t done) {
            const Trials& now = all[std::min(done, all.size() - 1)];
            context.progress(now.contestant->text() + QStringLiteral(", ") + latin(now.scene), static_cast<int>(done),
                             static_cast<int>(all.size()));
        });

    Figures figures;
    for (const Trials& trials : all) {
        Tally every{};
        for (std::size_t k = 0; k < kStiffnessNPerMm.size(); ++k)
            add(every, tallyOf(trials, k));
        const Tally shipped = tallyOf(trials, kShipped);
        const QString key = QStringLiteral("stability_%1_%2_%3ms_")
                                .arg(trials.contestant->key(), keyOf(trials.scene))
                                .arg(trials.delayMs);
        const QString what =
            QStringLiteral("%1, %2, %3 ms: ").arg(trials.contestant->text(), latin(trials.scene)).arg(trials.delayMs);
        figures << Figure{key + QStringLiteral("holds"), what + QStringLiteral("of 12 hold"),
                          static_cast<double>(every[0]), QString(), told(trials, every)}
                << Figure{key + QStringLiteral("shipped_holds"), what + QStringLiteral("of 3 at the shipped spring"),
                          static_cast<double>(shipped[0]), QString(), latin(lab::nameOf(worstOf(shipped).outcome))};
    }
    context.show(chartOf(all));
    return figures;
}

}  // namespace bench
