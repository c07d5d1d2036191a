// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <utility>

#include "bench/Suites.h"
#include "bench/Sweeps.h"
#include "core/bur/Bur.h"
#include "lab/CuttingTrials.h"

namespace bench {
namespace {

/// Spread of the volumes of some trials: largest over smallest, minus one, per cent.
class Spread
{
public:
    void add(const lab::PaceTrial& trial)
    {
        const double volume = lab::removedMm3(trial);
        m_least = std::min(m_least, volume);
        m_most = std::max(m_most, volume);
    }
    [[nodiscard]] double percent() const { return 100.0 * (m_most / m_least - 1.0); }

private:
    double m_least = 1.0e9;
    double m_most = 0.0;
};

constexpr std::array kFeeds{std::pair("sideways", 0.0), std::pair("aslant", 45.0), std::pair("down", 90.0)};
constexpr std::array kFeeders{std::pair("speed", lab::Feeder::Speed), std::pair("force", lab::Feeder::Force)};
constexpr int kSteps = kSweepSteps + static_cast<int>(kFeeds.size()) + static_cast<int>(kFeeders.size());

void addPace(Figures& figures, const Context& context)
{
    const QString reach = QStringLiteral("under 3");
    int done = kSweepSteps;
    for (const auto& [key, down] : kFeeds) {
        const QString name = QLatin1String(key);
        context.progress(QStringLiteral("pace, ") + name, done++, kSteps);
        const auto add = [&](const char* over, const Spread& spread) {
            figures << Figure{QStringLiteral("cutting_pace_%1_%2_percent").arg(name, QLatin1String(over)),
                              QStringLiteral("pace %1, spread over %2").arg(name, QLatin1String(over)),
                              spread.percent(), QStringLiteral("%"), reach};
        };
        lab::PaceTrial trial;
        trial.towards = lab::feed(20.0, down);
        Spread grids;
        for (const int side : {100, 150, 300, 600}) {
            lab::PaceTrial other = trial;
            other.side = side;
            grids.add(other);
        }
        add("grids", grids);
        Spread rates;
        for (const double rate : {500.0, 1000.0, 2000.0, 4000.0}) {
            lab::PaceTrial other = trial;
            other.rateHz = rate;
            rates.add(other);
        }
        add("rates", rates);
        if (down == 90.0)
            continue;
        Spread headings;
        for (int heading = 0; heading < 360; heading += 15) {
            trial.towards = lab::feed(heading, down);
            headings.add(trial);
        }
        add("headings", headings);
    }
}

void addRates(Figures& figures)
{
    struct Tissue
    {
        const char* name;
        core::terrain::Material material;
        const char* reach;
    };
    for (const Tissue& tissue : {Tissue{"enamel", core::terrain::Material::Enamel, "0.3 to 0.6"},
                                 Tissue{"dentin", core::terrain::Material::Dentin, "1 to 2"},
                                 Tissue{"caries", core::terrain::Material::Caries, "3 to 6"}}) {
        lab::PaceTrial trial;
        trial.material = tissue.material;
        trial.towards = lab::feed(20.0, 0.0);
        trial.seconds = 0.5;
        figures << Figure{QStringLiteral("cutting_rate_%1_mm3_per_s").arg(QLatin1String(tissue.name)),
                          QStringLiteral("%1, 330 sideways with 1 N").arg(QLatin1String(tissue.name)),
                          lab::removedMm3(trial) / trial.seconds, QStringLiteral("mm3/s"), QLatin1String(tissue.reach)};
    }
}

/// Measures the time that a bur pressed straight down takes to sink 1.5 mm.
void addPlunges(Figures& figures)
{
    constexpr double kDepthMm = 1.5;
    constexpr double kGivesUpS = 60.0;
    for (const auto& [tissue, material] :
         {std::pair("enamel", core::terrain::Material::Enamel), std::pair("dentin", core::terrain::Material::Dentin)})
        for (std::size_t bur = 0; bur < core::bur::kCommonBurs; ++bur)
            for (const double newtons : {0.5, 1.0, 1.5, 2.0, 3.0}) {
                lab::PaceTrial trial;
                trial.bur = bur;
                trial.material = material;
                trial.newtons = newtons;
                trial.seconds = kGivesUpS;
                const QString id = QString::fromStdString(core::bur::burs()[bur].id);
                const bool isSaid = id == u"330" && newtons == 1.0 && material == core::terrain::Material::Enamel;
                figures << Figure{
                    QStringLiteral("cutting_plunge_%1_%2_%3_s").arg(QLatin1String(tissue), id).arg(newtons),
                    QStringLiteral("1.5 mm down into %1, %2, %3 N").arg(QLatin1String(tissue), id).arg(newtons),
                    lab::secondsTo(kDepthMm, trial), QStringLiteral("s"),
                    isSaid ? QStringLiteral("2 to 4") : QString()};
            }
}

void addRipple(Figures& figures, const Context& context)
{
    int done = kSweepSteps + static_cast<int>(kFeeds.size());
    for (const auto& [key, feeder] : kFeeders) {
        context.progress(QStringLiteral("ripple at constant ") + QLatin1String(key), done++, kSteps);
        double most = 0.0;
        for (std::size_t bur = 0; bur < core::bur::kCommonBurs; ++bur)
            for (const double down : {0.0, 90.0}) {
                lab::PaceTrial trial;
                trial.bur = bur;
                trial.seconds = 3.0;
                trial.towards = lab::feed(20.0, down);
                most = std::max(most, lab::measureRipple(trial, feeder).rmsN);
            }
        figures << Figure{QStringLiteral("cutting_ripple_%1_n").arg(QLatin1String(key)),
                          QStringLiteral("ripple at constant %1, 20 to 300 Hz").arg(QLatin1String(key)), most,
                          QStringLiteral("N"), QStringLiteral("under 0.1")};
    }
}

}  // namespace

core::Result<Figures> cuttingSuite(const Context& context)
{
    Figures figures;
    addSweeps(figures, context, kSteps);
    addPace(figures, context);
    addRates(figures);
    addPlunges(figures);
    addRipple(figures, context);
    return figures;
}

}  // namespace bench
