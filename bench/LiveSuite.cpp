// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <atomic>
#include <memory>
#include <thread>

#include "app/threads/LoopThread.h"
#include "bench/Suites.h"
#include "bench/Wander.h"
#include "core/guidance/Margin.h"
#include "core/servo/ServoState.h"
#include "core/session/LiveAssessmentLoop.h"
#include "core/session/SessionChannels.h"
#include "haptics/ServoLoop.h"
#include "haptics/pointer/PointerDevice.h"
#include "haptics/simulated/Simulation.h"
#include "lessons/Assignment.h"
#include "lessons/LessonCatalog.h"
#include "ui/tooth/PatchInbox.h"

namespace bench {
namespace {

using namespace core::session;
using namespace core::servo;
using namespace std::chrono_literals;

constexpr auto kLesson = "class1-36";
constexpr auto kServoPeriod = 1ms;
constexpr auto kPicturePeriod = 16ms;
constexpr int kPicturesAProgress = 6;  ///< ten a second
constexpr int kPasses = 20;            ///< in turn without and with live measures
constexpr auto kPass = 3s;
constexpr auto kSettling = 100ms;  ///< pause before each pass, so that waiting work is done
constexpr double kRadiusMm = 3.0;

/// The part of the run that is being timed; read by all threads.
enum class Pass { None, Alone, Measured };

/// The servo of the window, timed.
class TimedServo final : public core::rt::Loop
{
public:
    TimedServo(haptics::ServoLoop& servo, const std::atomic<Pass>& pass) : m_servo(servo), m_pass(pass) {}
    void tick(std::chrono::microseconds dt) override
    {
        const Pass pass = m_pass;
        const double before = haptics::threadCpuUs();
        m_servo.tick(dt);
        const double took = haptics::threadCpuUs() - before;
        if (pass != Pass::None)
            (pass == Pass::Alone ? m_alone : m_measured).add(took);
    }
    /// Valid after its thread has ended.
    [[nodiscard]] const haptics::TickTimes& alone() const { return m_alone; }
    [[nodiscard]] const haptics::TickTimes& measured() const { return m_measured; }

private:
    haptics::ServoLoop& m_servo;
    const std::atomic<Pass>& m_pass;
    haptics::TickTimes m_alone;
    haptics::TickTimes m_measured;
};

/// The follower, which finds infractions and process figures. It rests while the servo is timed alone.
class TimedFollower final : public core::rt::Loop
{
public:
    TimedFollower(LiveAssessmentLoop& follower, const std::atomic<bool>& works, const std::atomic<Pass>& pass)
        : m_follower(follower), m_works(works), m_pass(pass)
    {}
    void tick(std::chrono::microseconds dt) override
    {
        if (!m_works)
            return;
        const bool timed = m_pass == Pass::Measured;
        const double before = haptics::threadCpuUs();
        m_follower.tick(dt);
        static_cast<void>(m_follower.findings());
        if (timed)
            m_times.add(haptics::threadCpuUs() - before);
    }
    [[nodiscard]] const haptics::TickTimes& times() const { return m_times; }

private:
    LiveAssessmentLoop& m_follower;
    const std::atomic<bool>& m_works;
    const std::atomic<Pass>& m_pass;
    haptics::TickTimes m_times;
};

/// Does what the window does for each picture: takes the changed tiles. With live measures it also computes the margin
/// each time and the progress ten times a second.
class Watcher final : public core::rt::Loop
{
public:
    Watcher(UiChannels& links, const lessons::Assignment& assignment, core::rt::TripleBuffer<PointerInput>& pointer,
            const std::atomic<bool>& works, const std::atomic<Pass>& pass)
        : m_links(links), m_ideal(assignment.shownIdeal()), m_tooth(assignment.anatomy), m_pointer(pointer),
          m_works(works), m_pass(pass)
    {}
    void tick(std::chrono::microseconds dt) override
    {
        m_seconds += std::chrono::duration<double>(dt).count();
        m_pointer.publish(wander(m_seconds, kRadiusMm));
        for (TilePatch patch; m_links.patches.tryPop(patch);)
            ui::tooth::write(patch, m_tooth);
        if (!m_works)
            return;
        const bool timed = m_pass == Pass::Measured;
        const ServoState& servo = m_links.servo.latest();
        const double before = haptics::threadCpuUs();
        static_cast<void>(
            core::guidance::marginMm(*m_tooth.anatomy, *m_ideal, core::bur::burs()[servo.burIndex], servo.anchorMm));
        if (timed)
            m_margins.add(haptics::threadCpuUs() - before);
        if (++m_pictures % kPicturesAProgress != 0)
            return;
        const double between = haptics::threadCpuUs();
        m_leftMm3 = core::guidance::progressOf(*m_tooth.anatomy, *m_ideal, m_tooth.top).leftMm3;
        if (timed)
            m_progresses.add(haptics::threadCpuUs() - between);
    }
    [[nodiscard]] const haptics::TickTimes& margins() const { return m_margins; }
    [[nodiscard]] const haptics::TickTimes& progresses() const { return m_progresses; }
    [[nodiscard]] double leftMm3() const { return m_leftMm3; }

private:
    UiChannels& m_links;
    core::grading::IdealTop m_ideal;
    core::terrain::Tooth m_tooth;
    core::rt::TripleBuffer<PointerInput>& m_pointer;
    const std::atomic<bool>& m_works;
    const std::atomic<Pass>& m_pass;
    double m_seconds = 0.0;
    int m_pictures = 0;
    double m_leftMm3 = 0.0;
    haptics::TickTimes m_margins;
    haptics::TickTimes m_progresses;
};

core::Result<lessons::Assignment> shippedLesson()
{
    const auto entries = lessons::readCatalog({});
    const auto entry = std::find_if(entries.begin(), entries.end(), [](const lessons::CatalogEntry& one) {
        return one.read.lesson && one.read.lesson->id == kLesson;
    });
    if (entry == entries.end())
        return core::unexpected(core::ErrorCode::FileMissing, std::string("There is no lesson ") + kLesson + ".");
    auto assigned = lessons::assign(*entry->read.lesson);
    if (!assigned)
        return tl::unexpected(assigned.error());
    return std::move(assigned->assignment);
}

}  // namespace

core::Result<Figures> liveSuite(const Context& context)
{
    const auto assignment = shippedLesson();
    if (!assignment)
        return tl::unexpected(assignment.error());
    const ServoSettings settings = lessons::servoSettings(&*assignment->lesson, {});
    auto tick = makeServoTick(settings);
    if (!tick)
        return tl::unexpected(tick.error());

    const auto servoLinks = std::make_unique<ServoChannels>();
    const auto uiLinks = std::make_unique<UiChannels>();
    core::rt::TripleBuffer<PointerInput> pointer;
    haptics::PointerDevice device(pointer, settings.force.stiffnessNPerMm,
                                  std::chrono::duration<double>(kServoPeriod).count());
    SessionLoop session(*servoLinks, *uiLinks, settings);
    haptics::ServoLoop servo(device, std::move(*tick), *servoLinks, uiLinks->servo, kServoPeriod);
    LiveAssessmentLoop follower(session);
    follower.watch(1, lessons::examinationOf(*assignment));
    const auto send = [&](SessionCommand command) { static_cast<void>(uiLinks->commands.tryPush(std::move(command))); };
    send(ReplaceTooth{std::make_unique<core::terrain::Tooth>(assignment->anatomy), 1});
    send(SetBur{1});
    send(SetDrill{true});

    std::atomic<Pass> pass{Pass::None};
    std::atomic<bool> works{false};
    const auto timedServo = std::make_unique<TimedServo>(servo, pass);
    const auto timedFollower = std::make_unique<TimedFollower>(follower, works, pass);
    const auto watcher = std::make_unique<Watcher>(*uiLinks, *assignment, pointer, works, pass);
    {
        app::LoopThread servoThread(*timedServo, kServoPeriod, app::LoopThread::Urgency::RealTime);
        app::LoopThread sessionThread(session, 10ms, app::LoopThread::Urgency::Normal);
        app::LoopThread followerThread(*timedFollower, LiveAssessmentLoop::kPeriod, app::LoopThread::Urgency::Normal);
        app::LoopThread watcherThread(*watcher, kPicturePeriod, app::LoopThread::Urgency::Normal);
        for (app::LoopThread* thread : {&watcherThread, &followerThread, &sessionThread, &servoThread})
            thread->start();
        for (int n = 0; n < kPasses; ++n) {
            context.progress(QStringLiteral("drilling, with and without live measures"), n, kPasses);
            works = n % 2 == 1;
            std::this_thread::sleep_for(kSettling);
            pass = works ? Pass::Measured : Pass::Alone;
            std::this_thread::sleep_for(kPass);
            pass = Pass::None;
        }
    }

    Figures figures;
    const auto add = [&](const char* key, const char* what, double value, const char* unit, const char* reach = "") {
        figures << Figure{QStringLiteral("live_") + QLatin1String(key), QLatin1String(what), value, QLatin1String(unit),
                          QLatin1String(reach)};
    };
    const haptics::TickTimes& alone = timedServo->alone();
    const haptics::TickTimes& measured = timedServo->measured();
    add("tick_alone_p50_us", "tick while drilling, alone, half of them", alone.percentileUs(0.5), "us");
    add("tick_alone_p99_us", "tick while drilling, alone, 99 of 100", alone.percentileUs(0.99), "us");
    add("tick_measured_p50_us", "tick with live measures, half of them", measured.percentileUs(0.5), "us");
    add("tick_measured_p99_us", "tick with live measures, 99 of 100", measured.percentileUs(0.99), "us");
    add("tick_p99_ratio", "the one to the other", measured.percentileUs(0.99) / alone.percentileUs(0.99), "",
        "about 1");
    add("follower_p50_us", "findings, 20 a second, half of them", timedFollower->times().percentileUs(0.5), "us");
    add("follower_p99_us", "findings, 99 of 100", timedFollower->times().percentileUs(0.99), "us");
    add("margin_p99_us", "distance to the limit, each picture, 99 of 100", watcher->margins().percentileUs(0.99), "us");
    add("progress_p99_us", "what is left and beyond, ten a second, 99 of 100", watcher->progresses().percentileUs(0.99),
        "us");
    add("left_mm3", "still to cut at the end", watcher->leftMm3(), "mm3");
    return figures;
}

}  // namespace bench
