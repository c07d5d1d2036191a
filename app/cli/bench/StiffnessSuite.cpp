// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/bench/Suites.h"
#include "lab/StiffnessLimit.h"

namespace app::cli::bench {

core::Result<Figures> stiffnessSuite(const Context& context)
{
    Figures figures;
    for (const char* method : {"continuous", "lattice", "penalty"}) {
        for (const haptics::HandFigures& hand : haptics::kHands) {
            const QLatin1String name(hand.name.data(), static_cast<qsizetype>(hand.name.size()));
            context.progress(QStringLiteral("%1, %2 hand").arg(QLatin1String(method), name));
            for (const int delayMs : {0, 1, 2, 4}) {
                lab::ClosedLoop loop;
                loop.settings.method = method;
                loop.hand = hand;
                loop.falcon.delayS = delayMs * 0.001;
                loop.falcon.delayJitterS = 0.0;
                const auto limit = lab::stiffnessLimit(loop);
                if (!limit)
                    return tl::unexpected(limit.error());
                figures << Figure{
                    QStringLiteral("stiffness_%1_%2_%3ms_n_per_mm").arg(QLatin1String(method), name).arg(delayMs),
                    QStringLiteral("largest, %1, %2 hand, delay %3 ms").arg(QLatin1String(method), name).arg(delayMs),
                    *limit,
                    QStringLiteral("N/mm"),
                    {}};
            }
        }
    }
    return figures;
}

}  // namespace app::cli::bench
