// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "app/cli/bench/Contestants.h"
#include "app/cli/bench/Suites.h"
#include "lab/StiffnessLimit.h"

namespace app::cli::bench {
namespace {

constexpr std::array kDelaysMs{0, 1, 2, 4};

QLatin1String nameOf(const haptics::HandFigures& hand)
{
    return {hand.name.data(), static_cast<qsizetype>(hand.name.size())};
}

/// Above a bar.
QString noteOf(double nPerMm)
{
    if (nPerMm >= lab::kStiffestNPerMm)
        return QStringLiteral("20+");
    return QString::number(nPerMm, 'f', nPerMm < 9.95 ? 1 : 0);
}

}  // namespace

core::Result<Figures> stiffnessSuite(const Context& context)
{
    Figures figures;
    BarChart bars;
    bars.valueTitle = QStringLiteral("N/mm");
    bars.most = 1.2 * lab::kStiffestNPerMm;
    bars.interval = 5.0;
    bars.groupTitle = QStringLiteral("delay from a sample to its force at the motor (ms)");
    for (const int delayMs : kDelaysMs)
        bars.groups << QString::number(delayMs);
    int done = 0;
    for (const haptics::HandFigures& hand : haptics::kHands) {
        const QLatin1String name = nameOf(hand);
        BarChart::Panel panel{QStringLiteral("%1 hand").arg(name), {}};
        for (const Contestant& one : contestants()) {
            context.progress(QStringLiteral("%1, %2 hand").arg(one.text(), name), done++,
                             static_cast<int>(haptics::kHands.size() * contestants().size()));
            BarChart::Bars method{one.text(), one.look, {}, {}};
            for (const int delayMs : kDelaysMs) {
                lab::ClosedLoop loop;
                loop.settings = one.settings;
                loop.hand = hand;
                loop.falcon.delayS = delayMs * 0.001;
                loop.falcon.delayJitterS = 0.0;
                const auto limit = lab::stiffnessLimit(loop);
                if (!limit)
                    return tl::unexpected(limit.error());
                figures << Figure{
                    QStringLiteral("stiffness_%1_%2_%3ms_n_per_mm").arg(one.key(), name).arg(delayMs),
                    QStringLiteral("largest, %1, %2 hand, delay %3 ms").arg(one.text(), name).arg(delayMs),
                    *limit,
                    QStringLiteral("N/mm"),
                    {}};
                method.values << *limit;
                method.notes << noteOf(*limit);
            }
            panel.bars << method;
        }
        bars.panels << panel;
    }
    context.show(
        {QStringLiteral("stiffness"), QStringLiteral("K_max: the stiffest wall that comes to rest, N/mm"),
         QStringLiteral("Simulated Falcon at 1 kHz; the hand throws the bur at a flat tooth with 50 mm/s and leans "
                        "on it with 2 N; at rest: moves\nless than 0.15 mm in the last 0.5 s of 2 s. 20+: even "
                        "the stiffest that was tried. Shipped: %1 N/mm.")
             .arg(core::contact::ForceSettings().stiffnessNPerMm),
         bars});
    return figures;
}

}  // namespace app::cli::bench
