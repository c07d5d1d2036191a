// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <memory>
#include <thread>
#include <vector>

#include "app/threads/LoopThread.h"
#include "bench/Contestants.h"
#include "bench/InParallel.h"
#include "bench/Suites.h"
#include "bench/Wander.h"
#include "core/servo/ServoState.h"
#include "core/session/SessionChannels.h"
#include "core/session/SessionLoop.h"
#include "core/teeth/ToothBuilder.h"
#include "core/tracking/TrackerLoop.h"
#include "haptics/ServoLoop.h"
#include "haptics/falcon/FalconFeel.h"
#include "haptics/simulated/SimulatedFalcon.h"
#include "haptics/simulated/Simulation.h"
#include "lab/StiffnessLimit.h"
#include "lab/TagScene.h"

namespace bench {
namespace {

using namespace core::session;
using namespace core::servo;
using namespace std::chrono_literals;

constexpr std::array kRatesHz{1000, 2000, 4000};
constexpr int kFastHz = kRatesHz.back();
constexpr double kDelayMs = 1.0;
constexpr double kRadiusMm = 3.0;
constexpr double kAboveMm = 6.0;
constexpr double kAskedUs = 100.0;
/// Share of the minutes for the slower rates and for the loop with a real clock.
constexpr double kShortShare = 1.0 / 60.0;
constexpr double kWholeToothS = 60.0;  ///< time after which the next tooth is drilled

/// A simulated Falcon in a hand that strokes the crown and presses with 1 N wherever the bur is.
class StrokingHand final : public haptics::HapticDevice
{
public:
    explicit StrokingHand(double periodS)
        : m_periodS(periodS), m_falcon({}, kHand, periodS, 1, {0.0, 0.0, kAboveMm}), m_burMm(0.0, 0.0, kAboveMm)
    {}
    void seeBur(const glm::dvec3& tipMm) noexcept override { m_burMm = tipMm; }
    haptics::DeviceSample exchange(const glm::dvec3& forceOnHandN) noexcept override
    {
        const PointerInput stroke = wander(m_seconds += m_periodS, kRadiusMm);
        const double pressMm = 1000.0 * stroke.pushForceN / kHand.stiffnessNPerM;
        m_falcon.follow({stroke.targetMm.x, stroke.targetMm.y, std::max(kLowestMm, m_burMm.z) - pressMm});
        return m_falcon.exchange(forceOnHandN);
    }

private:
    static constexpr const haptics::HandFigures& kHand = haptics::kHands[1];
    static constexpr double kLowestMm = -4.0;  ///< of the bur: a hand beside the tooth returns from here
    double m_periodS;
    haptics::SimulatedFalcon m_falcon;
    glm::dvec3 m_burMm;
    double m_seconds = 0.0;
};

ServoSettings falconSettings()
{
    ServoSettings settings;
    haptics::falcon::addFalconFeel(settings.force);
    return settings;
}

struct DrillingTicks
{
    haptics::TickTimes times;
    std::uint64_t ticks = 0;
    std::uint64_t cutting = 0;
};

/// Drills one tooth after another, as fast as possible.
core::Status drill(DrillingTicks& into, const std::shared_ptr<const core::terrain::ToothAnatomy>& anatomy, int rateHz,
                   double seconds)
{
    haptics::SimulationOptions options;
    options.settings = falconSettings();
    options.rateHz = rateHz;
    for (double left = seconds; left > 0.0; left -= kWholeToothS) {
        StrokingHand hand(1.0 / rateHz);
        const auto ticks = static_cast<std::uint64_t>(std::min(left, kWholeToothS) * rateHz);
        const auto outcome = haptics::simulate(
            anatomy, hand, ticks, options,
            [](std::uint64_t, const ServoState&, const core::terrain::Tooth&) -> std::optional<bool> { return true; },
            [&](std::uint64_t, const ServoState& state) { into.cutting += state.cutting ? 1 : 0; });
        if (!outcome)
            return tl::unexpected(outcome.error());
        into.times.add(*outcome->tickTimes);
        into.ticks += ticks;
    }
    return {};
}

/// A loop that measures its own time.
class TimedLoop final : public core::rt::Loop
{
public:
    explicit TimedLoop(haptics::ServoLoop& loop) : m_loop(loop) {}
    void tick(std::chrono::microseconds dt) override
    {
        const double start = haptics::threadCpuUs();
        m_loop.tick(dt);
        m_times.add(haptics::threadCpuUs() - start);
        ++m_ticks;
    }
    /// Valid after its thread has ended.
    [[nodiscard]] const haptics::TickTimes& times() const { return m_times; }
    [[nodiscard]] std::uint64_t ticks() const { return m_ticks; }

private:
    haptics::ServoLoop& m_loop;
    haptics::TickTimes m_times;
    std::uint64_t m_ticks = 0;
};

/// A camera that gives 30 rendered pictures a second of a moving head.
class RenderedCamera final : public core::tracking::PictureSource
{
public:
    RenderedCamera()
    {
        lab::TagScene scene;
        scene.camera = core::tracking::CameraModel::withFieldOfView(1280, 720, 60.0);
        for (int n = 0; n < kPictures; ++n) {
            scene.grain = static_cast<std::uint64_t>(n + 1);
            scene.tag.emplace().pose = lab::facing({5.0 * n, 0.0, 600.0}, 0.0, 20.0, 0.0);
            m_pictures.push_back(lab::render(scene));
        }
    }
    core::Result<bool> next(core::tracking::Picture& picture) override
    {
        std::this_thread::sleep_until(m_due += 33ms);
        picture = m_pictures[m_next++ % m_pictures.size()];
        picture.timeS = std::chrono::duration<double>(m_due.time_since_epoch()).count();
        return true;
    }
    [[nodiscard]] bool isLive() const override { return true; }

private:
    static constexpr int kPictures = 10;
    std::vector<core::tracking::Picture> m_pictures;
    std::size_t m_next = 0;
    std::chrono::steady_clock::time_point m_due = std::chrono::steady_clock::now();
};

struct LiveTicks
{
    double p99Us = 0.0;  ///< CPU time of a tick, the simulated device included
    std::uint64_t ticks = 0;
    std::uint64_t missed = 0;
};

/// Drills in a thread with a real clock.
/// @param tracks  whether the tag of a head is tracked meanwhile
core::Result<LiveTicks> drillLive(const std::shared_ptr<const core::terrain::ToothAnatomy>& anatomy, double seconds,
                                  bool tracks)
{
    constexpr std::chrono::microseconds kPeriod(1'000'000 / kFastHz);
    const ServoSettings settings = falconSettings();
    auto tick = makeServoTick(settings);
    if (!tick)
        return tl::unexpected(tick.error());
    const auto servoLinks = std::make_unique<ServoChannels>();
    const auto uiLinks = std::make_unique<UiChannels>();
    StrokingHand hand(1.0 / kFastHz);
    SessionLoop session(*servoLinks, *uiLinks, settings, {false, 0});
    haptics::ServoLoop servo(hand, std::move(*tick), *servoLinks, uiLinks->servo, kPeriod);
    const auto timed = std::make_unique<TimedLoop>(servo);
    const auto send = [&](SessionCommand command) { static_cast<void>(uiLinks->commands.tryPush(std::move(command))); };
    send(ReplaceTooth{std::make_unique<core::terrain::Tooth>(anatomy), 1});
    send(SetBur{1});
    send(SetDrill{true});
    {
        app::LoopThread servoThread(*timed, kPeriod, app::LoopThread::Urgency::RealTime);
        app::LoopThread sessionThread(session, 10ms, app::LoopThread::Urgency::Normal);
        sessionThread.start();
        servoThread.start();
        core::tracking::TrackerLoop tracker(
            []() -> core::Result<std::unique_ptr<core::tracking::PictureSource>> {
                return std::make_unique<RenderedCamera>();
            },
            {});
        app::LoopThread trackerThread(tracker, 10ms, app::LoopThread::Urgency::Normal);
        if (tracks)
            trackerThread.start(QThread::LowPriority);
        const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
        while (std::chrono::steady_clock::now() < end) {
            for (TilePatch patch; uiLinks->patches.tryPop(patch);) {
                // no view shows it
            }
            std::this_thread::sleep_for(16ms);
        }
    }
    return LiveTicks{timed->times().percentileUs(0.99), timed->ticks(), uiLinks->servo.latest().missedPeriods};
}

NamedChart chartOf(const QList<ui::charts::Line>& lines)
{
    ui::charts::Curve chart;
    chart.x = {QStringLiteral("rate of the servo (kHz)"), 0.85, 4.7};
    chart.x.base = 2.0;
    chart.y = {QStringLiteral("K_max: the stiffest wall that comes to rest (N/mm)"), 0.0, 40.0};
    chart.lines = lines;
    chart.limits = {{core::contact::ForceSettings().stiffnessNPerMm, false, QStringLiteral("shipped")}};
    return {
        QStringLiteral("servo"),
        {QStringLiteral("K_max against the rate of the servo"),
         QStringLiteral("Simulated Falcon with a delay of %1 ms besides the motor's lag; the hand throws the bur at a "
                        "flat tooth with 50 mm/s and leans on it\nwith 2 N; at rest: moves less than 0.15 mm in the "
                        "last 0.5 s of 2 s.")
             .arg(kDelayMs),
         {},
         chart}};
}

/// Adds K_max of every hand at every rate.
void addLimits(Figures& figures, const Context& context, int steps)
{
    std::array<std::array<double, kRatesHz.size()>, haptics::kHands.size()> limits{};
    inParallel(
        kRatesHz.size() * haptics::kHands.size(),
        [&](std::size_t k) {
            lab::ClosedLoop loop;
            loop.hand = haptics::kHands[k / kRatesHz.size()];
            loop.rateHz = kRatesHz[k % kRatesHz.size()];
            loop.falcon.delayS = 0.001 * kDelayMs;
            loop.falcon.delayJitterS = 0.0;
            limits[k / kRatesHz.size()][k % kRatesHz.size()] = lab::stiffnessLimit(loop).value();  // none of them is
                                                                                                   // refused
        },
        [&](std::size_t) { context.progress(QStringLiteral("K_max by rate"), 0, steps); });
    QList<ui::charts::Line> lines;
    for (std::size_t hand = 0; hand < limits.size(); ++hand) {
        const std::string_view id = haptics::kHands[hand].name;
        const QString name = QString::fromLatin1(id.data(), static_cast<qsizetype>(id.size()));
        ui::charts::Line line = lineOf(name + QStringLiteral(" hand"), static_cast<LookIndex>(hand));
        for (std::size_t k = 0; k < kRatesHz.size(); ++k) {
            const double nPerMm = limits[hand][k];
            line.dots << pointAt(0.001 * kRatesHz[k], nPerMm, QString::number(nPerMm, 'f', 1));
            figures << Figure{
                QStringLiteral("servo_k_max_%1_%2hz_n_per_mm").arg(name).arg(kRatesHz[k]),
                QStringLiteral("largest, %1 hand, %2 Hz, delay %3 ms").arg(name).arg(kRatesHz[k]).arg(kDelayMs),
                nPerMm,
                QStringLiteral("N/mm"),
                {}};
        }
        lines << line;
    }
    context.show(chartOf(lines));
}

}  // namespace

core::Result<Figures> servoSuite(const Context& context)
{
    const double longS = 60.0 * context.minutes;
    const double shortS = std::max(1.0, kShortShare * longS);
    const auto steps = static_cast<int>(kRatesHz.size()) + 3;
    int done = 0;
    Figures figures;
    addLimits(figures, context, steps);
    const auto anatomy = core::teeth::buildTooth({36}, {}).value().anatomy;
    const auto add = [&](const QString& key, const QString& what, double value, const char* unit,
                         const QString& reach = {}) {
        figures << Figure{QStringLiteral("servo_") + key, what, value, QLatin1String(unit), reach};
    };
    for (const int rateHz : kRatesHz) {
        context.progress(QStringLiteral("drilling at %1 Hz").arg(rateHz), ++done, steps);
        const auto run = std::make_unique<DrillingTicks>();
        const double seconds = rateHz == kFastHz ? longS : shortS;
        if (const core::Status drilled = drill(*run, anatomy, rateHz, seconds); !drilled)
            return tl::unexpected(drilled.error());
        const QString key = QStringLiteral("%1hz_").arg(rateHz);
        const QString what = QStringLiteral("%1 Hz, drilling: ").arg(rateHz);
        add(key + QStringLiteral("tick_p50_us"), what + QStringLiteral("tick, half of them"),
            run->times.percentileUs(0.5), "us");
        add(key + QStringLiteral("tick_p99_us"), what + QStringLiteral("tick, 99 of 100"),
            run->times.percentileUs(0.99), "us", QStringLiteral("under %1").arg(kAskedUs));
        add(key + QStringLiteral("tick_max_us"), what + QStringLiteral("tick, the longest"), run->times.longestUs(),
            "us");
        add(key + QStringLiteral("ticks"), what + QStringLiteral("ticks"), static_cast<double>(run->ticks), "");
        add(key + QStringLiteral("cutting_percent"), what + QStringLiteral("ticks that cut"),
            100.0 * static_cast<double>(run->cutting) / static_cast<double>(run->ticks), "%");
    }
    for (const bool tracks : {false, true}) {
        context.progress(QStringLiteral("%1 Hz with a real clock").arg(kFastHz), ++done, steps);
        const auto live = drillLive(anatomy, shortS, tracks);
        if (!live)
            return tl::unexpected(live.error());
        const QString key =
            QStringLiteral("live_%1hz_").arg(kFastHz) + (tracks ? QStringLiteral("tracking_") : QString());
        const QString what = QStringLiteral("%1 Hz with a real clock%2: ")
                                 .arg(kFastHz)
                                 .arg(tracks ? QStringLiteral(", with head tracking") : QString());
        add(key + QStringLiteral("tick_p99_us"), what + QStringLiteral("tick, 99 of 100"), live->p99Us, "us",
            QStringLiteral("under %1").arg(kAskedUs));
        add(key + QStringLiteral("ticks"), what + QStringLiteral("ticks"), static_cast<double>(live->ticks), "");
        add(key + QStringLiteral("missed"), what + QStringLiteral("missed periods"), static_cast<double>(live->missed),
            "");
    }
    return figures;
}

}  // namespace bench
