// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <array>
#include <numeric>

#include "core/bur/Bur.h"
#include "core/recording/Replay.h"
#include "core/servo/ServoParameters.h"
#include "core/servo/ServoState.h"
#include "core/session/SessionChannels.h"
#include "tests/support/Checks.h"
#include "tests/support/Rig.h"
#include "tests/support/Suite.h"
#include "tests/support/SyntheticTooth.h"
#include "tests/support/Tables.h"

using namespace core;
using core::servo::ServoEvent;
using recording::Recording;

namespace {

/// Returns a tooth with every layer, thin enough to be bored through, on a grid of any size.
std::shared_ptr<const terrain::ToothAnatomy> layeredTooth(int side)
{
    support::Block block;
    block.side = side;
    block.cellMm = 9.0 / side;
    block.bottomMm = -2.0;
    block.dejMm = -0.5;
    block.topMm = [](double x, double y) {
        const double r2 = x * x + y * y;
        return r2 > 16.0 ? std::nan("") : -0.05 * r2 + 0.2 * std::sin(3.0 * x) * std::sin(2.0 * y);
    };
    auto tooth = std::make_shared<terrain::ToothAnatomy>(*support::makeBlock(block));
    for (std::size_t k = 0; k < tooth->layers.size(); ++k) {
        if (!(tooth->top[k] > tooth->bottom[k]))
            continue;
        tooth->layers[k].cariesRoof = tooth->top[k];
        tooth->layers[k].cariesFloor = k % 3 == 0 ? tooth->top[k] - 0.3F : tooth->top[k];
        tooth->layers[k].pulpRoof = -1.2F;
        tooth->layers[k].pulpFloor = -1.6F;
    }
    return tooth;
}

/// Replays the recording from its bytes and compares the result with the tooth of the servo.
void compareWithLive(support::Rig& rig)
{
    rig.settle();
    const auto soFar = rig.session->recordingSoFar();
    QVERIFY(soFar.has_value());
    QVERIFY(soFar->witness().has_value());
    const auto read = Recording::fromBytes(soFar->toBytes());
    QVERIFY(support::succeeds(read));
    const auto outcome = recording::replay(*read);
    QVERIFY(outcome);
    QVERIFY(outcome->agreesWithWitness);
    QCOMPARE(outcome->stateHash, rig.liveHash());
    QCOMPARE(outcome->state.tick, rig.servo->state().tick);
    QCOMPARE(outcome->state.removedMm3, rig.servo->state().removedMm3);
    QCOMPARE(outcome->state.anchorMm, rig.servo->state().anchorMm);
    QCOMPARE(outcome->state.forceN, rig.servo->state().forceN);
}

/// Returns the default settings with every handpiece.
core::servo::ServoSettings withHandpieces()
{
    core::servo::ServoSettings settings;
    const auto all = settings::handpieces();
    settings.handpieces.assign(all.begin(), all.end());
    return settings;
}

double removedMm3(const support::Rig& rig)
{
    const auto& removed = rig.servo->state().removedMm3;
    return std::accumulate(removed.begin(), removed.end(), 0.0);
}

core::servo::ServoSettings settingsOf(const QString& method)
{
    core::servo::ServoSettings settings;
    settings.method = method.toStdString();
    return settings;
}

/// A rig that drills a layered tooth of this many nodes a side.
struct ReplayedDrilling : support::Rig
{
    explicit ReplayedDrilling(int side, const core::servo::ServoSettings& wanted = {}) : Rig(wanted)
    {
        drill(layeredTooth(side));
    }
};

session::SessionCommand undoOrRedo(Rng& rng)
{
    if (rng.below(2) == 0)
        return session::Undo{};
    return session::Redo{};
}

template <class... Commands>
std::vector<session::SessionCommand> commands(Commands&&... each)
{
    std::vector<session::SessionCommand> all;
    (all.emplace_back(std::forward<Commands>(each)), ...);
    return all;
}

/// Returns random commands, valid and invalid. In most ticks there are none.
std::vector<session::SessionCommand> anything(Rng& rng, const core::servo::ServoSettings& settings,
                                              const std::shared_ptr<const terrain::ToothAnatomy>& anatomy,
                                              std::uint64_t& generation)
{
    switch (rng.below(250)) {
    case 0:
        return commands(session::Redo{});
    case 1:
        return commands(session::Reload{});
    case 2:
        return commands(core::servo::SetBur{static_cast<std::uint8_t>(rng.below(4))});
    case 3:
        return commands(core::servo::SetDrill{rng.below(4) != 0});
    case 4:
    case 5:
    case 6:
        return commands(session::Undo{});
    case 7:
        // Several steps at once, often between two ticks of the session.
        return commands(undoOrRedo(rng), undoOrRedo(rng), undoOrRedo(rng), undoOrRedo(rng));
    case 8:
        if (rng.below(8) == 0)
            return commands(session::ReplaceTooth{std::make_unique<terrain::Tooth>(anatomy), ++generation});
        return {};
    case 9:
        return commands(core::servo::SetHandpiece{static_cast<std::uint8_t>(rng.below(4))});  // 3: does not exist
    case 10:
        // Another tooth with other servo settings: softer, and with fewer handpieces.
        if (rng.below(8) == 0) {
            core::servo::ServoSettings other = settings;
            other.hardness = settings::findHardnessPreset(rng.below(2) == 0 ? "typodont" : "natural").value();
            other.handpieces.resize(1 + static_cast<std::size_t>(rng.below(3)));
            return commands(session::ReplaceTooth{std::make_unique<terrain::Tooth>(anatomy),
                                                  ++generation,
                                                  {},
                                                  core::servo::makeServoTick(other).value()});
        }
        return {};
    case 11:
    case 12:
        return commands(core::servo::SetParameter{static_cast<std::uint8_t>(rng.below(core::servo::kServoNumbers + 2)),
                                                  static_cast<float>(rng.below(400)) * 0.01F});
    default:
        return {};
    }
}

}  // namespace

class TestReplay : public QObject
{
    Q_OBJECT
private slots:
    /// Enamel becomes softer and the spring stiffer during a stroke. The replay must change at the same tick.
    void changesOfFeel()
    {
        ReplayedDrilling rig(64);
        rig.lean(0.0, 0.0, 1.0, 100);
        const double before = removedMm3(rig);
        const core::servo::ServoParameters was = core::servo::parametersOf({});
        for (std::size_t k = 0; k < core::servo::kServoNumbers; ++k)
            rig.send(core::servo::SetParameter{static_cast<std::uint8_t>(k), static_cast<float>(0.9 * was.at(k))});
        rig.send(core::servo::SetParameter{2, 20.0F});  // the removal rate of enamel
        rig.send(core::servo::SetParameter{2, std::nanf("")});
        rig.send(core::servo::SetParameter{99, 1.0F});
        rig.lean(0.0, 0.0, 1.0, 100);
        QVERIFY(removedMm3(rig) > 4.0 * before);
        compareWithLive(rig);
        const Recording made = rig.session->recordingSoFar().value();
        QVERIFY(made.isRetuned());
        int told = 0;
        made.forEach([&](const ServoEvent& event) { told += event.kind == ServoEvent::Kind::Number ? 1 : 0; });
        QCOMPARE(told, static_cast<int>(core::servo::kServoNumbers) + 1);  // an invalid value is not recorded
    }

    void aBurAtHalfItsSpeedTurnsAndCutsAtHalfThePace()
    {
        ReplayedDrilling full(100);
        ReplayedDrilling half(100);
        half.device.pedal = true;
        half.device.speedPercent = 50;
        for (support::Rig* rig : {static_cast<support::Rig*>(&full), static_cast<support::Rig*>(&half)})
            rig->lean(0.0, 0.0, 1.0, 30);  // shallow enough that the hand does not stop
        const double ratio = removedMm3(half) / removedMm3(full);
        QVERIFY2(ratio > 0.3 && ratio < 0.7, qPrintable(QString::number(ratio)));
        for (support::Rig* rig : {static_cast<support::Rig*>(&full), static_cast<support::Rig*>(&half)}) {
            rig->device.tipMm.z = 5.0F;
            rig->run(1);
        }
        QCOMPARE(half.servo->state().burRpm, 0.5 * full.servo->state().burRpm);
    }

    /// The recording holds the speed that the pedal set, so that the replay cuts the same tooth.
    void aPedalChangesTheSpeed()
    {
        ReplayedDrilling rig(100);
        rig.device.pedal = true;
        support::RestlessHand hand(35);
        for (const std::uint8_t percent : std::to_array<std::uint8_t>({100, 60, 61, 5, 5, 80})) {
            rig.device.speedPercent = percent;
            rig.follow(hand, 300);
            rig.device.pedal = false;
            rig.follow(hand, 50);
            rig.device.pedal = true;
        }
        compareWithLive(rig);
        rig.send(session::Reload{});
        rig.follow(hand, 300);
        compareWithLive(rig);
        int told = 0;
        rig.session->recordingSoFar().value().forEach(
            [&](const ServoEvent& event) { told += event.kind == ServoEvent::Kind::Speed ? 1 : 0; });
        QCOMPARE(told, 4);
        // A new attempt begins at the current speed.
        rig.drill(layeredTooth(64), 2);
        rig.follow(hand, 300);
        compareWithLive(rig);
    }

    void plainDrilling_data()
    {
        support::rows<QString, int>("method", {"continuous", "lattice", "penalty"}, "side", {64, 150, 256});
    }

    void plainDrilling()
    {
        QFETCH(QString, method);
        QFETCH(int, side);
        ReplayedDrilling rig(side, settingsOf(method));
        support::RestlessHand hand(static_cast<std::uint64_t>(side));
        rig.follow(hand, 3000);
        QVERIFY2(removedMm3(rig) > 0.2, qPrintable(QString::number(removedMm3(rig))));
        compareWithLive(rig);
    }

    /// Uses every bur, one after the other, in one attempt.
    void aChangeOfBurIsReplayed()
    {
        ReplayedDrilling rig(100);
        const std::size_t count = core::bur::burs().size();
        for (std::size_t bur = 0; bur < count; ++bur) {
            rig.send(core::servo::SetBur{static_cast<std::uint8_t>(bur)});
            const double along = -3.0 + 6.0 * static_cast<double>(bur) / static_cast<double>(count);
            rig.lean(along, 1.0 - 0.5 * static_cast<double>(bur % 5), 1.5, 120);
            QCOMPARE(std::size_t{rig.servo->state().burIndex}, bur);
            rig.lift();
        }
        QVERIFY2(removedMm3(rig) > 3.0, qPrintable(QString::number(removedMm3(rig))));
        compareWithLive(rig);
    }

    void everythingElseThatHappens()
    {
        ReplayedDrilling rig(100, withHandpieces());
        for (std::uint8_t bur = 0; bur < 4; ++bur) {
            rig.send(core::servo::SetBur{bur});
            rig.lean(0.8 * bur - 1.2, 0.3, 1.5, 200);
            rig.device.present = false;  // lost in the middle of a cut
            rig.run(30);
            rig.device.present = true;
            rig.lean(0.8 * bur - 1.0, 0.3, 1.5, 100);
            rig.device.tipMm.x = std::nanf("");
            rig.run(3);
            rig.device.tipMm = {2.0e9F, 0.0F, 0.0F};
            rig.run(3);
            rig.lean(0.8 * bur - 1.0, 0.3, 1.5, 50);
            rig.send(core::servo::SetDrill{false});
            rig.send(core::servo::SetHandpiece{static_cast<std::uint8_t>(bur % 3)});
            rig.lean(0.8 * bur - 1.0, 0.3, 1.5, 50);
            rig.send(core::servo::SetDrill{true});
            if (bur % 2 == 0)
                rig.lift();
        }
        QVERIFY(removedMm3(rig) > 0.3);
        compareWithLive(rig);
    }

    void undoAtOnceAfterTheLastTick()
    {
        ReplayedDrilling rig(64);
        const std::uint64_t uncut = rig.liveHash();
        rig.lean(0.0, 0.0, 2.0, 100);
        rig.lift();
        const std::uint64_t cut = rig.liveHash();
        std::vector<session::SessionCommand> steps = commands(session::Undo{}, session::Redo{}, session::Reload{});
        const std::array hashes{uncut, cut, uncut};
        for (std::size_t k = 0; k < hashes.size(); ++k) {
            rig.send(std::move(steps[k]));
            rig.settle();
            rig.servo->tick(rig.period);  // receives the restored tooth
            QCOMPARE(rig.liveHash(), hashes[k]);
            compareWithLive(rig);
        }
    }

    void missedPeriods()
    {
        ReplayedDrilling rig(100);
        support::RestlessHand hand(9);
        Rng rng(10);
        for (int n = 0; n < 1500; ++n) {
            rig.device.tipMm = hand.next();
            rig.run(1, std::chrono::milliseconds(rng.below(10) == 0 ? 1 + rng.below(200) : 1));
        }
        QVERIFY(rig.uiLinks->servo.latest().missedPeriods > 1000);
        QVERIFY(removedMm3(rig) > 0.1);
        compareWithLive(rig);
    }

    void stormOfCommands_data()
    {
        support::columns<QString, int, int>("method", "side", "seed");
        for (const int seed : {1, 2, 3}) {
            QTest::addRow("64, seed %d", seed) << "continuous" << 64 << seed;
            QTest::addRow("150, seed %d", seed) << "continuous" << 150 << 10 + seed;
        }
        QTest::newRow("256") << "continuous" << 256 << 21;
        QTest::newRow("lattice") << "lattice" << 64 << 22;
        QTest::newRow("penalty") << "penalty" << 64 << 23;
    }

    void stormOfCommands()
    {
        QFETCH(QString, method);
        QFETCH(int, side);
        QFETCH(int, seed);
        core::servo::ServoSettings settings = withHandpieces();
        settings.method = method.toStdString();
        ReplayedDrilling rig(side, settings);
        const auto anatomy = rig.live().anatomy;
        Rng rng(static_cast<std::uint64_t>(seed));
        support::RestlessHand hand(static_cast<std::uint64_t>(seed) + 100);
        std::uint64_t generation = 1;
        for (int n = 0; n < 2000; ++n) {
            rig.device.tipMm = hand.next();
            rig.device.present = rng.below(100) != 0;
            rig.run(1, std::chrono::milliseconds(rng.below(30) == 0 ? 7 : 1));
            for (session::SessionCommand& command : anything(rng, settings, anatomy, generation))
                rig.send(std::move(command));
            if (n % 500 == 499)
                compareWithLive(rig);
        }
        rig.lift();
        compareWithLive(rig);
        QCOMPARE(rig.mirrorHash(), rig.liveHash());
    }

    void resumedAgainAndAgain_data()
    {
        support::columns<QString, int>("method", "side");
        QTest::newRow("64") << "continuous" << 64;
        QTest::newRow("150") << "continuous" << 150;
        QTest::newRow("lattice") << "lattice" << 64;
        QTest::newRow("penalty") << "penalty" << 64;
    }

    /// The program ends at any point, and another resumes the attempt with the hand at any place.
    void resumedAgainAndAgain()
    {
        QFETCH(QString, method);
        QFETCH(int, side);
        Rng rng(static_cast<std::uint64_t>(side));
        support::RestlessHand hand(31);
        std::optional<Recording> left;
        for (int life = 0; life < 6; ++life) {
            support::Rig rig(settingsOf(method));
            if (life % 2 == 1) {  // the program has done something else before
                rig.drill(layeredTooth(side));
                rig.follow(hand, 300);
            }
            if (left)
                rig.resume(*left, 2);
            else
                rig.open(layeredTooth(side), 2);
            const std::uint64_t begun = rig.liveHash();
            rig.send(core::servo::SetDrill{true});
            for (int n = 0; n < 1200 || rig.liveHash() == begun; ++n) {
                rig.device.tipMm = hand.next();
                rig.device.present = rng.below(100) != 0;
                rig.run(1, std::chrono::milliseconds(rng.below(30) == 0 ? 7 : 1));
                if (rng.below(200) == 0)
                    rig.send(undoOrRedo(rng));
            }
            compareWithLive(rig);
            left = Recording::fromBytes(rig.session->recordingSoFar()->toBytes()).value();
        }
    }

    void secondToothHasItsOwnRecording()
    {
        ReplayedDrilling rig(64);
        rig.send(core::servo::SetBur{2});
        rig.lean(0.0, 0.0, 2.0, 200);
        // A new tooth in the middle of a cut. Bur and drill stay as they were.
        rig.open(layeredTooth(100), 2);
        QVERIFY(rig.servo->state().drillOn);
        QCOMPARE(rig.servo->state().burIndex, 2);
        rig.lift();
        rig.lean(0.5, 0.0, 2.0, 300);
        QVERIFY(removedMm3(rig) > 0.02);
        compareWithLive(rig);
        QCOMPARE(rig.session->recordingSoFar()->anatomy()->grid.side, 100);
    }

    void sameToothAgainHasItsOwnRecording()
    {
        ReplayedDrilling rig(64);
        const auto anatomy = rig.live().anatomy;
        rig.lean(0.0, 0.0, 2.0, 200);
        rig.settle();
        const std::uint64_t before = rig.session->recordingSoFar()->ticks();
        // The session has opened the new tooth, but the servo has not received it yet. The recording is still that of
        // the old attempt, without events of the new one.
        rig.send(session::ReplaceTooth{std::make_unique<terrain::Tooth>(anatomy), 2});
        rig.settle();
        const Recording between = rig.session->recordingSoFar().value();
        QCOMPARE(between.ticks(), before);
        QVERIFY(recording::replay(between)->agreesWithWitness);
        rig.lean(0.5, 0.0, 2.0, 100);
        QVERIFY(rig.session->recordingSoFar()->ticks() <= 100);
        compareWithLive(rig);
    }

    void recordingEndsWhereTicksAreMissing()
    {
        ReplayedDrilling rig(64);
        rig.lean(0.0, 0.0, 1.0, 100);
        rig.lift();
        const std::uint64_t kept = rig.liveHash();
        // The session sleeps for longer than the queue of events lasts.
        for (int n = 0; n < 20000; ++n) {
            rig.device.tipMm = {0.5F, 0.0F, n % 400 < 200 ? 2.0F : -0.4F};
            rig.servo->tick(rig.period);
        }
        QVERIFY((rig.uiLinks->servo.latest().health & core::servo::kRecordGap) != 0);
        // It wakes, and the student continues, undoes twice and cuts again.
        rig.lift();
        rig.give(session::Undo{});
        rig.give(session::Undo{});
        QVERIFY(rig.liveHash() == kept || rig.session->toothSoFar().has_value());
        rig.lean(-0.5, 0.5, 2.0, 100);
        rig.lift();
        // The recording is valid up to the gap: it can be read and replayed, and contains nothing that cannot be
        // reproduced.
        const Recording soFar = rig.session->recordingSoFar().value();
        QVERIFY(soFar.ticks() < rig.servo->state().tick);
        const auto read = Recording::fromBytes(soFar.toBytes());
        QVERIFY(support::succeeds(read));
        QVERIFY(recording::replay(*read)->agreesWithWitness);
        // A new tooth is recorded again.
        rig.open(layeredTooth(64), 2);
        QVERIFY((rig.uiLinks->servo.latest().health & core::servo::kRecordGap) == 0);
        rig.lean(0.0, 0.0, 2.0, 100);
        compareWithLive(rig);
    }

    void wrongWitnessIsNoticed()
    {
        ReplayedDrilling rig(64);
        rig.lean(0.0, 0.0, 2.0, 100);
        rig.lift();
        Recording soFar = rig.session->recordingSoFar().value();
        QVERIFY(recording::replay(soFar)->agreesWithWitness);
        const std::uint64_t hash = rig.liveHash();
        const std::uint64_t end = soFar.ticks();
        // The right hash; the hash of another tooth; a right hash at a wrong tick; at the first tick; at a tick after
        // the end.
        for (const auto& [tick, stateHash, isRight] : {std::tuple(end, hash, true),
                                                       {end, hash ^ 1U, false},
                                                       {std::uint64_t{10}, hash, false},
                                                       {std::uint64_t{0}, hash, false},
                                                       {end + 1, hash, false}}) {
            soFar.setWitness({tick, stateHash});
            QCOMPARE(recording::replay(soFar)->agreesWithWitness, isRight);
        }
    }

    void emptyAttempt()
    {
        const auto anatomy = layeredTooth(64);
        const auto outcome = recording::replay(Recording({}, anatomy));
        QVERIFY(outcome);
        QVERIFY(outcome->agreesWithWitness);
        QCOMPARE(outcome->stateHash, terrain::stateHash(terrain::Tooth(anatomy)));
        QCOMPARE(outcome->state.tick, 0U);
    }
};

CUSP_TEST(TestReplay)
#include "tst_replay.moc"
