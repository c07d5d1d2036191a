// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <cmath>
#include <map>
#include <mutex>

#include <glm/geometric.hpp>

#include "core/bur/Bur.h"
#include "core/guidance/Fixture.h"
#include "core/history/TiledHeights.h"
#include "core/rt/TripleBuffer.h"
#include "core/servo/ServoState.h"
#include "haptics/falcon/FalconFeel.h"
#include "haptics/simulated/SimulatedFalcon.h"
#include "tests/support/Allocations.h"
#include "tests/support/Locks.h"
#include "tests/support/Rig.h"
#include "tests/support/SyntheticTooth.h"
#include "tests/support/Tables.h"
#include "tests/support/Trials.h"

using namespace core;
using namespace core::servo;
using namespace std::chrono_literals;

namespace {

std::shared_ptr<const terrain::ToothAnatomy> block(int side = 100)
{
    support::Block made;
    made.side = side;
    made.cellMm = 10.0 / side;
    return support::makeBlock(made);
}

double length(const glm::dvec3& v)
{
    return std::sqrt(glm::dot(v, v));
}

constexpr float kPromptS = 0.0005F;  ///< a delay with which any spring is stable

/// A servo loop without a session: the test reads the queues itself.
struct Bare
{
    /// @param anatomy  the tooth that it begins with; none if null
    explicit Bare(const std::shared_ptr<const terrain::ToothAnatomy>& anatomy = {}, const ServoSettings& which = {},
                  std::chrono::microseconds beat = 1ms)
        : settings(which), period(beat)
    {
        if (anatomy)
            give(anatomy, 1);
    }

    ServoSettings settings;
    std::chrono::microseconds period;
    std::unique_ptr<ServoChannels> links = std::make_unique<ServoChannels>();
    rt::TripleBuffer<ServoState> state;
    support::HeldDevice device;
    haptics::ServoLoop servo{device, makeServoTick(settings).value(), *links, state, period};

    void give(const std::shared_ptr<const terrain::ToothAnatomy>& anatomy, std::uint64_t serial, bool anew = true)
    {
        auto* tooth = new contact::LiveTooth(terrain::Tooth(anatomy));
        send(SwapTooth{tooth, 1, serial, anew, 0});
    }
    void send(const ServoCommand& command) const { QVERIFY(links->commands.tryPush(command)); }
    void tick(int ticks = 1)
    {
        for (int n = 0; n < ticks; ++n)
            servo.tick(1ms);
    }
    /// Presses down at (x, y).
    void lean(double x, double y, double stretchMm = 0.8, int ticks = 1)
    {
        for (int n = 0; n < ticks; ++n) {
            device.tipMm = glm::vec3(glm::dvec3(x, y, servo.state().anchorMm.z - stretchMm));
            tick();
        }
    }
    /// Returns the health flags that the loop publishes.
    [[nodiscard]] std::uint32_t health() { return state.latest().health; }
    [[nodiscard]] bool has(std::uint32_t flag) { return (health() & flag) != 0; }
    [[nodiscard]] double forceN() const { return length(servo.state().forceN); }
    [[nodiscard]] const std::vector<float>& top() const { return servo.tooth()->tooth().top; }
    std::vector<ServoEvent> allEvents() const
    {
        std::vector<ServoEvent> events;
        for (ServoEvent event; links->events.tryPop(event);)
            events.push_back(event);
        return events;
    }
    /// Returns all events of a kind since the last call, and drops the others.
    std::vector<ServoEvent> drainEvents(ServoEvent::Kind kind = ServoEvent::Kind::Tick) const
    {
        std::vector<ServoEvent> events = allEvents();
        std::erase_if(events, [kind](const ServoEvent& event) { return event.kind != kind; });
        return events;
    }
    /// Returns the length of each tick as the servo measured it.
    std::vector<int> steps() const
    {
        std::vector<int> all;
        for (const ServoEvent& event : drainEvents())
            all.push_back(event.dtUs);
        return all;
    }
    /// Frees the teeth that were handed back. Returns their number.
    int freeRetired() const
    {
        int freed = 0;
        for (contact::LiveTooth* old = nullptr; links->retired.tryPop(old); ++freed)
            delete old;
        return freed;
    }
    int freeFixtures() const
    {
        int freed = 0;
        for (const core::guidance::Fixture* old = nullptr; links->retiredFixtures.tryPop(old); ++freed)
            delete old;
        return freed;
    }
    template <class Take>
    void takePatches(Take&& take) const
    {
        for (TilePatch patch; links->patches.tryPop(patch);)
            take(patch);
    }
};

/// Counts the allocations and locks of ticks.
struct Counted
{
    long allocations = 0;
    long locks = 0;

    void tick(haptics::ServoLoop& servo, std::chrono::microseconds dt)
    {
        const long allocationsBefore = support::allocationsOnThisThread();
        const long locksBefore = support::locksOnThisThread();
        servo.tick(dt);
        allocations += support::allocationsOnThisThread() - allocationsBefore;
        locks += support::locksOnThisThread() - locksBefore;
    }
};

/// A lowest and a highest value.
struct Range
{
    double low = 1.0e9;
    double high = -1.0e9;

    void take(double value)
    {
        low = std::min(low, value);
        high = std::max(high, value);
    }
    [[nodiscard]] double width() const { return high - low; }
};

haptics::HandFigures steady(haptics::HandFigures hand)
{
    hand.tremorMm = 0.0;
    hand.driftMm = 0.0;
    return hand;
}

/// Returns a tooth with a round hole in its middle.
contact::LiveTooth* holed(const std::shared_ptr<const terrain::ToothAnatomy>& anatomy, double radiusMm, double deepMm)
{
    std::vector<float> top = anatomy->top;
    support::eachNode(anatomy->grid, [&](std::size_t k, const glm::dvec2& at) {
        top[k] -= glm::length(at) < radiusMm ? static_cast<float>(deepMm) : 0.0F;
    });
    return new contact::LiveTooth(terrain::restored(anatomy, std::move(top)));
}

/// A reader that follows the rule: it applies a group of patches when it is complete.
struct Reader
{
    explicit Reader(const terrain::ToothAnatomy& anatomy) : map(anatomy.grid, anatomy.top) {}

    history::TiledHeights map;
    std::vector<TilePatch> group;
    std::uint64_t tick = 0;
    int strokes = 0;

    /// Takes one patch. Returns true if it completes a group.
    bool take(const TilePatch& patch)
    {
        group.push_back(patch);
        if (!patch.last)
            return false;
        for (const TilePatch& one : group)
            map.setTile(one.tileX, one.tileY, one.top);
        tick = patch.tick;
        strokes += patch.strokeEnded ? 1 : 0;
        group.clear();
        return true;
    }
};

/// Returns the fixture of an ideal with a groove along y, 2 mm wide.
const core::guidance::Fixture* grooveFixture(const terrain::ToothAnatomy& anatomy)
{
    std::vector<float> ideal = anatomy.top;
    support::eachNode(anatomy.grid,
                      [&](std::size_t k, const glm::dvec2& at) { ideal[k] -= std::abs(at.x) < 1.0 ? 1.0F : 0.0F; });
    return new core::guidance::Fixture(anatomy, ideal);
}

}  // namespace

class TestServoLoop : public QObject
{
    Q_OBJECT
private slots:
    void countersCount()
    {
        if (support::kSanitized)
            QSKIP("sanitizers bring their own allocator and locks");
        const long allocations = support::allocationsOnThisThread();
        const long locks = support::locksOnThisThread();
        std::mutex mutex;
        {
            const std::lock_guard lock(mutex);
            std::vector<int> some(100);
            QVERIFY(some.size() == 100);
            asm volatile("" ::"r"(some.data()) : "memory");
        }
        QVERIFY(support::allocationsOnThisThread() > allocations);
        QVERIFY(support::locksOnThisThread() > locks);
    }

    void eachTickLeavesItsPose()
    {
        Bare rig(block());
        const std::size_t count = ServoState{}.trail.size();
        const auto begin = std::chrono::steady_clock::now().time_since_epoch();
        for (std::size_t k = 0; k < count + 5; ++k) {
            rig.device.tipMm = {0.01F * static_cast<float>(k), 0.0F, 4.0F};
            rig.servo.tick(1ms);
        }
        const auto end = std::chrono::steady_clock::now().time_since_epoch();
        std::map<std::int64_t, Pose> byTime;
        const ServoState& told = rig.state.latest();
        for (const Pose& pose : told.trail)
            byTime[pose.takenNs] = pose;
        QCOMPARE(byTime.size(), count);
        QVERIFY(byTime.begin()->first >= std::chrono::nanoseconds(begin).count());
        QVERIFY(byTime.rbegin()->first <= std::chrono::nanoseconds(end).count());
        // The last poses, each at the position of the device at that time.
        std::size_t tick = 5;
        for (const auto& [takenNs, pose] : byTime)
            QCOMPARE(pose.deviceMm.x, static_cast<double>(0.01F * static_cast<float>(tick++)));
        QVERIFY(byTime.rbegin()->second.anchorMm == told.anchorMm);
    }

    void tickNeitherAllocatesNorLocks()
    {
        if (support::kSanitized)
            QSKIP("sanitizers bring their own allocator and locks");
        const auto anatomy = block();
        Bare bare(anatomy);
        support::RestlessHand hand(3);
        Counted counted;
        std::uint64_t cuts = 0;
        const auto tick = [&](std::chrono::microseconds dt) {
            counted.tick(bare.servo, dt);
            cuts += bare.servo.state().cutting ? 1U : 0U;
        };
        bare.send(SetDrill{true});
        std::uint64_t serial = 1;
        for (int n = 0; n < 6000; ++n) {
            if (n % 500 == 100)
                bare.send(SetBur{static_cast<std::uint8_t>(n / 500 % 4)});
            if (n % 40 == 7)
                bare.send(SetParameter{static_cast<std::uint8_t>(n / 40 % 18), 0.003F * static_cast<float>(n % 700)});
            if (n % 1000 == 300) {
                bare.give(anatomy, ++serial, n % 2000 == 300);  // outside the measured tick
                bare.freeRetired();
            }
            bare.device.tipMm = hand.next();
            bare.device.present = n % 97 != 0;
            tick(n % 50 == 0 ? 5ms : 1ms);
            if (n % 3000 < 1500)  // so that the queue of patches overflows
                bare.takePatches([](const TilePatch&) {});
        }
        QVERIFY(cuts > 500);
        for (int n = 0; n < 20000; ++n)  // and the queue of events
            tick(1ms);
        QVERIFY(bare.has(kRecordGap));
        QCOMPARE(counted.allocations, 0L);
        QCOMPARE(counted.locks, 0L);
        bare.freeRetired();
    }

    void lostDeviceMeansNoForceWithinTenMs_data()
    {
        support::columns<bool, float>("present", "x");
        QTest::newRow("no reading") << false << 0.0F;
        QTest::newRow("NaN") << true << std::nanf("");
        QTest::newRow("infinite") << true << INFINITY;
        QTest::newRow("farther than any arm") << true << 3.0e38F;
    }

    void lostDeviceMeansNoForceWithinTenMs()
    {
        QFETCH(bool, present);
        QFETCH(float, x);
        Bare bare(block());
        bare.lean(0.0, 0.0, 2.0, 200);
        QVERIFY(bare.forceN() > 3.0);
        const glm::dvec3 anchor = bare.servo.state().anchorMm;
        bare.device.present = present;
        if (present)
            bare.device.tipMm.x = x;
        // A single packet may be damaged. If the force dropped to zero for it, the hand would fall into the tooth.
        for (int n = 1; n < 10; ++n) {
            bare.tick();
            QVERIFY(bare.forceN() > 3.0);
            QVERIFY(!bare.has(kDeviceLost));
        }
        for (int n = 0; n < 10; ++n) {
            bare.tick();
            QCOMPARE(bare.servo.state().forceN, glm::dvec3(0.0));
            QVERIFY(bare.has(kDeviceLost));
            QCOMPARE(bare.servo.state().touching, false);
            QCOMPARE(bare.servo.state().anchorMm, anchor);
        }
        bare.tick();
        QCOMPARE(bare.device.forceN, glm::dvec3(0.0));  // and the hand receives no force
        // The device is found again.
        bare.device.present = true;
        bare.device.tipMm = glm::vec3(0.0F, 0.0F, 3.0F);
        bare.tick();
        QVERIFY(!bare.has(kDeviceLost));
    }

    void aReadingThatLeapsIsPassedOver()
    {
        ServoSettings falcon;
        haptics::falcon::addFalconFeel(falcon.force);
        falcon.force.vibrationN = 0.0;
        for (const float aside : {20.0F, 60.0F, 900.0F}) {
            for (const double deep : {0.2, 0.0}) {  // in the tooth, and in the air
                Bare bare(block(), falcon);
                bare.device.tipMm = {0.0F, 0.0F, 3.0F};
                bare.tick();
                for (int n = 0; n < 300; ++n) {
                    if (deep > 0.0)
                        bare.lean(0.0, 0.0, deep);
                    else
                        bare.tick();
                }
                const glm::dvec3 before = bare.servo.state().forceN;
                for (int n = 0; n < 100; ++n) {
                    bare.device.tipMm.x = n == 0 || n == 5 ? aside : 0.0F;
                    bare.tick();
                    const glm::dvec3 change = bare.servo.state().forceN - before;
                    QVERIFY2(length(change) < 0.05, qPrintable(QString("%1 mm, %2 deep, tick %3: %4 N more")
                                                                   .arg(aside)
                                                                   .arg(deep)
                                                                   .arg(n)
                                                                   .arg(length(change))));
                    QCOMPARE(bare.health() & (kDeviceLost | kLedHome), 0U);
                }
            }
        }
    }

    void readingsThatStayElsewhereAreADeviceThatWasLost()
    {
        Bare bare(block());
        bare.tick();
        bare.lean(0.0, 0.0, 0.5, 200);
        bare.device.tipMm.x += 15.0F;
        bool wasLost = false;
        for (int n = 0; n < 20; ++n) {
            bare.tick();
            wasLost = wasLost || (bare.servo.state().health & kDeviceLost) != 0;
        }
        QVERIFY(wasLost);
        QCOMPARE(bare.servo.state().deviceMm.x, static_cast<double>(bare.device.tipMm.x));
        QCOMPARE(bare.servo.state().forceN, glm::dvec3(0.0));
    }

    void forceComesBackWithoutAJump()
    {
        Bare bare(block());
        bare.lean(0.0, 0.0, 0.9, 200);
        bare.device.present = false;
        bare.tick(10);
        bare.device.present = true;
        const double slew = contact::ForceSettings{}.slewNPerS;
        // The force returns over a fifth of a second, slower than the slew limit alone would allow.
        double before = 0.0;
        for (int n = 0; n < 250; ++n) {
            bare.lean(0.0, 0.0, 0.9);
            const double now = bare.forceN();
            QVERIFY(now - before <= slew * 0.001 + 1.0e-9);
            if (n < 50)
                QVERIFY2(now < 0.8, qPrintable(QString::number(now)));
            before = now;
        }
        QVERIFY(before > 1.6);
    }

    void aHandThatSankInWhileTheDeviceWasLostIsNotThrownOut()
    {
        Bare bare(block());
        bare.tick();
        bare.lean(0.0, 0.0, 0.5, 200);
        QVERIFY(bare.forceN() > 0.9);
        bare.device.present = false;
        bare.tick(100);
        bare.device.present = true;
        bare.device.tipMm = {0.0F, 0.0F, -3.0F};
        for (int n = 0; n < 500; ++n) {
            bare.tick();
            QCOMPARE(bare.servo.state().forceN, glm::dvec3(0.0));
            QVERIFY((bare.servo.state().health & kBegunInside) != 0);
        }
        bare.device.tipMm = {0.0F, 0.0F, 1.0F};
        bare.tick();
        bare.lean(0.0, 0.0, 0.5, 20);
        QVERIFY(bare.forceN() < 0.2);  // it returns gradually
        bare.lean(0.0, 0.0, 0.5, 200);
        QVERIFY(bare.forceN() > 0.9);
    }

    void aLateDeviceSoftensTheSpring()
    {
        Bare bare(block());
        bare.tick();
        const auto restForce = [&] {
            bare.lean(0.0, 0.0, 0.5, 400);
            return bare.forceN();
        };
        const double prompt = restForce();
        QVERIFY(!bare.has(kLoopIsSlow));
        bare.drainEvents();
        bare.device.delayS = 0.004F;
        const double late = restForce();
        QVERIFY2(std::abs(late / prompt - 0.5) < 0.01, qPrintable(QString::number(late / prompt)));
        QVERIFY(bare.has(kLoopIsSlow));
        const auto springs = bare.drainEvents(ServoEvent::Kind::Spring);
        QVERIFY(springs.size() == 1 && springs[0].value == 50);  // a replay needs it
        // Ticks without a delay or without a reading do not count as fast answers.
        for (int n = 0; n < 2000; ++n) {
            bare.drainEvents();
            bare.device.delayS = n % 4 == 3 ? 0.0F : n % 4 == 1 ? std::nanf("") : 0.004F;
            bare.device.present = n % 4 != 2;
            bare.lean(0.0, 0.0, 0.5);
        }
        bare.device.present = true;
        bare.device.delayS = 0.004F;
        QVERIFY(std::abs(restForce() / prompt - 0.5) < 0.01);
        // A single long delay is forgotten after a while.
        bare.device.delayS = kPromptS;
        restForce();
        QVERIFY(bare.has(kLoopIsSlow));
        for (int n = 0; n < 8; ++n) {
            bare.drainEvents();
            restForce();
        }
        QVERIFY(!bare.has(kLoopIsSlow));
        QVERIFY(std::abs(restForce() / prompt - 1.0) < 0.01);
    }

    /// A slow device is unplugged. The mouse, which reports no delay, takes over.
    void theDeviceAfterALateOneHasTheFullSpring()
    {
        Bare bare(block());
        bare.tick();
        bare.device.delayS = 0.004F;
        bare.lean(0.0, 0.0, 0.5, 20);
        QVERIFY(bare.has(kLoopIsSlow));
        bare.device.present = false;
        bare.tick(40);
        QVERIFY(bare.has(kDeviceLost));
        bare.device.present = true;
        bare.device.delayS = 0.0F;
        bare.drainEvents();
        bare.lean(0.0, 0.0, 0.5, 400);
        QVERIFY(!bare.has(kLoopIsSlow));
    }

    void oneLateAnswerSoftensNothing()
    {
        Bare bare(block());
        bare.device.delayS = kPromptS;
        bare.tick();
        bare.lean(0.0, 0.0, 0.5, 400);
        const double prompt = bare.forceN();
        for (const float delayS : {0.003F, 0.02F, 0.1F, INFINITY, std::nanf("")}) {
            bare.device.delayS = delayS;
            bare.lean(0.0, 0.0, 0.5);
            bare.device.delayS = kPromptS;
            for (int n = 0; n < 10; ++n) {
                bare.lean(0.0, 0.0, 0.5);
                QVERIFY(std::abs(bare.forceN() / prompt - 1.0) < 0.01);
            }
        }
        // Ten long delays in a row mean that the loop has stalled. Two seconds later that is over.
        bare.device.delayS = 0.1F;
        bare.lean(0.0, 0.0, 0.5, 10);
        QVERIFY(bare.has(kLoopIsSlow));
        bare.device.delayS = kPromptS;
        for (int n = 0; n < 3000; ++n) {
            bare.drainEvents();
            bare.lean(0.0, 0.0, 0.5);
        }
        QVERIFY(!bare.has(kLoopIsSlow));
    }

    void groundThatComesBackUnderABurComesSoftly_data()
    {
        QTest::addColumn<double>("deepMm");
        QTest::newRow("0.5 mm") << 0.5;
        QTest::newRow("3 mm") << 3.0;
    }

    void groundThatComesBackUnderABurComesSoftly()
    {
        QFETCH(double, deepMm);
        Bare bare;
        const auto anatomy = block();
        bare.send(SwapTooth{holed(anatomy, 1.0, deepMm), 1, 1, true, 0});
        const double top = contact::LiveTooth(terrain::Tooth(anatomy)).clearanceAt({0.0, 0.0});
        bare.device.tipMm = {0.0F, 0.0F, static_cast<float>(top) + 1.0F};
        bare.tick();
        bare.device.tipMm.z = static_cast<float>(top - deepMm + 0.05);
        bare.tick(300);
        QCOMPARE(bare.servo.state().forceN, glm::dvec3(0.0));
        bare.send(SwapTooth{new contact::LiveTooth(terrain::Tooth(anatomy)), 1, 2, false, 0});  // like Undo
        for (int n = 0; n < 20; ++n) {
            bare.tick();
            QVERIFY2(bare.forceN() < 0.2, qPrintable(QString("tick %1: %2 N").arg(n).arg(bare.forceN())));
        }
        bare.tick(300);
        bare.freeRetired();
        if (deepMm > 1.0) {
            QCOMPARE(bare.servo.state().forceN, glm::dvec3(0.0));
            QVERIFY((bare.servo.state().health & kBegunInside) != 0);
        } else {
            QVERIFY(bare.forceN() > 0.8);
        }
    }

    void aWiderBurInANarrowHoleThrowsNobody()
    {
        constexpr double kDeepMm = 3.0;
        constexpr std::size_t kPear = 1;
        Bare bare;
        const auto anatomy = block();
        bare.send(SwapTooth{holed(anatomy, 0.45, kDeepMm), 1, 1, true, 0});
        const double top = contact::LiveTooth(terrain::Tooth(anatomy)).clearanceAt({0.0, 0.0});
        bare.send(SetBur{kPear});
        bare.device.tipMm = {0.0F, 0.0F, static_cast<float>(top) + 1.0F};
        bare.tick();
        bare.device.tipMm.z = static_cast<float>(top - kDeepMm - 0.3);
        bare.tick(300);
        const double leaning = bare.forceN();
        QVERIFY2(leaning > 0.5 && leaning < 0.7, qPrintable(QString::number(leaning)));
        bare.send(SetBur{3});
        for (int n = 0; n < 300; ++n) {
            bare.tick();
            QCOMPARE(bare.servo.state().forceN, glm::dvec3(0.0));
            QVERIFY((bare.servo.state().health & kBegunInside) != 0);
        }
        // When the bur fits again, its force returns gradually.
        bare.send(SetBur{kPear});
        bare.device.tipMm.z = static_cast<float>(top - kDeepMm + 0.1);
        bare.tick();
        bare.device.tipMm.z = static_cast<float>(top - kDeepMm - 0.3);
        bare.tick(300);
        QVERIFY(bare.forceN() > 0.5);
    }

    void nothingIsCutByAForceThatIsNotFelt()
    {
        // The device was lost and found again. In the first 30 ms the force is smaller than the spring's.
        Bare bare(block());
        bare.tick();
        bare.lean(0.0, 0.0, 0.3, 300);
        bare.device.present = false;
        bare.tick(20);
        bare.send(SetDrill{true});
        bare.device.present = true;
        const auto removedMm3 = [&] {
            double sum = 0.0;
            for (const double mm3 : bare.servo.state().removedMm3)
                sum += mm3;
            return sum;
        };
        for (int n = 0; n < 30; ++n) {
            bare.tick();
            QVERIFY2(bare.forceN() < 0.12, qPrintable(QStringLiteral("%1: %2 N").arg(n).arg(bare.forceN())));
        }
        QCOMPARE(removedMm3(), 0.0);
        bare.tick(300);
        QVERIFY(removedMm3() > 0.0);
    }

    void handIsLedHomeOnRequest()
    {
        ServoSettings falcon;
        haptics::falcon::addFalconFeel(falcon.force);
        falcon.force.vibrationN = 0.0;
        for (const ServoSettings& settings : {ServoSettings{}, falcon}) {
            Bare bare(block(), settings);
            bare.device.tipMm = {20.0F, 0.0F, 5.0F};
            bare.tick();
            bare.drainEvents();
            bare.send(BringHome{});
            bare.tick(100);
            QCOMPARE(bare.drainEvents(ServoEvent::Kind::Home).size(), 1U);  // a replay needs it
            if (settings.force.workAreaMm > 0.0) {
                QVERIFY(bare.servo.state().forceN.x < -0.1);
                QVERIFY(bare.has(kLedHome));
                bare.device.present = false;
                bare.tick(10);
                bare.device.present = true;
                bare.tick();
            }
            QCOMPARE(bare.servo.state().forceN,
                     glm::dvec3(0.0));  // a mouse is not guided, and neither is a lost device
        }
    }

    void fixtureHoldsTheHandAndNothingElse()
    {
        const auto anatomy = block();
        Bare bare(anatomy);
        bare.device.tipMm = {1.2F, 0.0F, 0.05F};  // above the block, beside the groove
        bare.tick(20);
        QCOMPARE(bare.device.forceN, glm::dvec3(0.0));
        bare.drainEvents();
        bare.send(SetFixture{grooveFixture(*anatomy)});
        bare.tick(2);
        QVERIFY(length(bare.device.forceN) < 0.02);  // the force begins softly
        bare.tick(500);
        QVERIFY2(bare.device.forceN.x < -0.2 && bare.device.forceN.x > -1.0,
                 qPrintable(QString::number(bare.device.forceN.x)));
        QVERIFY(bare.has(kHeldInside));
        // The fixture is no contact: it appears neither in the servo's state nor in the recording.
        QCOMPARE(bare.servo.state().forceN, glm::dvec3(0.0));
        QVERIFY(!bare.servo.state().touching);
        for (const ServoEvent& event : bare.allEvents())
            QVERIFY(event.kind == ServoEvent::Kind::Tick);
        // A lost device receives no force, and when it returns the force begins softly.
        bare.device.present = false;
        bare.tick(20);
        QCOMPARE(bare.device.forceN, glm::dvec3(0.0));
        bare.device.present = true;
        bare.tick(3);
        QVERIFY(length(bare.device.forceN) < 0.05);
        bare.tick(500);
        QVERIFY(bare.device.forceN.x < -0.2);
        // Fixtures that are replaced are handed back to be freed.
        bare.send(SetFixture{});
        bare.tick(3);
        QCOMPARE(bare.device.forceN, glm::dvec3(0.0));
        bare.send(SetFixture{grooveFixture(*anatomy)});
        bare.send(SetFixture{grooveFixture(*anatomy)});
        bare.tick(1);
        QCOMPARE(bare.freeFixtures(), 2);
        bare.send(SetFixture{grooveFixture(*anatomy)});  // one that is sent too late
    }

    /// A hand that leans out of the groove through a simulated device comes to rest: no limit cycle and no buzz
    /// (docs/facts/haptics.md, section 2.2).
    void everyHandIsHeldSteadily()
    {
        for (const haptics::HandFigures& hand : haptics::kHands) {
            const haptics::HandFigures figures = steady(hand);
            const auto anatomy = block();
            const std::unique_ptr<const core::guidance::Fixture> fixture(grooveFixture(*anatomy));
            haptics::SimulatedFalcon falcon({}, figures, 0.001, 1, {0.0, 0.0, -0.6});
            glm::dvec3 force(0.0);
            Range x;
            constexpr int kTicks = 4000;
            for (int n = 0; n < kTicks; ++n) {
                // Moves out at 100 mm/s and is then held 2 mm outside.
                falcon.follow({std::min(2.6, 0.1 * n), 0.0, -0.6});
                const haptics::DeviceSample sample = falcon.exchange(force);
                force = fixture->forceN(glm::dvec3(sample.tipInToothMm), 1);
                if (n > kTicks / 2)
                    x.take(sample.tipInToothMm.x);
            }
            QVERIFY2(x.width() < 0.1, qPrintable(QString("%1: %2 mm").arg(figures.name.data()).arg(x.width())));
            QVERIFY2(x.high < 2.3, qPrintable(QString::number(x.high)));
            QVERIFY2(figures.stiffnessNPerM < 500.0 || force.x < -0.5, qPrintable(QString::number(force.x)));
        }
    }

    /// The console changes the stiffness while the hand leans on the tooth.
    void anotherSpringUnderTheHandComesSoftly()
    {
        Bare bare(block());
        bare.lean(0.0, 0.0, 1.0, 300);
        const glm::dvec3 device = bare.servo.state().deviceMm;
        const double mostPerTick = 1.1 * contact::ForceSettings{}.slewNPerS * 0.001;
        for (const float nPerMm : {4.0F, 0.5F, 2.0F}) {
            bare.drainEvents();
            const double before = bare.forceN();
            bare.send(SetParameter{9, nPerMm});
            double last = before;
            for (int n = 0; n < 300; ++n) {
                bare.device.tipMm = glm::vec3(device);
                bare.tick();
                const double now = bare.forceN();
                QVERIFY2(std::abs(now - last) <= mostPerTick, qPrintable(QString("%1 N in a tick").arg(now - last)));
                last = now;
            }
            QVERIFY2(nPerMm > 3.0F ? last > 1.5 * before : std::abs(last - before) > 0.1,
                     qPrintable(QString::number(last)));
            QCOMPARE(bare.drainEvents(ServoEvent::Kind::Number).size(), 1U);
        }
    }

    /// Another servo with its tooth, another handpiece, another fixture: the objects that they replace are handed back
    /// and freed elsewhere.
    void whatIsHandedOverCostsTheTickNoAllocation()
    {
        if (support::kSanitized)
            QSKIP("sanitizers bring their own allocator and locks");
        ServoSettings settings;
        settings.handpieces.push_back(settings::findHandpiece("low-speed").value());
        const auto anatomy = block();
        Bare bare(anatomy, settings);
        bare.send(SetDrill{true});
        support::RestlessHand hand(5);
        Counted counted;
        int servos = 0;
        int fixtures = 0;
        for (int n = 0; n < 800; ++n) {
            if (n % 40 == 0)
                bare.send(SetFixture{n % 80 == 0 ? grooveFixture(*anatomy) : nullptr});
            if (n % 40 == 10)
                bare.send(SetHandpiece{static_cast<std::uint8_t>(n / 40 % 2)});
            if (n % 40 == 20) {
                auto* tooth = new contact::LiveTooth(terrain::Tooth(anatomy));
                QVERIFY(bare.links->commands.tryPush(SwapTooth{tooth, 1, static_cast<std::uint64_t>(n), true, 0, false,
                                                               makeServoTick(settings).value().release()}));
            }
            bare.device.tipMm = hand.next();
            counted.tick(bare.servo, 1ms);
            bare.freeRetired();
            for (ServoTick* old = nullptr; bare.links->retiredServos.tryPop(old); ++servos)
                delete old;
            fixtures += bare.freeFixtures();
            bare.takePatches([](const TilePatch&) {});
            bare.drainEvents();
        }
        QCOMPARE(servos, 20);
        QCOMPARE(fixtures, 10);
        QCOMPARE(counted.allocations, 0L);
        QCOMPARE(counted.locks, 0L);
    }

    /// The contact spring becomes softer if the loop is slow, and the fixture is a spring as well. With its full
    /// stiffness it would shake a light hand by 7 mm at 4 ms after an impact.
    void aLateLoopHoldsTheHandSteadilyToo_data()
    {
        support::columns<int, double>("hand", "delayMs");
        for (int hand = 0; hand < static_cast<int>(haptics::kHands.size()); ++hand)
            for (const double delayMs : {1.0, 2.0, 4.0, 8.0})
                QTest::addRow("%s, %g ms", haptics::kHands.at(static_cast<std::size_t>(hand)).name.data(), delayMs)
                    << hand << delayMs;
    }

    void aLateLoopHoldsTheHandSteadilyToo()
    {
        QFETCH(int, hand);
        QFETCH(double, delayMs);
        const haptics::HandFigures figures = steady(haptics::kHands.at(static_cast<std::size_t>(hand)));
        haptics::FalconFigures late;
        late.delayS = 0.001 * delayMs;
        late.delayJitterS = 0.0;
        late.coulombN = 0.1;  // the smallest friction of a Falcon
        haptics::SimulatedFalcon falcon(late, figures, 0.001, 1, {0.0, 0.0, -0.6});
        const auto anatomy = block();
        // The tooth is cut far wider than the ideal, so that only the fixture holds the hand.
        std::vector<float> top = anatomy->top;
        for (float& height : top)
            height -= 2.0F;
        const auto links = std::make_unique<ServoChannels>();
        rt::TripleBuffer<ServoState> state;
        haptics::ServoLoop servo(falcon, makeServoTick({}).value(), *links, state, 1ms);
        auto* tooth = new contact::LiveTooth(terrain::restored(anatomy, std::move(top)));
        QVERIFY(links->commands.tryPush(SwapTooth{tooth, 1, 1, true, 0}));
        QVERIFY(links->commands.tryPush(SetFixture{grooveFixture(*anatomy)}));
        bool wasHeld = false;
        Range x;
        constexpr int kTicks = 4000;
        for (int n = 0; n < kTicks; ++n) {
            falcon.follow({std::min(2.2, 0.1 * n), 0.0, -0.6});
            if (n == 1500)
                falcon.push({120.0, 0.0, 0.0});
            servo.tick(1ms);
            wasHeld = wasHeld || (state.latest().health & kHeldInside) != 0;
            QVERIFY(!state.latest().touching);
            if (n > 3000)
                x.take(falcon.tipMm().x);
            for (ServoEvent event; links->events.tryPop(event);) {
            }
        }
        QVERIFY2(x.width() < 0.1, qPrintable(QString("%1 mm").arg(x.width())));
        QVERIFY(wasHeld);
    }

    void forceNeverPassesTheClamp()
    {
        Bare bare(block());
        support::RestlessHand hand(8);
        bool clamped = false;
        for (int n = 0; n < 5000; ++n) {
            bare.device.tipMm = hand.next() * 3.0F;
            bare.tick();
            QVERIFY(bare.forceN() <= contact::ForceSettings{}.clampN * (1.0 + 1.0e-12));
            clamped = clamped || (bare.servo.state().health & kForceClamped) != 0;
        }
        QVERIFY(clamped);
    }

    void forceChangesNoFasterThanAllowed()
    {
        Bare bare(block());
        const double slew = contact::ForceSettings{}.slewNPerS;
        Rng rng(12);
        glm::dvec3 before{0.0};
        for (int n = 0; n < 3000; ++n) {
            // Every seventh tick the hand jumps.
            if (n % 7 == 0)
                bare.device.tipMm =
                    glm::vec3(glm::dvec3(rng.uniform(-3.0, 3.0), rng.uniform(-3.0, 3.0), rng.uniform(-5.0, 2.0)));
            const int ms = 1 + rng.below(6);
            bare.servo.tick(std::chrono::milliseconds(ms));
            const glm::dvec3 now = bare.servo.state().forceN;
            QVERIFY(length(now - before) <= slew * 0.001 * std::min(ms, 4) + 1.0e-9);
            before = now;
        }
    }

    void groupsAreMomentsOfTheTooth()
    {
        const auto anatomy = block(150);
        Bare bare(anatomy);
        bare.send(SetDrill{true});
        std::map<std::uint64_t, std::uint64_t> hashOfTick;
        Reader reader(*anatomy);
        Rng rng(4);
        int compared = 0;
        for (int n = 0; n < 1500; ++n) {
            bare.lean(2.0 * std::sin(0.01 * n), 1.5 * std::cos(0.013 * n));
            hashOfTick[bare.servo.state().tick] = terrain::stateHash(bare.servo.tooth()->tooth());
            // The reader is irregular, and often stops in the middle of a group.
            if (rng.below(20) != 0)
                continue;
            TilePatch patch;
            for (int k = rng.below(60); k > 0 && bare.links->patches.tryPop(patch); --k) {
                if (!reader.take(patch))
                    continue;
                QCOMPARE(terrain::stateHash(terrain::restored(anatomy, reader.map.flat())), hashOfTick.at(reader.tick));
                ++compared;
            }
        }
        QVERIFY2(compared > 30, qPrintable(QString::number(compared)));
    }

    void fullQueueLosesNothing()
    {
        const auto anatomy = block(150);
        Bare bare(anatomy);
        bare.send(SetDrill{true});
        Reader reader(*anatomy);
        bool full = false;
        for (int n = 0; n < 40000 && !full; ++n) {  // a bur that is pressed too hard stalls
            bare.lean(3.0 * std::sin(0.02 * n), 3.0 * std::cos(0.017 * n));
            full = full || bare.has(kPatchQueueFull);
            bare.drainEvents();
        }
        QVERIFY(full);
        bare.device.tipMm.z = 5.0F;
        for (int n = 0; n < 400; ++n) {
            bare.takePatches([&](const TilePatch& patch) { reader.take(patch); });
            bare.tick();
        }
        QVERIFY(!bare.has(kPatchQueueFull));
        QCOMPARE(reader.map.flat(), bare.top());
    }

    void groupLargerThanAnyBurstStillGoes()
    {
        // The session sleeps while the bur visits the whole of the finest grid: more tiles change than are ever sent at
        // once.
        support::Block made;
        made.side = 1024;
        made.cellMm = 0.01;
        const auto anatomy = support::makeBlock(made);
        Bare bare(anatomy);
        bare.send(SetDrill{true});
        TilePatch filler;
        filler.toothGeneration = 99;
        while (bare.links->patches.tryPush(filler)) {
        }
        for (int n = 0; n < 1000; ++n) {
            // Cuts at forty places.
            const int place = n / 25;
            const int row = place / 8;
            const glm::dvec2 at(0.9 * (place % 8) - 3.2, 1.2 * row - 2.4);
            if (n % 25 < 5) {
                bare.device.tipMm = glm::vec3(glm::dvec3(at, 1.0));
                bare.tick();
            } else {
                bare.lean(at.x, at.y, 2.0);
            }
        }
        Reader reader(*anatomy);
        bare.device.tipMm.z = 5.0F;
        std::size_t largest = 0;
        for (int n = 0; n < 400; ++n) {
            bare.takePatches([&](const TilePatch& patch) {
                if (patch.toothGeneration != 99)
                    reader.take(patch);
                largest = std::max(largest, reader.group.size());
            });
            bare.tick();
        }
        QVERIFY2(largest > 256, qPrintable(QString::number(largest)));
        QCOMPARE(reader.map.flat(), bare.top());
    }

    void strokesAreTold()
    {
        const auto anatomy = block();
        Bare bare(anatomy);
        bare.send(SetDrill{true});
        Reader reader(*anatomy);
        for (int stroke = 0; stroke < 5; ++stroke) {
            for (int n = 0; n < 100; ++n)
                bare.lean(stroke - 2.0, 0.0);
            bare.device.tipMm.z = 3.0F;
            // A pause shorter than 150 ms does not end a stroke.
            bare.tick(100);
            for (int n = 0; n < 100; ++n)
                bare.lean(stroke - 2.0, 0.2);
            bare.device.tipMm.z = 3.0F;
            bare.tick(300);
            bare.takePatches([&](const TilePatch& patch) { reader.take(patch); });
            QCOMPARE(reader.strokes, stroke + 1);
            QCOMPARE(reader.map.flat(), bare.top());
        }
    }

    void strokeThatEndsWhileTheQueueIsFullIsToldLater()
    {
        const auto anatomy = block();
        Bare bare(anatomy);
        bare.send(SetDrill{true});
        bare.lean(0.0, 0.0, 0.8, 100);
        bare.device.tipMm.z = 3.0F;
        bare.tick(20);  // sends the last tiles
        // The queue is full while the stroke ends.
        TilePatch filler;
        filler.toothGeneration = 99;
        filler.last = true;
        int fillers = 0;
        while (bare.links->patches.tryPush(filler))
            ++fillers;
        bare.tick(300);
        // Now tile 0 itself is cut: it must not be listed twice.
        for (int n = 0; n < 50; ++n)
            bare.lean(-4.8, -4.8);
        Reader reader(*anatomy);
        bare.device.tipMm.z = 3.0F;
        for (int n = 0; n < 400; ++n) {
            bare.takePatches([&](const TilePatch& patch) {
                if (patch.toothGeneration != 99)
                    reader.take(patch);
            });
            bare.tick();
        }
        QVERIFY(fillers > 100);
        QCOMPARE(reader.map.flat(), bare.top());
        QVERIFY(reader.strokes >= 1);
    }

    void missedPeriodsAreCountedAndTheStepHeldBack()
    {
        Bare bare(block());
        bare.tick();
        QCOMPARE(bare.state.latest().missedPeriods, 0U);
        bare.servo.tick(3ms);
        QCOMPARE(bare.state.latest().missedPeriods, 2U);
        bare.servo.tick(500ms);
        QCOMPARE(bare.state.latest().missedPeriods, 501U);
        bare.tick();
        QCOMPARE(bare.state.latest().missedPeriods, 501U);
        QCOMPARE(bare.steps(), (std::vector<int>{1000, 3000, 4000, 1000}));
        // After a pause of ten seconds the bur removes no more than in four milliseconds.
        bare.send(SetDrill{true});
        bare.lean(0.0, 0.0, 1.0, 300);
        const double before = bare.servo.state().removedMm3[1];
        bare.lean(0.0, 0.0, 1.0);
        const double perTick = bare.servo.state().removedMm3[1] - before;
        const double atOnce = bare.servo.state().removedMm3[1];
        bare.device.tipMm = glm::vec3(glm::dvec3(0.0, 0.0, bare.servo.state().anchorMm.z - 1.0));
        bare.servo.tick(10s);
        QVERIFY(perTick > 0.0);
        QVERIFY(bare.servo.state().removedMm3[1] - atOnce < 8.0 * perTick);
    }

    void slowBeatIsNoMissedPeriod()
    {
        // A loop with ticks of 100 Hz computes its whole period, so that nothing is missed.
        Bare bare(block(), {}, 10ms);
        bare.servo.tick(10ms);
        bare.servo.tick(30ms);
        QCOMPARE(bare.state.latest().missedPeriods, 2U);
        QCOMPARE(bare.steps(), (std::vector<int>{10000, 10000}));
    }

    void retiredTeethAreHandedBack()
    {
        Bare bare;
        const auto anatomy = block(64);
        std::vector<const contact::LiveTooth*> given;
        for (std::uint64_t n = 1; n <= 10; ++n) {
            bare.give(anatomy, n, n % 3 == 1);
            bare.tick();
            given.push_back(bare.servo.tooth());
        }
        contact::LiveTooth* old = nullptr;
        for (std::size_t n = 0; n < 9; ++n) {
            QVERIFY(bare.links->retired.tryPop(old));
            QCOMPARE(static_cast<const contact::LiveTooth*>(old), given[n]);
            delete old;
        }
        QVERIFY(!bare.links->retired.tryPop(old));
        bare.give(anatomy, 11);  // never received: the loop frees both teeth at its end, as AddressSanitizer checks
    }

    void fullRetiredQueueHoldsCommandsBack()
    {
        const auto anatomy = block(64);
        Bare bare(anatomy);
        bare.tick();
        std::uint64_t serial = 1;
        for (int n = 0; n < 80; ++n) {
            bare.give(anatomy, ++serial);
            bare.tick();
        }
        QCOMPARE(bare.links->retired.space(), 0U);
        QCOMPARE(bare.links->commands.space(), 64U - 16U);  // 64 were received, 16 wait
        int freed = 0;
        for (int n = 0; n < 100; ++n) {
            freed += bare.freeRetired();
            bare.tick();
        }
        QCOMPARE(freed, 80);
        QCOMPARE(bare.links->commands.space(), 64U);
    }

    void commandsWaitForRoomOnTheRecording()
    {
        Bare bare(block(64));
        bare.tick(20000);
        QVERIFY(bare.has(kRecordGap));
        bare.send(SetBur{3});
        bare.give(block(64), 2);
        bare.tick();
        QCOMPARE(bare.servo.state().burIndex, 0);
        // Every event before the gap is there, in order. Then the new tooth begins.
        QCOMPARE(bare.drainEvents().size(), 16384U - 3U);
        bare.tick();
        QVERIFY(!bare.drainEvents(ServoEvent::Kind::Begin).empty());
        QCOMPARE(bare.servo.state().burIndex, 3);
        QVERIFY(!bare.has(kRecordGap));
        bare.freeRetired();
    }

    void worksWithoutATooth()
    {
        Bare bare;
        bare.send(SetDrill{true});
        bare.send(SetBur{2});
        bare.tick(10);
        QCOMPARE(bare.device.forceN, glm::dvec3(0.0));
        QVERIFY(bare.servo.tooth() == nullptr);
        bare.drainEvents();
        // Bur and drill that were chosen before the tooth came still apply, and are recorded.
        bare.give(block(64), 1);
        bare.tick();
        QCOMPARE(bare.servo.state().burIndex, 2);
        QVERIFY(bare.servo.state().drillOn);
        const std::vector<ServoEvent> events = bare.allEvents();
        QCOMPARE(events.size(), 4U);
        QVERIFY(events[0].kind == ServoEvent::Kind::Begin);
        QVERIFY(events[1].kind == ServoEvent::Kind::Bur && events[1].value == 2);
        QVERIFY(events[2].kind == ServoEvent::Kind::Drill && events[2].value == 1);
        QVERIFY(events[3].kind == ServoEvent::Kind::Tick);
    }

    /// During a replay the student's tooth stays unchanged, and work on it can continue afterwards.
    void aRestingLoopLeavesDeviceAndToothAlone()
    {
        Bare bare(block(64));
        rt::TripleBuffer<audio::SoundState> sound;
        bare.servo.publishSound(sound);
        bare.send(SetDrill{true});
        bare.lean(0.0, 0.0, 0.8, 200);
        QVERIFY(bare.forceN() > 0.0);
        QVERIFY(sound.latest().burRpm > 0.0F);
        QVERIFY(!bare.servo.isResting());
        const std::vector<float> top = bare.top();
        const std::uint64_t tick = bare.state.latest().tick;
        bare.allEvents();

        const glm::dvec3 untouched(9.0);
        bare.device.forceN = untouched;
        bare.device.tipMm.z -= 1.0F;
        bare.servo.setResting(true);
        bare.tick(50);
        QVERIFY(bare.servo.isResting());
        QCOMPARE(bare.device.forceN, untouched);
        QCOMPARE(bare.top(), top);
        QCOMPARE(bare.state.latest().tick, tick);
        QCOMPARE(sound.latest().burRpm, 0.0F);
        QVERIFY(bare.allEvents().empty());
        // A tooth that was sent before still arrives.
        bare.give(block(32), 2);
        bare.tick();
        QCOMPARE(bare.servo.tooth()->tooth().grid().side, 32);
        QCOMPARE(bare.freeRetired(), 1);

        bare.servo.setResting(false);
        bare.tick();
        QVERIFY(!bare.servo.isResting());
        QVERIFY(bare.device.forceN != untouched);
        QVERIFY(!bare.drainEvents().empty());
    }

    void unknownBurIsIgnored()
    {
        Bare bare(block(64));
        bare.send(SetBur{static_cast<std::uint8_t>(core::bur::burs().size())});
        bare.send(SetBur{255});
        bare.tick();
        QCOMPARE(bare.servo.state().burIndex, 0);
    }
};

QTEST_APPLESS_MAIN(TestServoLoop)
#include "tst_servo_loop.moc"
