// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include <QFile>
#include <QJsonObject>

#include "app/cli/Attempt.h"
#include "app/cli/bench/Contestants.h"
#include "app/cli/bench/Suites.h"
#include "core/teeth/ToothBuilder.h"
#include "haptics/pointer/PointerDevice.h"
#include "haptics/simulated/Simulation.h"

namespace app::cli::bench {
namespace {

/// Resident memory of this process, MiB; 0 where the system does not say.
double residentMiB()
{
    QFile status(QStringLiteral("/proc/self/status"));
    if (!status.open(QIODevice::ReadOnly))
        return 0.0;
    for (const QByteArray& line : status.readAll().split('\n'))
        if (line.startsWith("VmRSS:"))
            return line.mid(6).trimmed().split(' ').front().toDouble() / 1024.0;
    return 0.0;
}

/// Strokes that wander over the whole crown: slow figure of eight in a slowly turning direction.
core::session::PointerInput wander(double seconds, double radiusMm)
{
    core::session::PointerInput want;
    const double stroke = radiusMm * std::sin(2.0 * std::numbers::pi * 0.8 * seconds);
    const double drift = 0.5 * radiusMm * std::sin(2.0 * std::numbers::pi * 0.031 * seconds);
    const double turn = 2.0 * std::numbers::pi * 0.013 * seconds;
    want.targetMm = {stroke * std::cos(turn) - drift * std::sin(turn),
                     stroke * std::sin(turn) + drift * std::cos(turn)};
    want.pushing = true;
    want.pushForceN = 1.0;
    return want;
}

constexpr std::uint64_t kTicksAMinute = 60'000;

struct DrillingRun
{
    std::unique_ptr<haptics::TickTimes> tickTimes;
    double cuttingShare = 0.0;
    double firstMiB = 0.0;  ///< after a tenth of the time
    double lastMiB = 0.0;
    double recordedMiB = 0.0;
};

/// @param minute  called as each begins, with its number and how many there are; may be empty
core::Result<DrillingRun> drillFor(double seconds, int gridSide, const std::string& method, bool drill,
                                   const std::function<void(int, int)>& minute = {})
{
    core::teeth::BuildOptions build;
    build.gridSide = gridSide;
    const auto tooth = core::teeth::buildTooth({36}, build);
    if (!tooth)
        return tl::unexpected(tooth.error());
    haptics::SimulationOptions options;
    options.settings.method = method;
    options.record = true;  // as the window does
    core::rt::TripleBuffer<core::session::PointerInput> pointer;
    haptics::PointerDevice device(pointer, options.settings.force.stiffnessNPerMm, 1.0 / options.rateHz);
    const auto ticks = static_cast<std::uint64_t>(seconds * options.rateHz);
    DrillingRun run;
    std::uint64_t cutting = 0;
    auto outcome = haptics::simulate(
        tooth->anatomy, device, ticks, options,
        [&](std::uint64_t tick, const core::session::ServoState&, const core::terrain::Tooth&) -> std::optional<bool> {
            if (tick % 16 == 0)
                pointer.publish(wander(static_cast<double>(tick) / options.rateHz, 4.0));
            if (tick % kTicksAMinute == 0 && minute)
                minute(static_cast<int>(tick / kTicksAMinute),
                       static_cast<int>((ticks + kTicksAMinute - 1) / kTicksAMinute));
            if (tick == ticks / 10)
                run.firstMiB = residentMiB();
            return drill;
        },
        [&](std::uint64_t, const core::session::ServoState& state) { cutting += state.cutting ? 1 : 0; });
    if (!outcome)
        return tl::unexpected(outcome.error());
    run.lastMiB = residentMiB();
    run.tickTimes = std::move(outcome->tickTimes);
    run.cuttingShare = static_cast<double>(cutting) / static_cast<double>(ticks);
    run.recordedMiB = static_cast<double>(outcome->recording->packedBytes()) / 1048576.0;
    return run;
}

void addPercentiles(Figures& figures, const QString& key, const QString& what, const haptics::TickTimes& times,
                    const QString& reach)
{
    const QJsonObject at = toJson(times);
    for (const char* name : {"p50", "p99", "p999"})
        figures << Figure{QStringLiteral("%1_%2_us").arg(key, QLatin1String(name)),
                          what + QStringLiteral(", ") + QLatin1String(name), at[QLatin1String(name)].toDouble(),
                          QStringLiteral("us"), QLatin1String(name) == QLatin1String("p99") ? reach : QString()};
}

}  // namespace

core::Result<Figures> tickSuite(const Context& context)
{
    constexpr double kSeconds = 30.0;
    constexpr std::array kSides{150, 300, 600};
    Figures figures;
    int done = 0;
    const auto steps = static_cast<int>(contactMethods().size() + kSides.size());
    for (const Contestant* method : contactMethods()) {
        context.progress(QStringLiteral("contact, ") + method->text(), done++, steps);
        const auto run = drillFor(kSeconds, 150, method->settings.method, false);
        if (!run)
            return tl::unexpected(run.error());
        addPercentiles(figures, QStringLiteral("tick_contact_%1_150").arg(method->key()),
                       QStringLiteral("contact, %1, grid 150").arg(method->text()), *run->tickTimes, {});
    }
    for (const int side : kSides) {
        context.progress(QStringLiteral("cutting, grid %1").arg(side), done++, steps);
        const auto run = drillFor(kSeconds, side, "continuous", true);
        if (!run)
            return tl::unexpected(run.error());
        addPercentiles(figures, QStringLiteral("tick_cutting_%1").arg(side),
                       QStringLiteral("contact and cutting, bur 330, grid %1").arg(side), *run->tickTimes,
                       side == 150 ? QStringLiteral("under 20") : QString());
    }
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

}  // namespace app::cli::bench
