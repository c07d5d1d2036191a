// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <map>

#include "app/cli/bench/InParallel.h"
#include "app/cli/bench/Suites.h"
#include "lab/Stability.h"

namespace app::cli::bench {
namespace {

constexpr std::array<double, 4> kStiffnessNPerMm{0.5, 1.0, 2.0, 3.0};
constexpr std::array<int, 4> kDelayMs{0, 1, 2, 4};
constexpr std::size_t kTrialsOfOne = kStiffnessNPerMm.size() * haptics::kHands.size();

QString latin(std::string_view text)
{
    return QString::fromLatin1(text.data(), static_cast<qsizetype>(text.size()));
}

/// "impact 50" -> "impact_50"
QString keyOf(std::string_view name)
{
    QString key = latin(name);
    key.remove(u',');
    key.replace(u' ', u'_');
    key.replace(u'.', u'_');
    return key;
}

struct Cell
{
    std::string_view method;
    std::string_view scene;
    int delayMs;
    std::array<lab::StabilityResult, kTrialsOfOne> results;
};

/// Nothing of this is refused.
void tryAll(Cell& cell)
{
    std::size_t n = 0;
    for (const double stiffness : kStiffnessNPerMm) {
        for (const haptics::HandFigures& hand : haptics::kHands) {
            lab::StabilityTrial trial;
            trial.settings.method = cell.method;
            trial.settings.force.stiffnessNPerMm = stiffness;
            trial.falcon.delayS = cell.delayMs * 0.001;
            trial.falcon.delayJitterS = 0.0;
            trial.hand = hand;
            // Where the path is given no hand counts.
            const bool again = cell.scene.starts_with("loops") && hand.name != haptics::kHands[0].name;
            cell.results[n] = again ? cell.results[n - 1] : lab::tryStability(cell.scene, trial).value();
            ++n;
        }
    }
}

/// "2 buzzes, 1 diverges; jump missed 3"
QString told(const Cell& cell)
{
    std::array<int, 6> outcomes{};
    std::map<std::string_view, int> misses;
    for (const lab::StabilityResult& result : cell.results) {
        ++outcomes[static_cast<std::size_t>(result.outcome)];
        if (!result.missed.empty())
            ++misses[result.missed];
    }
    QStringList found;
    for (std::size_t k = 1; k < outcomes.size(); ++k)
        if (outcomes[k] > 0)
            found << QStringLiteral("%1 %2").arg(outcomes[k]).arg(latin(lab::nameOf(static_cast<lab::Outcome>(k))));
    QStringList missed;
    for (const auto& [name, count] : misses)
        missed << QStringLiteral("%1 over the bar %2").arg(latin(name)).arg(count);
    QString text = found.join(QStringLiteral(", "));
    if (!missed.isEmpty())
        text += (text.isEmpty() ? QString() : QStringLiteral("; ")) + missed.join(QStringLiteral(", "));
    return text;
}

}  // namespace

core::Result<Figures> stabilitySuite(const Context& context)
{
    std::vector<Cell> cells;
    for (const std::string_view method : lab::contestants())
        for (const std::string_view scene : lab::stabilityScenes())
            for (const int delayMs : kDelayMs)
                cells.push_back({method, scene, delayMs, {}});
    std::size_t told50ths = 0;
    inParallel(
        cells.size(), [&](std::size_t k) { tryAll(cells[k]); },
        [&](std::size_t done) {
            if (done * 50 / cells.size() == told50ths)
                return;
            told50ths = done * 50 / cells.size();
            context.progress(
                QStringLiteral("%1 of %2 trials").arg(done * kTrialsOfOne).arg(cells.size() * kTrialsOfOne));
        });

    Figures figures;
    for (const Cell& cell : cells) {
        const auto holds = std::count_if(cell.results.begin(), cell.results.end(),
                                         [](const auto& result) { return result.outcome == lab::Outcome::Holds; });
        figures << Figure{
            QStringLiteral("stability_%1_%2_%3ms_holds").arg(keyOf(cell.method), keyOf(cell.scene)).arg(cell.delayMs),
            QStringLiteral("%1, %2, %3 ms: of 12 hold").arg(latin(cell.method), latin(cell.scene)).arg(cell.delayMs),
            static_cast<double>(holds),
            {},
            told(cell)};
    }
    return figures;
}

}  // namespace app::cli::bench
