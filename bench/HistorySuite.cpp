// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "bench/Circumstances.h"
#include "bench/Suites.h"
#include "core/base/Rng.h"
#include "core/recording/Replay.h"
#include "core/servo/ServoState.h"
#include "core/session/SessionChannels.h"
#include "core/session/SessionLoop.h"
#include "core/teeth/ToothBuilder.h"
#include "haptics/ServoLoop.h"
#include "haptics/simulated/Simulation.h"

namespace bench {
namespace {

using namespace core::session;
using namespace core::servo;
using namespace std::chrono_literals;

constexpr int kTooth = 36;
constexpr int kStrokes = 1000;
constexpr int kJumps = 1000;
constexpr int kTicksAStroke = 60;
constexpr int kTicksASession = 10;
constexpr int kPasses = 20;  ///< of drilling, in turn with and without jumps
constexpr int kTicksAPass = 2000;

/// A device at a position that is set, above or in the tooth.
class Hand final : public haptics::HapticDevice
{
public:
    glm::vec3 tipMm{0.0F, 0.0F, 8.0F};
    haptics::DeviceSample exchange(const glm::dvec3&) noexcept override { return {tipMm, true}; }
};

/// Servo and session, run in this thread.
class Workplace
{
public:
    explicit Workplace(const std::shared_ptr<const core::terrain::ToothAnatomy>& anatomy)
        : m_session(*m_servoLinks, *m_uiLinks, {}),
          m_servo(m_hand, makeServoTick({}).value(), *m_servoLinks, m_uiLinks->servo, 1ms),
          m_middle(anatomy->grid.middleMm())
    {
        send(ReplaceTooth{std::make_unique<core::terrain::Tooth>(anatomy), 1});
        send(SetBur{1});
        send(SetDrill{true});
        beatSession();
    }

    void send(SessionCommand command) { static_cast<void>(m_uiLinks->commands.tryPush(std::move(command))); }

    /// Runs the session once and returns the processor time, microseconds.
    double beatSession()
    {
        const double before = haptics::threadCpuUs();
        m_session.tick(10ms);
        const double took = haptics::threadCpuUs() - before;
        for (TilePatch patch; m_uiLinks->patches.tryPop(patch);) {
            // no view reads it
        }
        return took;
    }

    void beatServo(haptics::TickTimes* times)
    {
        const double before = haptics::threadCpuUs();
        m_servo.tick(1ms);
        if (times != nullptr)
            times->add(haptics::threadCpuUs() - before);
        if (++m_ticks % kTicksASession == 0)
            beatSession();
    }

    /// Moves the bur along x at a place over the middle of the tooth, pressing, for the length of a stroke.
    void lean(glm::dvec2 placeMm, int ticks, haptics::TickTimes* times, int ticksAJump = 0)
    {
        for (int k = 0; k < ticks; ++k) {
            const double along = 1.0e-3 * (k % 400 < 200 ? k % 200 : 200 - k % 200);
            m_hand.tipMm = glm::vec3(glm::dvec3(m_middle + placeMm + glm::dvec2(along, 0.0),
                                                std::min(m_servo.state().anchorMm.z, 2.0) - 0.6));
            if (ticksAJump > 0 && k % ticksAJump == 0)
                send(k / ticksAJump % 2 == 0 ? SessionCommand{Undo{}} : SessionCommand{Redo{}});
            beatServo(times);
        }
    }

    void lift()
    {
        m_hand.tipMm.z = 8.0F;
        for (int k = 0; k < StrokeDetector::kPauseTicks + 2 * kTicksASession; ++k)
            beatServo(nullptr);
    }

    [[nodiscard]] const SessionLoop& session() const { return m_session; }

private:
    Hand m_hand;
    std::unique_ptr<ServoChannels> m_servoLinks = std::make_unique<ServoChannels>();
    std::unique_ptr<UiChannels> m_uiLinks = std::make_unique<UiChannels>();
    SessionLoop m_session;
    haptics::ServoLoop m_servo;
    glm::dvec2 m_middle;
    std::uint64_t m_ticks = 0;
};

core::Status measure(Figures& figures, int side)
{
    core::teeth::BuildOptions options;
    options.gridSide = side;
    const auto built = core::teeth::buildTooth({kTooth}, options);
    if (!built)
        return tl::unexpected(built.error());
    const auto add = [&](const char* what, const QString& words, double value, const char* unit, const char* reach) {
        figures << Figure{QStringLiteral("history_%1_%2").arg(side).arg(QLatin1String(what)),
                          QStringLiteral("grid %1: %2").arg(side).arg(words), value, QLatin1String(unit),
                          QLatin1String(reach)};
    };

    Workplace place(built->anatomy);
    core::Rng rng(1);
    const auto somewhere = [&] { return glm::dvec2(rng.uniform(-3.0, 3.0), rng.uniform(-3.0, 3.0)); };
    const double beforeMiB = residentMiB();
    for (int n = 0; n < kStrokes; ++n) {
        place.lean(somewhere(), kTicksAStroke, nullptr);
        place.lift();
    }
    const double afterMiB = residentMiB();
    const double recordedMiB = static_cast<double>(place.session().recordingSoFar()->packedBytes()) / 1024.0 / 1024.0;
    const auto moments = place.session().historySoFar();
    add("moments", QStringLiteral("moments after %1 strokes").arg(kStrokes), static_cast<double>(moments.size()), "",
        "");
    add("memory_mib", QStringLiteral("memory they and the recording take"), afterMiB - beforeMiB, "MiB", "< 200");
    add("recording_mib", QStringLiteral("of it, the recording"), recordedMiB, "MiB", "");

    haptics::TickTimes jumps;
    for (int n = 0; n < kJumps; ++n) {
        place.send(GoTo{moments[static_cast<std::size_t>(rng.below(static_cast<int>(moments.size())))].id});
        jumps.add(place.beatSession());
        place.beatServo(nullptr);
    }
    add("jump_p50_ms", QStringLiteral("jump to any moment, half of them"), 1.0e-3 * jumps.percentileUs(0.5), "ms", "");
    add("jump_p99_ms", QStringLiteral("jump, 99 of 100"), 1.0e-3 * jumps.percentileUs(0.99), "ms", "");
    add("jump_max_ms", QStringLiteral("jump, the longest"), 1.0e-3 * jumps.longestUs(), "ms", "< 50");

    // Drilling, in turn alone and with an undo or redo in each run of the session.
    const auto calm = std::make_unique<haptics::TickTimes>();
    const auto stormy = std::make_unique<haptics::TickTimes>();
    for (int pass = 0; pass < kPasses; ++pass) {
        const bool storm = pass % 2 == 1;
        place.lift();
        place.lean(somewhere(), kTicksAPass, storm ? stormy.get() : calm.get(), storm ? kTicksASession : 0);
    }
    const double calmUs = calm->percentileUs(0.99);
    const double stormyUs = stormy->percentileUs(0.99);
    add("tick_p99_calm_us", QStringLiteral("tick while drilling, 99 of 100"), calmUs, "us", "");
    add("tick_p99_storm_us", QStringLiteral("the same with 100 undo or redo a second"), stormyUs, "us", "");
    add("tick_p99_ratio", QStringLiteral("the one to the other"), stormyUs / calmUs, "", "about 1");
    return {};
}

}  // namespace

core::Result<Figures> historySuite(const Context& context)
{
    Figures figures;
    int step = 0;
    for (const int side : {150, 300}) {
        context.progress(QStringLiteral("%1 strokes, grid %2").arg(kStrokes).arg(side), step++, 2);
        if (const core::Status measured = measure(figures, side); !measured)
            return tl::unexpected(measured.error());
    }
    return figures;
}

}  // namespace bench
