// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "app/cli/bench/Suites.h"
#include "lab/Stability.h"

namespace app::cli::bench {
namespace {

constexpr std::array<double, 4> kStiffnessNPerMm{0.5, 1.0, 2.0, 3.0};
constexpr std::array<int, 4> kDelayMs{0, 1, 2, 4};

QLatin1String latin(std::string_view text)
{
    return {text.data(), static_cast<qsizetype>(text.size())};
}

}  // namespace

core::Result<Figures> stabilitySuite(const Context& context)
{
    Figures figures;
    for (const char* method : {"continuous", "lattice", "penalty"}) {
        for (const std::string_view scene : lab::stabilityScenes()) {
            context.progress(QStringLiteral("%1, %2").arg(QLatin1String(method), latin(scene)));
            for (const int delayMs : kDelayMs) {
                std::array<int, 6> outcomes{};
                for (const double stiffness : kStiffnessNPerMm) {
                    for (const haptics::HandFigures& hand : haptics::kHands) {
                        lab::StabilityTrial trial;
                        trial.settings.method = method;
                        trial.settings.force.stiffnessNPerMm = stiffness;
                        trial.falcon.delayS = delayMs * 0.001;
                        trial.falcon.delayJitterS = 0.0;
                        trial.hand = hand;
                        const auto result = lab::tryStability(scene, trial);
                        if (!result)
                            return tl::unexpected(result.error());
                        ++outcomes[static_cast<std::size_t>(result->outcome)];
                    }
                }
                QStringList found;
                for (std::size_t k = 1; k < outcomes.size(); ++k)
                    if (outcomes[k] > 0)
                        found << QStringLiteral("%1 %2")
                                     .arg(outcomes[k])
                                     .arg(latin(lab::nameOf(static_cast<lab::Outcome>(k))));
                figures << Figure{
                    QStringLiteral("stability_%1_%2_%3ms_holds").arg(QLatin1String(method), latin(scene)).arg(delayMs),
                    QStringLiteral("%1, %2, %3 ms: of 12 hold").arg(QLatin1String(method), latin(scene)).arg(delayMs),
                    static_cast<double>(outcomes[0]),
                    {},
                    found.join(QStringLiteral(", "))};
            }
        }
    }
    return figures;
}

}  // namespace app::cli::bench
