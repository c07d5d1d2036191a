// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <atomic>
#include <cmath>
#include <map>
#include <set>
#include <thread>

#include <glm/geometric.hpp>

#include "core/history/MomentId.h"
#include "core/recording/Replay.h"
#include "core/servo/ServoState.h"
#include "core/session/SessionChannels.h"
#include "tests/support/Rig.h"
#include "tests/support/Scenes.h"
#include "tests/support/SyntheticTooth.h"

using namespace core;
using namespace core::session;
using namespace core::servo;

namespace {

/// A rig with the drill on over a small block of enamel.
struct Drilling : support::Rig
{
    explicit Drilling(const SessionMemory& memory = {}) : Rig({}, std::chrono::milliseconds(1), memory)
    {
        drill(support::smallBlock());
    }
};

/// Makes one stroke at (x, 0).
void stroke(support::Rig& rig, double x)
{
    rig.lean(x, 0.0, 2.0, 60);
    rig.lift();
}

const SessionState& state(support::Rig& rig)
{
    return rig.uiLinks->session.latest();
}

ReplaceTooth anotherBlock(std::uint64_t generation)
{
    return {std::make_unique<terrain::Tooth>(support::smallBlock()), generation};
}

std::uint64_t uncutHash()
{
    return terrain::stateHash(terrain::Tooth(support::smallBlock()));
}

/// Returns the state hash of a small block with this top map.
std::uint64_t hashOf(std::vector<float> top)
{
    return terrain::stateHash(terrain::restored(support::smallBlock(), std::move(top)));
}

/// Returns whether the recording replays without a mismatch and ends with this hash.
bool replaysTo(const recording::Recording& made, std::uint64_t hash)
{
    const auto outcome = recording::replay(made);
    return outcome->agreesWithWitness && outcome->stateHash == hash;
}

/// Applies the patches that the loop sends, a group at a time, as a view does.
struct View
{
    history::TiledHeights heights;
    std::vector<TilePatch> group;
    std::size_t patches = 0;

    explicit View(const terrain::ToothAnatomy& anatomy) : heights(anatomy.grid, anatomy.top) {}
    void look(support::Rig& rig)
    {
        rig.session->tick(rig.period);
        for (TilePatch patch; rig.uiLinks->patches.tryPop(patch); ++patches) {
            group.push_back(patch);
            if (!patch.last)
                continue;
            for (const TilePatch& one : group)
                heights.setTile(one.tileX, one.tileY, one.top);
            group.clear();
        }
    }
};

}  // namespace

class TestSessionLoop : public QObject
{
    Q_OBJECT
private slots:
    void onePressIsOneStep()
    {
        Drilling rig;
        const std::uint64_t uncut = rig.liveHash();
        rig.device.pedal = true;
        // Makes two cuts with a long move through the air between them, with the pedal pressed all the time.
        rig.lean(-1.0, 0.0, 2.0, 300);
        rig.device.tipMm.z = 2.0F;
        rig.run(3 * StrokeDetector::kPauseTicks);
        rig.lean(1.0, 0.0, 2.0, 300);
        rig.device.tipMm.z = 2.0F;
        rig.run(2 * StrokeDetector::kPauseTicks);
        rig.device.pedal = false;
        rig.run(2 * StrokeDetector::kPauseTicks);
        rig.settle();
        QCOMPARE(state(rig).undoSteps, 1);
        QVERIFY(rig.liveHash() != uncut);
        rig.give(Undo{});
        QCOMPARE(rig.liveHash(), uncut);
        QCOMPARE(rig.mirrorHash(), uncut);
    }

    void undoAndRedoGoStrokeByStroke()
    {
        Drilling rig;
        std::vector<std::uint64_t> hashes{rig.liveHash()};
        for (int n = 0; n < 4; ++n) {
            stroke(rig, n - 2.0);
            hashes.push_back(rig.liveHash());
            QCOMPARE(state(rig).undoSteps, n + 1);
            QCOMPARE(state(rig).strokes, n + 1);
        }
        const history::MomentId ofLast = rig.session->historySoFar().back().id;
        for (std::size_t n = 4; n-- > 0;) {
            rig.give(Undo{});
            QCOMPARE(rig.liveHash(), hashes[n]);
            QCOMPARE(rig.mirrorHash(), hashes[n]);
            QCOMPARE(state(rig).undoSteps, static_cast<int>(n));
            QCOMPARE(state(rig).redoSteps, static_cast<int>(4 - n));
        }
        rig.give(Undo{});  // one more than there are steps
        QCOMPARE(rig.liveHash(), hashes[0]);
        QCOMPARE(state(rig).removedMm3[1], 0.0);
        for (std::size_t n = 1; n <= 4; ++n) {
            rig.give(Redo{});
            QCOMPARE(rig.liveHash(), hashes[n]);
        }
        QVERIFY(state(rig).removedMm3[1] > 0.01);
        // A stroke after an undo begins a branch. There is nothing to redo, and GoTo reaches the other branch.
        rig.give(Undo{});
        stroke(rig, 2.0);
        QCOMPARE(state(rig).redoSteps, 0);
        const std::uint64_t now = rig.liveHash();
        rig.give(Redo{});
        QCOMPARE(rig.liveHash(), now);
        rig.give(GoTo{ofLast});
        QCOMPARE(rig.liveHash(), hashes[4]);
        QCOMPARE(rig.mirrorHash(), hashes[4]);
        QVERIFY(replaysTo(rig.session->recordingSoFar().value(), hashes[4]));
    }

    void withAPedalTheBurTurnsWhileItIsDown()
    {
        Drilling rig;
        rig.device.pedal = false;
        rig.run(20);
        const ServoState& servo = rig.uiLinks->servo.latest();
        QVERIFY(!servo.drillOn && servo.drillSwitchedOn);
        rig.lean(0.0, 0.0, 1.0, 200);
        QCOMPARE(rig.servo->state().removedMm3[1], 0.0);
        rig.device.pedal = true;
        rig.lean(0.0, 0.0, 1.0, 200);
        const double removed = rig.servo->state().removedMm3[1];
        QVERIFY(removed > 0.001);
        rig.give(SetDrill{false});
        rig.lean(0.0, 0.0, 1.0, 200);
        QVERIFY(!rig.servo->state().drillOn);
        rig.lift();
        QVERIFY(replaysTo(rig.session->recordingSoFar().value(), rig.liveHash()));
    }

    void undoInMidStrokeTakesBackWhatIsCutSoFar()
    {
        Drilling rig;
        stroke(rig, -1.0);
        const std::uint64_t before = rig.liveHash();
        rig.lean(1.0, 0.0, 2.0, 64);
        rig.settle();
        const std::uint64_t half = rig.mirrorHash();
        QVERIFY(half != before);
        QCOMPARE(state(rig).undoSteps, 2);
        // The bur is lifted before the undo reaches the servo. What was cut in between is discarded.
        rig.send(Undo{});
        rig.settle();
        rig.device.tipMm.z = 5.0F;
        rig.run(40);
        QCOMPARE(rig.liveHash(), before);
        rig.send(Redo{});
        rig.run(40);
        QCOMPARE(rig.liveHash(), half);
    }

    void anyMomentIsAJumpAway()
    {
        Drilling rig;
        Rng rng(4);
        std::map<history::MomentId, std::uint64_t> hashes{{rig.session->historySoFar().front().id, rig.liveHash()}};
        for (int n = 0; n < 60; ++n) {
            if (n % 3 == 2) {
                const auto all = rig.session->historySoFar();
                const history::MomentId id = all[static_cast<std::size_t>(rng.below(static_cast<int>(all.size())))].id;
                rig.give(GoTo{id});
                QCOMPARE(rig.liveHash(), hashes.at(id));
            } else {
                stroke(rig, rng.uniform(-3.0, 3.0));
                hashes[rig.session->historySoFar().back().id] = rig.liveHash();
            }
        }
        const std::uint64_t before = rig.liveHash();
        rig.give(GoTo{history::MomentId{12345}});  // there is no such moment
        QCOMPARE(rig.liveHash(), before);
        const auto all = rig.session->historySoFar();
        QCOMPARE(all.size(), 41U);
        for (const history::MomentInfo& moment : all)
            QCOMPARE(hashOf(rig.session->momentHeights(moment.id)), hashes.at(moment.id));
        QVERIFY(rig.session->momentHeights(history::MomentId{12345}).empty());
        QVERIFY(recording::replay(rig.session->recordingSoFar().value())->agreesWithWitness);
    }

    void historyTellsWhatWasRemoved()
    {
        QVERIFY(support::Rig().session->historySoFar().empty());
        Drilling rig;
        rig.run(20);
        const std::uint64_t version = state(rig).historyVersion;
        rig.run(100);
        QCOMPARE(state(rig).historyVersion, version);
        stroke(rig, -1.0);
        QVERIFY(state(rig).historyVersion != version);
        const std::uint64_t cut = rig.liveHash();
        const auto after = rig.session->historySoFar();
        QCOMPARE(after.size(), 2U);
        QVERIFY(after[0].removed == history::Removed{});
        QVERIFY(after[1].isCurrent);
        QCOMPARE(after[1].parent, after[0].id);
        QCOMPARE(after[1].removed.volumesMm3, state(rig).removedMm3);
        // A moment is created when the pause after the stroke is over.
        const double ticksS = 0.001 * static_cast<double>(rig.servo->state().tick);
        QVERIFY2(after[1].seconds > 0.15 && after[1].seconds <= ticksS, qPrintable(QString::number(after[1].seconds)));
        // A restart is a step that can be undone. A second restart has no effect.
        for (int n = 0; n < 2; ++n) {
            rig.give(Reload{});
            QCOMPARE(rig.liveHash(), uncutHash());
            QCOMPARE(rig.mirrorHash(), uncutHash());
            QCOMPARE(state(rig).undoSteps, 2);
        }
        const auto whole = rig.session->historySoFar();
        QCOMPARE(whole.size(), 3U);
        QCOMPARE(whole[2].parent, whole[1].id);
        QVERIFY(whole[2].removed == history::Removed{});
        QVERIFY(whole[2].seconds >= whole[1].seconds);
        rig.give(Undo{});
        QCOMPARE(rig.liveHash(), cut);
    }

    void patchesOfAnOlderToothAreIgnored()
    {
        Drilling rig;
        stroke(rig, 0.0);
        // The servo continues to cut while the session has already sent the restored tooth.
        rig.send(Undo{});
        for (int n = 0; n < 100; ++n) {
            rig.device.tipMm = {1.0F, 0.0F, -0.5F};
            if (n == 50)
                rig.session->tick(rig.period);
            if (n < 60)
                rig.servo->tick(rig.period);
        }
        rig.device.tipMm.z = 5.0F;
        rig.lift();
        QCOMPARE(rig.mirrorHash(), rig.liveHash());
    }

    void newToothWhileTheOldOneIsCut()
    {
        Drilling rig;
        rig.lean(0.0, 0.0, 2.0, 30);
        rig.send(anotherBlock(7));
        // The bur is inside the new tooth, pressed and turning. It has no effect until it has been outside.
        rig.lean(0.0, 0.0, 2.0, 100);
        QVERIFY((rig.uiLinks->servo.latest().health & kBegunInside) != 0);
        QCOMPARE(rig.uiLinks->servo.latest().forceN, glm::dvec3(0.0));
        QCOMPARE(rig.liveHash(), uncutHash());
        rig.lift();
        QCOMPARE(rig.uiLinks->servo.latest().health & kBegunInside, 0U);
        rig.lean(0.0, 0.0, 2.0, 100);
        rig.lift();
        QCOMPARE(state(rig).toothGeneration, 7U);
        QCOMPARE(rig.uiLinks->servo.latest().toothGeneration, 7U);
        QCOMPARE(rig.mirrorHash(), rig.liveHash());
        QCOMPARE(state(rig).strokes, 1);
        rig.give(Undo{});
        QCOMPARE(rig.liveHash(), uncutHash());
    }

    void commandsWithoutAToothDoNothing()
    {
        support::Rig rig;
        rig.send(Undo{});
        rig.send(Redo{});
        rig.send(Reload{});
        rig.send(SetBur{2});
        rig.run(30);
        QVERIFY(!rig.session->toothSoFar().has_value());
        QVERIFY(!rig.session->recordingSoFar().has_value());
        rig.send(anotherBlock(1));  // a tooth that is never used is freed
    }

    void aHoleIsToldUntilItIsTakenBack()
    {
        support::Block thin;
        thin.bottomMm = -0.4;
        support::Rig rig;
        rig.drill(support::makeBlock(thin));
        QVERIFY(!state(rig).perforated);
        rig.lean(0.0, 0.0, 2.0, 1500);
        rig.lift();
        QVERIFY(state(rig).perforated);
        rig.give(Undo{});
        QVERIFY(!state(rig).perforated);
    }

    void aSideGroundOffIsNoHole()
    {
        support::Block disc;
        disc.bottomMm = -0.4;
        disc.topMm = [](double x, double y) { return x * x + y * y < 9.0 ? 0.0 : std::nan(""); };
        terrain::Tooth tooth(support::makeBlock(disc));
        const auto remove = [&](glm::dvec2 middle, double radius) {
            support::eachNode(tooth.grid(), [&](std::size_t k, const glm::dvec2& at) {
                if (glm::distance(at, middle) < radius)
                    support::cutThrough(tooth, k);
            });
        };
        QVERIFY(terrain::perforations(tooth).empty());
        remove({3.0, 0.0}, 1.0);
        QVERIFY(terrain::perforations(tooth).empty());
        remove({-1.0, 0.0}, 0.2);
        QVERIFY(!terrain::perforations(tooth).empty());
    }

    void depthIsToldOverTheToothOnly()
    {
        support::Block crown;
        // Flat on top, with a slope of 80 degrees from 2 mm on, and an overhang with 4 mm of air below its rim.
        crown.bottomMm = -6.0;
        crown.topMm = [](double x, double y) {
            const double r = std::sqrt(x * x + y * y);
            return r < 2.0 ? 0.0 : r < 2.7 ? -5.67 * (r - 2.0) : std::nan("");
        };
        support::Rig rig;
        rig.drill(support::makeBlock(crown));
        rig.lean(0.0, 0.0, 2.0, 400);
        const ServoState inside = rig.uiLinks->servo.latest();
        QVERIFY(inside.hasDepth);
        QVERIFY(inside.depthMm > 0.2);
        rig.lift();
        for (const double x : {2.4, 3.2}) {
            rig.lean(x, 0.0, 2.0, 400);
            QVERIFY2(!rig.uiLinks->servo.latest().hasDepth, qPrintable(QString::number(x)));
            rig.lift();
        }
        // The bur is beside the crown, below the remaining part of its side.
        rig.device.tipMm = {2.4F, 0.0F, -12.0F};
        rig.open(support::makeBlock(crown), 2);
        rig.run(20);
        QVERIFY(!rig.uiLinks->servo.latest().hasDepth);
    }

    void viewHearsOfEveryChange()
    {
        Drilling rig;
        View view(*rig.live().anatomy);
        for (int n = 0; n < 3000; ++n) {
            rig.device.tipMm = {static_cast<float>(2.0 * std::sin(0.01 * n)), 0.5F, n % 600 < 300 ? -0.6F : 3.0F};
            rig.servo->tick(rig.period);
            if (n % 700 == 650)
                rig.send(Undo{});
            if (n % 900 == 850)
                rig.send(Redo{});
            if (n % 10 == 0)
                view.look(rig);
        }
        rig.device.tipMm.z = 5.0F;
        for (int n = 0; n < 300; ++n)
            rig.servo->tick(rig.period);
        view.look(rig);
        QCOMPARE(view.heights.flat(), rig.live().top);
    }

    void attemptSoFarFromAnotherThread()
    {
        Drilling rig;
        std::atomic<bool> stop{false};
        std::atomic<int> disagreements{0};
        std::atomic<int> looks{0};
        std::thread other([&] {
            while (!stop) {
                const auto soFar = rig.session->recordingSoFar();
                if (soFar && soFar->ticks() < 4000 && !recording::replay(*soFar)->agreesWithWitness)
                    ++disagreements;
                ++looks;
            }
        });
        support::RestlessHand hand(2);
        for (int n = 0; n < 2000 || looks < 3; ++n) {
            rig.device.tipMm = hand.next();
            if (n % 300 == 299)
                rig.send(Undo{});
            rig.run(1);
        }
        stop = true;
        other.join();
        QCOMPARE(disagreements.load(), 0);
    }

    /// The tooth is the same with and without a history.
    void nothingIsRememberedWhereNobodyAsks()
    {
        Drilling rig({false, 0});
        Drilling other;
        for (int n = 0; n < 6; ++n) {
            stroke(rig, 0.5 * n - 2.0);
            stroke(other, 0.5 * n - 2.0);
        }
        QVERIFY(!rig.session->recordingSoFar());
        QCOMPARE(state(rig).recordedS, 0.0);
        QCOMPARE(state(rig).strokes, 6);
        QCOMPARE(state(rig).undoSteps, 1);
        QCOMPARE(rig.mirrorHash(), rig.liveHash());
        QCOMPARE(other.liveHash(), rig.liveHash());
        QVERIFY(other.session->recordingSoFar());
        QCOMPARE(state(other).undoSteps, 6);
    }

    /// Then the window ends it. A program may be left open for a day.
    void anAttemptIsFullAfterSixHours()
    {
        constexpr std::chrono::milliseconds kStep(50);
        support::Rig rig({}, kStep);
        rig.open(support::smallBlock());
        QVERIFY(!state(rig).isFull);
        rig.run(static_cast<int>(recording::kLongestAttempt / kStep), kStep);
        rig.settle();
        QVERIFY(state(rig).isFull);
        rig.open(support::smallBlock(), 2);
        rig.settle();
        QVERIFY(!state(rig).isFull);
    }

    void lessonAidsAndNotesGoOnTheRecording()
    {
        support::Rig rig;
        rig.open(support::smallBlock());
        rig.run(30);
        // Aids and notes that are sent together with the next attempt belong to it, although its servo has not begun
        // yet.
        rig.send(ReplaceTooth{std::make_unique<terrain::Tooth>(support::smallBlock()), 2, "lesson é"});
        rig.send(SetAids{kRadiographAid | kMirrorAid});
        rig.send(AddNote{1});
        rig.run(30);
        rig.send(AddNote{~std::uint64_t{0}});
        rig.run(30);
        const recording::Recording made = rig.session->recordingSoFar().value();
        QCOMPARE(QString::fromStdString(made.lesson()), QStringLiteral("lesson é"));
        std::vector<ServoEvent::Kind> kinds;
        std::vector<std::uint64_t> values;
        std::vector<std::uint64_t> toldAt;
        std::uint64_t ticks = 0;
        made.forEach([&](const ServoEvent& event) {
            ticks += event.kind == ServoEvent::Kind::Tick ? 1 : 0;
            if (event.kind != ServoEvent::Kind::Aids && event.kind != ServoEvent::Kind::Note)
                return;
            kinds.push_back(event.kind);
            values.push_back(event.value);
            toldAt.push_back(ticks);
        });
        QVERIFY((kinds == std::vector{ServoEvent::Kind::Aids, ServoEvent::Kind::Note, ServoEvent::Kind::Note}));
        QCOMPARE(values, (std::vector<std::uint64_t>{kRadiographAid | kMirrorAid, 1, ~std::uint64_t{0}}));
        QVERIFY2(toldAt[1] == 0 && toldAt[2] >= 10 && toldAt[2] <= 40, qPrintable(QString::number(toldAt[2])));
        // Notes of an older attempt stay with that attempt.
        rig.send(AddNote{5});
        rig.send(anotherBlock(3));
        rig.run(30);
        rig.session->recordingSoFar()->forEach(
            [](const ServoEvent& event) { QVERIFY(event.kind != ServoEvent::Kind::Note); });
        QVERIFY(rig.session->recordingSoFar()->lesson().empty());
    }

    void anotherToothMayBringAnotherServo()
    {
        const auto removedMm3 = [](support::Rig& rig) {
            rig.lean(0.5, 0.0, 2.0, 300);
            rig.lift();
            return rig.servo->state().removedMm3[1];
        };
        support::Rig rig;
        rig.open(support::smallBlock());
        rig.send(SetBur{2});
        rig.send(SetDrill{true});
        const double usual = removedMm3(rig);

        ServoSettings softer;
        softer.hardness = settings::findHardnessPreset("typodont").value();
        softer.handpieces.push_back(settings::findHandpiece("low-speed").value());
        ReplaceTooth withServo = anotherBlock(2);
        withServo.servo = makeServoTick(softer).value();
        rig.give(std::move(withServo));
        // Bur and drill stay as they were.
        QCOMPARE(int{rig.servo->state().burIndex}, 2);
        QVERIFY(rig.servo->state().drillOn);
        const double soft = removedMm3(rig);
        QVERIFY2(soft > 1.5 * usual, qPrintable(QString("%1, %2").arg(soft).arg(usual)));
        QVERIFY(rig.session->recordingSoFar()->settings() == softer);

        // The slow handpiece cuts less, and a tooth without a servo of its own is cut by the previous one.
        rig.send(anotherBlock(3));
        rig.give(SetHandpiece{1});
        QCOMPARE(int{rig.servo->state().handpieceIndex}, 1);
        const double slow = removedMm3(rig);
        QVERIFY2(slow < 0.3 * soft && slow > 0.0, qPrintable(QString("%1, %2").arg(slow).arg(soft)));
        const recording::Recording made = rig.session->recordingSoFar().value();
        QVERIFY(made.settings() == softer);
        QVERIFY(replaysTo(made, rig.liveHash()));
        QCOMPARE(int{recording::replay(made)->state.handpieceIndex}, 1);

        // An attempt that was begun with another servo continues with that servo.
        Drilling usualRig;
        usualRig.resume(made, 2);
        QVERIFY(usualRig.session->recordingSoFar()->settings() == softer);
        static_cast<void>(removedMm3(usualRig));
        QVERIFY(recording::replay(usualRig.session->recordingSoFar().value())->agreesWithWitness);
        // A servo that is never used is freed.
        withServo = anotherBlock(4);
        withServo.servo = makeServoTick({}).value();
        rig.send(std::move(withServo));
    }

    void anAttemptIsTakenUpAgain()
    {
        support::Rig first;
        first.drill(support::smallBlock(), 1, "lesson");
        first.send(SetBur{2});
        stroke(first, -1.0);
        first.lean(0.5, 0.0, 2.0, 77);  // ends in the middle of a stroke
        first.settle();
        const recording::Recording left = first.session->recordingSoFar().value();
        const std::uint64_t leftHash = recording::replay(left)->stateHash;

        // The second program has drilled another tooth meanwhile, and its bur is inside the tooth.
        Drilling second;
        second.lean(0.5, 0.0, 2.0, 40);
        second.resume(left, 2);
        QCOMPARE(second.servo->state().tick, left.ticks() + 1);
        QCOMPARE(second.mirrorHash(), leftHash);
        QCOMPARE(second.liveHash(), leftHash);
        QCOMPARE(state(second).toothGeneration, 2U);
        QVERIFY(std::abs(state(second).recordedS - 0.001 * static_cast<double>(left.ticks() + 1)) < 1.0e-9);
        second.lean(0.5, 0.0, 2.0, 50);
        second.lift();
        stroke(second, 1.5);
        const std::uint64_t now = second.liveHash();
        QVERIFY(now != leftHash);
        // Goes back to before the program ended, and forward again.
        second.send(Undo{});
        second.give(Undo{});
        second.give(Redo{});
        second.give(Redo{});
        QCOMPARE(second.liveHash(), now);
        stroke(second, 2.5);
        const auto read = recording::Recording::fromBytes(second.session->recordingSoFar()->toBytes());
        QVERIFY(read);
        QCOMPARE(read->lesson(), std::string("lesson"));
        QVERIFY(replaysTo(*read, second.liveHash()));
        int resumed = 0;
        read->forEach([&](const ServoEvent& event) { resumed += event.kind == ServoEvent::Kind::Resume ? 1 : 0; });
        QCOMPARE(resumed, 1);
    }

    void anAttemptThatEndedWithUndoIsTakenUpAgain()
    {
        Drilling first;
        stroke(first, -1.0);
        const std::uint64_t once = first.liveHash();
        stroke(first, 1.0);
        const std::uint64_t twice = first.liveHash();
        const std::uint64_t before = first.session->recordingSoFar()->events();
        first.give(Undo{});
        QCOMPARE(first.liveHash(), once);
        // The first program ends right after the undo, before another tick.
        recording::Recording left({}, support::smallBlock());
        first.session->recordingSoFar()->forEach([&, n = std::uint64_t{0}](const ServoEvent& event) mutable {
            if (n++ < before || event.kind == ServoEvent::Kind::Restore)
                left.append(event);
        });
        QCOMPARE(recording::replay(left)->stateHash, once);
        support::Rig second;
        second.resume(left);
        QCOMPARE(second.liveHash(), once);
        const recording::Recording made = second.session->recordingSoFar().value();
        QVERIFY(made.witness().has_value());
        QCOMPARE(made.witness()->stateHash, twice);
        QVERIFY(replaysTo(made, once));
        second.give(Redo{});
        QCOMPARE(second.liveHash(), twice);
    }

    void theMomentsOfAnAttemptComeBack()
    {
        Drilling rig;
        Rng rng(8);
        for (int n = 0; n < 40; ++n) {
            if (n % 5 == 2) {
                rig.give(Undo{});
            } else if (n % 5 == 3) {
                rig.give(Redo{});
                if (n == 33)
                    rig.give(Reload{});
            } else if (n % 5 == 4) {  // an undo and a redo during a stroke
                rig.lean(rng.uniform(-3.0, 3.0), 1.0, 2.0, 40);
                rig.give(Undo{});
                rig.send(Redo{});
                rig.lift();
            } else {
                stroke(rig, rng.uniform(-3.0, 3.0));
            }
        }
        const auto live = rig.session->historySoFar();
        const auto again = rebuild(rig.session->recordingSoFar().value()).value();
        const auto list = again->history.list();
        QCOMPARE(again->strokes, state(rig).strokes);
        QCOMPARE(hashOf(again->history.current().top.flat()), rig.liveHash());
        QCOMPARE(list.size(), live.size());
        std::multiset<std::uint64_t> known;
        std::multiset<std::uint64_t> rebuilt;
        for (std::size_t k = 0; k < list.size(); ++k) {
            QCOMPARE(list[k].tick, live[k].tick);
            QCOMPARE(list[k].parent, live[k].parent);  // ids are given in the same order
            QVERIFY(list[k].removed == live[k].removed);
            QVERIFY(std::abs(list[k].seconds - live[k].seconds) < 0.03);
            known.insert(hashOf(rig.session->momentHeights(live[k].id)));
            rebuilt.insert(hashOf(again->history.find(list[k].id)->top.flat()));
        }
        QVERIFY(rebuilt == known);
    }

    /// A resumed attempt has a pause as long as the time away, and slightly more.
    void timeElsewhereIsKnownAgain()
    {
        support::Rig rig;
        rig.open(support::smallBlock());
        rig.run(100);
        rig.send(AddNote{kRestNote});
        rig.run(700);
        const double before = rebuild(rig.session->recordingSoFar().value()).value()->restedS;
        QVERIFY2(std::abs(before - 0.7) < 0.05, qPrintable(QString::number(before)));
        rig.send(AddNote{kWorkNote});
        rig.run(400);
        const double after = rebuild(rig.session->recordingSoFar().value()).value()->restedS;
        QVERIFY2(after >= before && after - before < 0.05, qPrintable(QString::number(after)));
    }

    void theViewIsShownWhatWasCutBefore()
    {
        Drilling first;
        stroke(first, -1.0);
        stroke(first, 1.0);
        const auto resume = [&](std::uint64_t generation) {
            return ResumeAttempt{rebuild(first.session->recordingSoFar().value()).value(), generation};
        };
        support::Rig second;
        second.send(resume(3));
        View view(*support::smallBlock());
        view.look(second);
        QCOMPARE(view.heights.flat(), first.live().top);
        QVERIFY(view.patches < view.heights.tiles().size());
        second.send(resume(4));  // it is never used
    }
};

QTEST_APPLESS_MAIN(TestSessionLoop)
#include "tst_session_loop.moc"
