// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include <QJsonObject>

#include "app/replay/ReplayTrack.h"
#include "bench/Circumstances.h"
#include "bench/Contestants.h"
#include "bench/Suites.h"
#include "bench/Wander.h"
#include "cli/parts/Attempt.h"
#include "core/base/Rng.h"
#include "core/recording/Player.h"
#include "core/servo/ServoState.h"
#include "core/session/SessionChannels.h"
#include "core/teeth/ToothBuilder.h"
#include "haptics/pointer/PointerDevice.h"
#include "haptics/simulated/Simulation.h"

namespace bench {
namespace {

/// A hand that circles a crown below its widest line, a little inside: the bur stays beneath the overhang.
class HandBeneathTheCrown final : public haptics::HapticDevice
{
public:
    /// @param deeperMmPerS  speed inwards, because after cutting there is no overhang any more
    HandBeneathTheCrown(const core::terrain::ToothAnatomy& anatomy, double deeperMmPerS)
        : m_middleMm(anatomy.grid.middleMm()), m_deeperMmPerS(deeperMmPerS)
    {
        const core::terrain::Grid& grid = anatomy.grid;
        const double half = 0.5 * grid.cellMm * (grid.side - 1);
        for (std::size_t k = 0; k < m_rim.size(); ++k) {
            const double angle = 2.0 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(m_rim.size());
            for (double out = half; out > 0.0 && m_rim[k].radiusMm == 0.0; out -= 0.5 * grid.cellMm) {
                const glm::dvec2 at =
                    grid.latticeOf(m_middleMm + out * glm::dvec2(std::cos(angle), std::sin(angle))) + 0.5;
                const std::size_t column = grid.index(std::clamp(static_cast<int>(at.x), 0, grid.side - 1),
                                                      std::clamp(static_cast<int>(at.y), 0, grid.side - 1));
                if (anatomy.top[column] > anatomy.bottom[column])
                    m_rim[k] = {out, static_cast<double>(anatomy.bottom[column])};
            }
        }
    }

    haptics::DeviceSample exchange(const glm::dvec3&) noexcept override
    {
        const double seconds = 0.001 * static_cast<double>(m_tick++);
        const double place = std::fmod(seconds / kRoundS, 1.0) * static_cast<double>(m_rim.size());
        const auto k = static_cast<std::size_t>(place);
        const double share = place - static_cast<double>(k);
        const Rim& before = m_rim[k];
        const Rim& behind = m_rim[(k + 1) % m_rim.size()];
        const double inside = kInsideMm + m_deeperMmPerS * seconds - std::max(0.0, kAwayMm - kInMmPerS * seconds);
        const double radius = std::lerp(before.radiusMm, behind.radiusMm, share) - inside;
        const double angle = 2.0 * std::numbers::pi * std::fmod(seconds / kRoundS, 1.0);
        return {{m_middleMm.x + radius * std::cos(angle), m_middleMm.y + radius * std::sin(angle),
                 std::lerp(before.zMm, behind.zMm, share) - kBelowMm},
                true};
    }

private:
    struct Rim
    {
        double radiusMm = 0.0;
        double zMm = 0.0;  ///< of the underside there
    };
    static constexpr double kRoundS = 10.0;
    static constexpr double kInsideMm = 0.3;  ///< inside the outline, for the axis
    static constexpr double kBelowMm = 1.5;   ///< below the underside, for the tip
    static constexpr double kAwayMm = 2.0;    ///< start outside the outline
    static constexpr double kInMmPerS = 5.0;

    glm::dvec2 m_middleMm;
    double m_deeperMmPerS;
    std::array<Rim, 90> m_rim;
    std::uint64_t m_tick = 0;
};

constexpr std::uint64_t kTicksAMinute = 60'000;

struct DrillingRun
{
    std::unique_ptr<haptics::TickTimes> tickTimes;
    double cuttingShare = 0.0;
    double firstMiB = 0.0;  ///< after a tenth of the time
    double lastMiB = 0.0;
    double recordedMiB = 0.0;
    std::optional<core::recording::Recording> recording;
};

std::shared_ptr<const core::terrain::ToothAnatomy> molar(int gridSide)
{
    core::teeth::BuildOptions build;
    build.gridSide = gridSide;
    return core::teeth::buildTooth({36}, build).value().anatomy;
}

/// @param minute  called at the start of each minute, with its number and their count; may be empty
core::Result<DrillingRun> drillFor(double seconds, int gridSide, const std::string& method, bool drill,
                                   const std::function<void(int, int)>& minute = {})
{
    haptics::SimulationOptions options;
    options.settings.method = method;
    options.record = true;  // like the window
    core::rt::TripleBuffer<core::servo::PointerInput> pointer;
    haptics::PointerDevice device(pointer, options.settings.force.stiffnessNPerMm, 1.0 / options.rateHz);
    const auto ticks = static_cast<std::uint64_t>(seconds * options.rateHz);
    DrillingRun run;
    std::uint64_t cutting = 0;
    auto outcome = haptics::simulate(
        molar(gridSide), device, ticks, options,
        [&](std::uint64_t tick, const core::servo::ServoState&, const core::terrain::Tooth&) -> std::optional<bool> {
            if (tick % 16 == 0)
                pointer.publish(wander(static_cast<double>(tick) / options.rateHz, 4.0));
            if (tick % kTicksAMinute == 0 && minute)
                minute(static_cast<int>(tick / kTicksAMinute),
                       static_cast<int>((ticks + kTicksAMinute - 1) / kTicksAMinute));
            if (tick == ticks / 10)
                run.firstMiB = residentMiB();
            return drill;
        },
        [&](std::uint64_t, const core::servo::ServoState& state) { cutting += state.cutting ? 1 : 0; });
    if (!outcome)
        return tl::unexpected(outcome.error());
    run.lastMiB = residentMiB();
    run.tickTimes = std::move(outcome->tickTimes);
    run.cuttingShare = static_cast<double>(cutting) / static_cast<double>(ticks);
    run.recordedMiB = static_cast<double>(outcome->recording->packedBytes()) / 1048576.0;
    run.recording = std::move(outcome->recording);
    return run;
}

core::Result<DrillingRun> roundTheCrownFor(double seconds, int gridSide, bool drill)
{
    const auto anatomy = molar(gridSide);
    HandBeneathTheCrown hand(*anatomy, drill ? 0.03 : 0.0);
    haptics::SimulationOptions options;
    options.burIndex = 0;  // the bur with the widest head relative to its shank
    options.record = true;
    DrillingRun run;
    auto outcome = haptics::simulate(anatomy, hand, static_cast<std::uint64_t>(seconds * options.rateHz), options,
                                     [&](std::uint64_t, const core::servo::ServoState&,
                                         const core::terrain::Tooth&) -> std::optional<bool> { return drill; },
                                     {});
    if (!outcome)
        return tl::unexpected(outcome.error());
    run.tickTimes = std::move(outcome->tickTimes);
    return run;
}

void addPercentiles(Figures& figures, const QString& key, const QString& what, const haptics::TickTimes& times,
                    const QString& reach)
{
    const QJsonObject at = cli::toJson(times);
    for (const char* name : {"p50", "p99", "p999"})
        figures << Figure{QStringLiteral("%1_%2_us").arg(key, QLatin1String(name)),
                          what + QStringLiteral(", ") + QLatin1String(name), at[QLatin1String(name)].toDouble(),
                          QStringLiteral("us"), QLatin1String(name) == QLatin1String("p99") ? reach : QString()};
}

/// Returns how long two readings of the clock take, which is part of every measured tick.
haptics::TickTimes timesOfTheClock()
{
    haptics::TickTimes clock;
    for (int k = 0; k < 10'000; ++k) {
        const double start = haptics::threadCpuUs();
        clock.add(haptics::threadCpuUs() - start);
    }
    return clock;
}

}  // namespace

core::Result<Figures> tickSuite(const Context& context)
{
    constexpr double kSeconds = 30.0;
    constexpr std::array kSides{150, 300, 600, 1024};
    // Limits for the 99th percentile, us.
    constexpr double kContactUs = 5.0;
    constexpr double kCuttingUs = 15.0;
    constexpr double kFinestUs = 100.0;
    Figures figures;
    int done = 0;
    const auto steps = static_cast<int>(contactMethods().size() - 1 + 4 * kSides.size());
    ui::charts::Curve chart;
    chart.x = {QStringLiteral("columns a side of the grid"), -0.3, 3.3};
    for (const int side : kSides)
        chart.x.labels << QString::number(side);
    chart.y = {QStringLiteral("thread CPU time of a tick, 99th percentile (us)"), 1.0, 2000.0};
    chart.y.base = 10.0;
    const auto limit = [&](const char* asked, double us) {
        chart.limits << ui::charts::Limit{us, false,
                                          QStringLiteral("asked for %1: %2 us").arg(QLatin1String(asked)).arg(us)};
    };
    limit("without cutting at 150", kContactUs);
    limit("with cutting at 150", kCuttingUs);
    limit("with cutting at 1024", kFinestUs);
    const auto add = [&](const QString& key, const QString& what, const haptics::TickTimes& times, double reachUs) {
        addPercentiles(figures, QStringLiteral("tick_") + key, what, times,
                       reachUs > 0.0 ? QStringLiteral("under %1").arg(reachUs) : QString());
    };

    add(QStringLiteral("clock"), QStringLiteral("the clock, in all of these"), timesOfTheClock(), 0.0);

    for (const Contestant* method : contactMethods()) {
        if (method->settings.method == "continuous")
            continue;
        context.progress(QStringLiteral("contact, ") + method->text(), done++, steps);
        const auto run = drillFor(kSeconds, 150, method->settings.method, false);
        if (!run)
            return tl::unexpected(run.error());
        add(QStringLiteral("contact_%1_150").arg(method->key()),
            QStringLiteral("contact, %1, grid 150").arg(method->text()), *run->tickTimes, 0.0);
    }
    for (const bool drill : {false, true}) {
        for (const bool beneath : {false, true}) {
            const QString key = QLatin1String(drill     ? "cutting"
                                              : beneath ? "contact"
                                                        : "contact_continuous") +
                                QLatin1String(beneath ? "_overhang" : "");
            const QString what = QLatin1String(drill ? "cutting" : "contact") +
                                 QLatin1String(beneath ? " beneath the crown, bur 2" : ", bur 330");
            ui::charts::Line line = lineOf(what, static_cast<LookIndex>(chart.lines.size()));
            for (std::size_t k = 0; k < kSides.size(); ++k) {
                const int side = kSides[k];
                context.progress(QStringLiteral("%1, grid %2").arg(what).arg(side), done++, steps);
                const auto run =
                    beneath ? roundTheCrownFor(kSeconds, side, drill) : drillFor(kSeconds, side, "continuous", drill);
                if (!run)
                    return tl::unexpected(run.error());
                const double reachUs = side == 150    ? (drill ? kCuttingUs : kContactUs)
                                       : side == 1024 ? (drill ? kFinestUs : 0.0)
                                                      : 0.0;
                add(QStringLiteral("%1_%2").arg(key).arg(side), QStringLiteral("%1, grid %2").arg(what).arg(side),
                    *run->tickTimes, reachUs);
                const double us = run->tickTimes->percentileUs(0.99);
                line.dots << pointAt(static_cast<double>(k), us, QString::number(us, 'f', us < 10.0 ? 1 : 0));
            }
            chart.lines << line;
        }
    }
    context.show(
        {QStringLiteral("tick"),
         {QStringLiteral("Time of a servo tick against the grid"),
          QStringLiteral(
              "Contact, and contact with cutting. Bur 330 strokes the crown of a generated 36 with 1 N; bur 2 goes "
              "round it beneath its widest line, 0.3 mm inside.\nHalf a microsecond of each is the clock."),
          {},
          chart}});
    return figures;
}

core::Result<Figures> drillingSuite(const Context& context)
{
    const auto run = drillFor(60.0 * context.minutes, 150, "continuous", true, [&](int minute, int of) {
        context.progress(QStringLiteral("minute %1").arg(minute + 1), minute, of);
    });
    if (!run)
        return tl::unexpected(run.error());
    Figures figures;
    addPercentiles(figures, QStringLiteral("drilling_tick"), QStringLiteral("tick"), *run->tickTimes,
                   QStringLiteral("under 20"));
    const auto add = [&](const char* key, const char* what, double value, const char* unit, const char* reach = "") {
        figures << Figure{QLatin1String(key), QLatin1String(what), value, QLatin1String(unit), QLatin1String(reach)};
    };
    add("drilling_tick_max_us", "tick, longest", run->tickTimes->longestUs(), "us", "under 1000");
    add("drilling_cutting_percent", "ticks that cut", 100.0 * run->cuttingShare, "%");
    add("drilling_memory_early_mib", "memory after a tenth", run->firstMiB, "MiB");
    add("drilling_memory_end_mib", "memory at the end", run->lastMiB, "MiB", "flat but for the recording");
    add("drilling_recording_mib", "of it, the recording", run->recordedMiB, "MiB");
    return figures;
}

namespace {

/// Measures the times to show any moment of a recording: states, figures and all tiles that the view lacks.
core::Result<haptics::TickTimes> seekTimes(const core::recording::Recording& recording, int seeks)
{
    const auto links = std::make_unique<core::session::UiChannels>();
    auto track = app::ReplayTrack::make(recording, *links, 1);
    if (!track)
        return tl::unexpected(track.error());
    while ((*track)->prepare(1000)) {
        // runs to the end
    }
    haptics::TickTimes times;
    core::Rng rng(2);
    for (int n = 0; n < seeks; ++n) {
        const double seconds = rng.uniform(0.0, (*track)->lengthS());
        const double start = haptics::threadCpuUs();
        for (bool more = true; more;) {
            (*track)->show(seconds);
            more = false;
            for (core::servo::TilePatch patch; links->patches.tryPop(patch);)
                more = true;
        }
        times.add(haptics::threadCpuUs() - start);
    }
    return times;
}

}  // namespace

core::Result<Figures> replaySuite(const Context& context)
{
    constexpr int kLooks = 500;
    constexpr std::uint64_t kTicksAStep = 1000;
    Figures figures;
    int step = 0;
    for (const auto& [side, minutes] : {std::pair(150, 10.0), std::pair(300, 2.0)}) {
        context.progress(QStringLiteral("%1 minutes of drilling, grid %2").arg(minutes).arg(side), step++, 2);
        auto run = drillFor(60.0 * minutes, side, "continuous", true);
        if (!run)
            return tl::unexpected(run.error());
        const double lastsS = std::chrono::duration<double>(run->recording->duration()).count();
        auto player = core::recording::Player::make(*run->recording);
        if (!player)
            return tl::unexpected(player.error());
        const double before = haptics::threadCpuUs();
        while ((*player)->advance(kTicksAStep)) {
            // runs to the end
        }
        const double passS = 1.0e-6 * (haptics::threadCpuUs() - before);
        haptics::TickTimes looks;
        core::Rng rng(1);
        for (int n = 0; n < kLooks; ++n) {
            const auto tick = static_cast<std::uint64_t>(rng.uniform(0.0, static_cast<double>((*player)->ticks())));
            const double start = haptics::threadCpuUs();
            static_cast<void>((*player)->stateAt(tick));
            static_cast<void>((*player)->heightsAt(tick));
            looks.add(haptics::threadCpuUs() - start);
        }
        const auto seeks = seekTimes(*run->recording, kLooks);
        if (!seeks)
            return tl::unexpected(seeks.error());
        const auto add = [&, grid = side](const char* what, const char* words, double value, const char* unit,
                                          const char* reach) {
            figures << Figure{QStringLiteral("replay_%1_%2").arg(grid).arg(QLatin1String(what)),
                              QStringLiteral("grid %1: %2").arg(grid).arg(QLatin1String(words)), value,
                              QLatin1String(unit), QLatin1String(reach)};
        };
        add("times", "the pass, times real time", lastsS / passS, "", "at least 50");
        add("look_p50_ms", "to any moment, half of them", 1.0e-3 * looks.percentileUs(0.5), "ms", "");
        add("look_max_ms", "to any moment, the longest", 1.0e-3 * looks.longestUs(), "ms", "under 50");
        add("seek_p50_ms", "what the view is told of any moment, half of them", 1.0e-3 * seeks->percentileUs(0.5), "ms",
            "");
        add("seek_p99_ms", "what the view is told of any moment, 99 of 100", 1.0e-3 * seeks->percentileUs(0.99), "ms",
            "under 50");
        add("seek_max_ms", "what the view is told of any moment, the longest", 1.0e-3 * seeks->longestUs(), "ms", "");
        add("memory_mib_minute", "memory a minute", static_cast<double>((*player)->bytes()) / 1048576.0 / minutes,
            "MiB", "");
        add("recording_mib_minute", "recording a minute", run->recordedMiB / minutes, "MiB", "under 1");
    }
    return figures;
}

}  // namespace bench
