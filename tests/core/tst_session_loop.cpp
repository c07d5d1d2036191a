// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <atomic>
#include <cmath>
#include <map>
#include <set>
#include <thread>

#include <glm/geometric.hpp>

#include "core/recording/Replay.h"
#include "tests/support/Rig.h"
#include "tests/support/SyntheticTooth.h"

using namespace core;
using namespace core::session;

namespace {

/// One stroke at (x, 0).
void stroke(support::Rig& rig, double x)
{
    rig.lean(x, 0.0, 2.0, 60);
    rig.lift();
}

const SessionState& state(support::Rig& rig)
{
    return rig.uiLinks->session.latest();
}

}  // namespace

class TestSessionLoop : public QObject
{
    Q_OBJECT
private slots:
    void undoAndRedoGoStrokeByStroke()
    {
        support::Rig rig;
        rig.drill(support::smallBlock());
        std::vector<std::uint64_t> hashes{rig.liveHash()};
        for (int n = 0; n < 4; ++n) {
            stroke(rig, n - 2.0);
            hashes.push_back(rig.liveHash());
            QCOMPARE(state(rig).undoSteps, n + 1);
            QCOMPARE(state(rig).strokes, n + 1);
        }
        for (std::size_t n = 4; n-- > 0;) {
            rig.give(Undo{});
            QCOMPARE(rig.liveHash(), hashes[n]);
            QCOMPARE(rig.mirrorHash(), hashes[n]);
            QCOMPARE(state(rig).undoSteps, static_cast<int>(n));
            QCOMPARE(state(rig).redoSteps, static_cast<int>(4 - n));
        }
        rig.send(Undo{});  // one too many
        rig.run(20);
        QCOMPARE(rig.liveHash(), hashes[0]);
        QCOMPARE(state(rig).removedMm3[1], 0.0);
        for (std::size_t n = 1; n <= 4; ++n) {
            rig.give(Redo{});
            QCOMPARE(rig.liveHash(), hashes[n]);
        }
        QVERIFY(state(rig).removedMm3[1] > 0.01);
    }

    void undoInMidStrokeTakesBackWhatIsCutSoFar()
    {
        support::Rig rig;
        rig.drill(support::smallBlock());
        stroke(rig, -1.0);
        const std::uint64_t before = rig.liveHash();
        rig.lean(1.0, 0.0, 2.0, 64);
        rig.settle();
        const std::uint64_t half = rig.mirrorHash();
        QVERIFY(half != before);
        QCOMPARE(state(rig).undoSteps, 2);
        // Lifted before the undo reaches the servo; what was cut in between belongs to nobody.
        rig.send(Undo{});
        rig.settle();
        rig.device.tipMm.z = 5.0F;
        rig.run(40);
        QCOMPARE(rig.liveHash(), before);
        rig.send(Redo{});
        rig.run(40);
        QCOMPARE(rig.liveHash(), half);
    }

    void cuttingAfterUndoBeginsABranch()
    {
        support::Rig rig;
        rig.drill(support::smallBlock());
        stroke(rig, -1.0);
        stroke(rig, 0.0);
        const std::uint64_t first = rig.liveHash();
        const MomentId ofFirst = rig.session->historySoFar().back().id;
        rig.give(Undo{});
        QCOMPARE(state(rig).redoSteps, 1);
        stroke(rig, 1.0);
        QCOMPARE(state(rig).redoSteps, 0);
        const std::uint64_t now = rig.liveHash();
        rig.give(Redo{});
        QCOMPARE(rig.liveHash(), now);
        rig.give(GoTo{ofFirst});
        QCOMPARE(rig.liveHash(), first);
        QCOMPARE(rig.mirrorHash(), first);
        QVERIFY(recording::replay(rig.session->recordingSoFar().value())->agreesWithWitness);
    }

    void anyMomentIsAJumpAway()
    {
        support::Rig rig;
        rig.drill(support::smallBlock());
        Rng rng(4);
        std::map<MomentId, std::uint64_t> hashes{{rig.session->historySoFar().front().id, rig.liveHash()}};
        for (int n = 0; n < 60; ++n) {
            if (n % 3 == 2) {
                const auto all = rig.session->historySoFar();
                const MomentId id = all[static_cast<std::size_t>(rng.below(static_cast<int>(all.size())))].id;
                rig.give(GoTo{id});
                QCOMPARE(rig.liveHash(), hashes.at(id));
            } else {
                stroke(rig, rng.uniform(-3.0, 3.0));
                hashes[rig.session->historySoFar().back().id] = rig.liveHash();
            }
        }
        rig.send(GoTo{MomentId{12345}});  // nobody knows that one
        const std::uint64_t before = rig.liveHash();
        rig.run(20);
        QCOMPARE(rig.liveHash(), before);
        const auto all = rig.session->historySoFar();
        QCOMPARE(all.size(), 41U);
        for (const history::MomentInfo& moment : all) {
            const auto tooth = terrain::restored(rig.live().anatomy, rig.session->momentHeights(moment.id));
            QCOMPARE(terrain::stateHash(tooth), hashes.at(moment.id));
        }
        QVERIFY(rig.session->momentHeights(MomentId{12345}).empty());
        QVERIFY(recording::replay(rig.session->recordingSoFar().value())->agreesWithWitness);
    }

    void historyTellsWhatWasRemoved()
    {
        support::Rig rig;
        QVERIFY(rig.session->historySoFar().empty());
        rig.drill(support::smallBlock());
        const std::uint64_t version = state(rig).historyVersion;
        rig.run(100);
        QCOMPARE(state(rig).historyVersion, version);
        stroke(rig, -1.0);
        QVERIFY(state(rig).historyVersion != version);
        const auto after = rig.session->historySoFar();
        QCOMPARE(after.size(), 2U);
        QVERIFY(after[0].removed == history::Removed{});
        QVERIFY(after[1].isCurrent);
        QCOMPARE(after[1].parent, after[0].id);
        QCOMPARE(after[1].removed.volumesMm3, state(rig).removedMm3);
        // The moment is told when the pause after the stroke has made it one.
        const double ticksS = 0.001 * static_cast<double>(rig.servo->state().tick);
        QVERIFY2(after[1].seconds > 0.15 && after[1].seconds <= ticksS, qPrintable(QString::number(after[1].seconds)));
        rig.give(Reload{});
        const auto whole = rig.session->historySoFar();
        QCOMPARE(whole.size(), 3U);
        QCOMPARE(whole[2].parent, whole[1].id);
        QVERIFY(whole[2].removed == history::Removed{});
        QVERIFY(whole[2].seconds >= whole[1].seconds);
    }

    void reloadCanBeUndone()
    {
        support::Rig rig;
        rig.open(support::smallBlock());
        const std::uint64_t uncut = rig.liveHash();
        rig.send(SetDrill{true});
        stroke(rig, 0.0);
        const std::uint64_t cut = rig.liveHash();
        rig.give(Reload{});
        QCOMPARE(rig.liveHash(), uncut);
        QCOMPARE(rig.mirrorHash(), uncut);
        rig.send(Reload{});  // nothing to do: no step
        rig.run(20);
        QCOMPARE(state(rig).undoSteps, 2);
        rig.give(Undo{});
        QCOMPARE(rig.liveHash(), cut);
    }

    void patchesOfAnOlderToothAreIgnored()
    {
        support::Rig rig;
        rig.drill(support::smallBlock());
        stroke(rig, 0.0);
        // The servo goes on cutting while the session has already handed over the restored tooth.
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
        support::Rig rig;
        rig.drill(support::smallBlock());
        rig.lean(0.0, 0.0, 2.0, 30);
        rig.send(ReplaceTooth{new terrain::Tooth(support::smallBlock()), 7});
        // The bur is inside it, pressed and turning: it does nothing before it has been out.
        rig.lean(0.0, 0.0, 2.0, 100);
        QVERIFY((rig.uiLinks->servo.latest().health & kBegunInside) != 0);
        QCOMPARE(rig.uiLinks->servo.latest().forceN, glm::dvec3(0.0));
        QCOMPARE(rig.liveHash(), terrain::stateHash(terrain::Tooth(support::smallBlock())));
        rig.lift();
        QCOMPARE(rig.uiLinks->servo.latest().health & kBegunInside, 0U);
        rig.lean(0.0, 0.0, 2.0, 100);
        rig.lift();
        QCOMPARE(state(rig).toothGeneration, 7U);
        QCOMPARE(rig.uiLinks->servo.latest().toothGeneration, 7U);
        QCOMPARE(rig.mirrorHash(), rig.liveHash());
        QCOMPARE(state(rig).strokes, 1);
        rig.give(Undo{});
        QCOMPARE(rig.liveHash(), terrain::stateHash(terrain::Tooth(support::smallBlock())));
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
        rig.send(ReplaceTooth{new terrain::Tooth(support::smallBlock()), 1});  // and one that nobody takes is freed
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
        const auto remove = [&](double x, double y, double radius) {
            for (int j = 0; j < tooth.grid().side; ++j)
                for (int i = 0; i < tooth.grid().side; ++i)
                    if (glm::distance(tooth.grid().nodeMm(i, j), glm::dvec2(x, y)) < radius) {
                        tooth.top[tooth.grid().index(i, j)] = terrain::kEmptyTop;
                        tooth.bottom[tooth.grid().index(i, j)] = terrain::kEmptyBottom;
                    }
        };
        QVERIFY(terrain::perforations(tooth).empty());
        remove(3.0, 0.0, 1.0);
        QVERIFY(terrain::perforations(tooth).empty());
        remove(-1.0, 0.0, 0.2);
        QVERIFY(!terrain::perforations(tooth).empty());
    }

    void depthIsToldOverTheToothOnly()
    {
        support::Block crown;
        // Flat on top, falling off at 80 degrees from 2 mm on, with an overhang of 4 mm of air below its rim.
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
        // Hanging beside the crown, under what is left of its side.
        rig.device.tipMm = {2.4F, 0.0F, -12.0F};
        rig.open(support::makeBlock(crown), 2);
        rig.run(20);
        QVERIFY(!rig.uiLinks->servo.latest().hasDepth);
    }

    void viewHearsOfEveryChange()
    {
        support::Rig rig;
        const auto anatomy = support::smallBlock();
        rig.drill(anatomy);
        history::TiledHeights view(anatomy->grid, anatomy->top);
        std::vector<TilePatch> group;
        const auto look = [&] {
            rig.session->tick(rig.period);
            for (TilePatch patch; rig.uiLinks->patches.tryPop(patch);) {
                group.push_back(patch);
                if (!patch.last)
                    continue;
                for (const TilePatch& one : group)
                    view.setTile(one.tileX, one.tileY, one.top);
                group.clear();
            }
        };
        for (int n = 0; n < 3000; ++n) {
            rig.device.tipMm = {static_cast<float>(2.0 * std::sin(0.01 * n)), 0.5F, n % 600 < 300 ? -0.6F : 3.0F};
            rig.servo->tick(rig.period);
            if (n % 700 == 650)
                rig.send(Undo{});
            if (n % 900 == 850)
                rig.send(Redo{});
            if (n % 10 == 0)
                look();
        }
        rig.device.tipMm.z = 5.0F;
        for (int n = 0; n < 300; ++n)
            rig.servo->tick(rig.period);
        look();
        QCOMPARE(view.flat(), rig.live().top);
    }

    void attemptSoFarFromAnotherThread()
    {
        support::Rig rig;
        rig.drill(support::smallBlock());
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

    void nothingIsRememberedWhereNobodyAsks()
    {
        support::Rig rig({}, std::chrono::milliseconds(1), {false, 0});
        rig.drill(support::smallBlock());
        for (int n = 0; n < 6; ++n)
            stroke(rig, 0.5 * n - 2.0);
        QVERIFY(!rig.session->recordingSoFar());
        QCOMPARE(state(rig).recordedS, 0.0);
        QCOMPARE(state(rig).strokes, 6);
        QCOMPARE(state(rig).undoSteps, 1);
        QCOMPARE(rig.mirrorHash(), rig.liveHash());
        // The same work, remembered, comes to the same tooth.
        support::Rig other;
        other.drill(support::smallBlock());
        for (int n = 0; n < 6; ++n)
            stroke(other, 0.5 * n - 2.0);
        QCOMPARE(other.liveHash(), rig.liveHash());
        QVERIFY(other.session->recordingSoFar());
        QCOMPARE(state(other).undoSteps, 6);
    }

    void lessonAidsAndNotesGoOnTheRecording()
    {
        support::Rig rig;
        rig.open(support::smallBlock());
        rig.run(30);
        // Sent together with the next attempt, they belong to it, though its servo has not begun yet.
        rig.send(ReplaceTooth{new terrain::Tooth(support::smallBlock()), 2, new std::string("lesson é")});
        rig.send(SetAids{kRadiographAid | kMirrorAid});
        rig.send(AddNote{1});
        rig.run(30);
        rig.send(AddNote{~std::uint64_t{0}});
        rig.run(30);
        const recording::Recording made = rig.session->recordingSoFar().value();
        QCOMPARE(QString::fromStdString(made.lesson()), QStringLiteral("lesson é"));
        std::vector<std::pair<std::uint64_t, ServoEvent>> told;
        std::uint64_t ticks = 0;
        made.forEach([&](const ServoEvent& event) {
            ticks += event.kind == ServoEvent::Kind::Tick ? 1 : 0;
            if (event.kind == ServoEvent::Kind::Aids || event.kind == ServoEvent::Kind::Note)
                told.emplace_back(ticks, event);
        });
        QCOMPARE(told.size(), 3U);
        QVERIFY(told[0].second.kind == ServoEvent::Kind::Aids);
        QCOMPARE(told[0].second.value, std::uint64_t{kRadiographAid | kMirrorAid});
        QCOMPARE(told[1].second.value, 1U);
        QCOMPARE(told[2].second.value, ~std::uint64_t{0});
        QVERIFY2(told[1].first == 0 && told[2].first >= 10 && told[2].first <= 40,
                 qPrintable(QString::number(told[2].first)));
        // What an older attempt was told stays with that one.
        rig.send(AddNote{5});
        rig.send(ReplaceTooth{new terrain::Tooth(support::smallBlock()), 3});
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
            return rig.servo->state().removedMm3;
        };
        support::Rig rig;
        rig.open(support::smallBlock());
        rig.send(SetBur{2});
        rig.send(SetDrill{true});
        const terrain::PerMaterial usual = removedMm3(rig);

        ServoSettings softer;
        softer.hardness = settings::findHardnessPreset("typodont").value();
        softer.handpieces.push_back(settings::findHandpiece("low-speed").value());
        rig.give(ReplaceTooth{new terrain::Tooth(support::smallBlock()), 2, nullptr,
                              makeServoTick(softer).value().release()});
        // Bur and drill stay as they were in the hand.
        QCOMPARE(int{rig.servo->state().burIndex}, 2);
        QVERIFY(rig.servo->state().drillOn);
        const terrain::PerMaterial soft = removedMm3(rig);
        QVERIFY2(soft[1] > 1.5 * usual[1], qPrintable(QString("%1, %2").arg(soft[1]).arg(usual[1])));
        QVERIFY(rig.session->recordingSoFar()->settings() == softer);

        // The slow one cuts less, and a tooth that brings no servo is cut as the one before.
        rig.send(ReplaceTooth{new terrain::Tooth(support::smallBlock()), 3});
        rig.give(SetHandpiece{1});
        QCOMPARE(int{rig.servo->state().handpieceIndex}, 1);
        const terrain::PerMaterial slow = removedMm3(rig);
        QVERIFY2(slow[1] < 0.3 * soft[1] && slow[1] > 0.0, qPrintable(QString("%1, %2").arg(slow[1]).arg(soft[1])));
        const recording::Recording made = rig.session->recordingSoFar().value();
        QVERIFY(made.settings() == softer);
        const auto outcome = recording::replay(made);
        QVERIFY(outcome->agreesWithWitness);
        QCOMPARE(outcome->stateHash, rig.liveHash());
        QCOMPARE(int{outcome->state.handpieceIndex}, 1);

        // An attempt that was begun with another servo goes on with that one.
        support::Rig usualRig;
        usualRig.drill(support::smallBlock());
        usualRig.resume(made, 2);
        QVERIFY(usualRig.session->recordingSoFar()->settings() == softer);
        static_cast<void>(removedMm3(usualRig));
        QVERIFY(recording::replay(usualRig.session->recordingSoFar().value())->agreesWithWitness);
        // And one that nobody takes is freed.
        rig.send(
            ReplaceTooth{new terrain::Tooth(support::smallBlock()), 4, nullptr, makeServoTick({}).value().release()});
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

        // Another program, which has drilled another tooth meanwhile, and stands with its bur in the tooth.
        support::Rig second;
        second.drill(support::smallBlock());
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
        // Back to before the program ended, and forth again.
        second.send(Undo{});
        second.give(Undo{});
        second.give(Redo{});
        second.give(Redo{});
        QCOMPARE(second.liveHash(), now);
        stroke(second, 2.5);
        const recording::Recording made = second.session->recordingSoFar().value();
        QCOMPARE(made.lesson(), std::string("lesson"));
        const auto read = recording::Recording::fromBytes(made.toBytes());
        QVERIFY(read);
        const auto outcome = recording::replay(*read);
        QVERIFY(outcome->agreesWithWitness);
        QCOMPARE(outcome->stateHash, second.liveHash());
        int resumed = 0;
        made.forEach([&](const ServoEvent& event) { resumed += event.kind == ServoEvent::Kind::Resume ? 1 : 0; });
        QCOMPARE(resumed, 1);

        // And once more.
        support::Rig third;
        third.resume(*read);
        QCOMPARE(third.liveHash(), second.liveHash());
        third.send(SetDrill{true});
        stroke(third, -2.0);
        const auto last = recording::replay(third.session->recordingSoFar().value());
        QVERIFY(last->agreesWithWitness);
        QCOMPARE(last->stateHash, third.liveHash());
    }

    void anAttemptThatEndedWithUndoIsTakenUpAgain()
    {
        support::Rig first;
        first.drill(support::smallBlock());
        stroke(first, -1.0);
        const std::uint64_t once = first.liveHash();
        stroke(first, 1.0);
        const std::uint64_t twice = first.liveHash();
        const recording::Recording before = first.session->recordingSoFar().value();
        first.give(Undo{});
        QCOMPARE(first.liveHash(), once);
        // It ends with the undo, before another tick.
        recording::Recording left({}, support::smallBlock());
        const std::uint64_t events = first.session->recordingSoFar()->events();
        std::uint64_t n = 0;
        first.session->recordingSoFar()->forEach([&](const ServoEvent& event) {
            if (n++ < before.events() || (n <= events && event.kind == ServoEvent::Kind::Restore))
                left.append(event);
        });
        QCOMPARE(recording::replay(left)->stateHash, once);
        support::Rig second;
        second.resume(left);
        QCOMPARE(second.liveHash(), once);
        const recording::Recording made = second.session->recordingSoFar().value();
        QVERIFY(made.witness().has_value());
        QCOMPARE(made.witness()->stateHash, twice);
        QVERIFY(recording::replay(made)->agreesWithWitness);
        QCOMPARE(recording::replay(made)->stateHash, once);
        second.give(Redo{});
        QCOMPARE(second.liveHash(), twice);
    }

    void theMomentsOfAnAttemptComeBack()
    {
        support::Rig rig;
        rig.drill(support::smallBlock());
        Rng rng(8);
        for (int n = 0; n < 40; ++n) {
            switch (n % 5) {
            case 2:
                rig.give(Undo{});
                break;
            case 3:
                rig.give(Redo{});
                if (n == 33)
                    rig.give(Reload{});
                break;
            case 4:  // taken back in mid-stroke, and brought back
                rig.lean(rng.uniform(-3.0, 3.0), 1.0, 2.0, 40);
                rig.give(Undo{});
                rig.send(Redo{});
                rig.lift();
                break;
            default:
                stroke(rig, rng.uniform(-3.0, 3.0));
            }
        }
        const auto heights = [](const history::UndoTree& tree) {
            std::multiset<std::uint64_t> hashes;
            for (const history::MomentInfo& moment : tree.list())
                hashes.insert(
                    terrain::stateHash(terrain::restored(support::smallBlock(), tree.find(moment.id)->top.flat())));
            return hashes;
        };
        std::multiset<std::uint64_t> known;
        const auto live = rig.session->historySoFar();
        for (const history::MomentInfo& moment : live)
            known.insert(
                terrain::stateHash(terrain::restored(support::smallBlock(), rig.session->momentHeights(moment.id))));
        const auto again = rebuild(rig.session->recordingSoFar().value()).value();
        QCOMPARE(again->strokes, state(rig).strokes);
        QCOMPARE(terrain::stateHash(terrain::restored(support::smallBlock(), again->history.current().top.flat())),
                 rig.liveHash());
        QVERIFY(heights(again->history) == known);
        const auto list = again->history.list();
        QCOMPARE(list.size(), live.size());
        for (std::size_t k = 0; k < list.size(); ++k) {
            QCOMPARE(list[k].tick, live[k].tick);
            QCOMPARE(list[k].parent, live[k].parent);  // numbers are given in the same order
            QVERIFY(list[k].removed == live[k].removed);
            QVERIFY(std::abs(list[k].seconds - live[k].seconds) < 0.03);
        }
    }

    /// Who takes an attempt up again has been elsewhere for so long, and then a little more.
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
        support::Rig first;
        const auto anatomy = support::smallBlock();
        first.drill(anatomy);
        stroke(first, -1.0);
        stroke(first, 1.0);
        support::Rig second;
        second.send(ResumeAttempt{rebuild(first.session->recordingSoFar().value()).value().release(), 3});
        second.session->tick(second.period);
        history::TiledHeights view(anatomy->grid, anatomy->top);
        std::size_t patches = 0;
        for (TilePatch patch; second.uiLinks->patches.tryPop(patch); ++patches) {
            QCOMPARE(patch.toothGeneration, 3U);
            view.setTile(patch.tileX, patch.tileY, patch.top);
        }
        QCOMPARE(view.flat(), first.live().top);
        QVERIFY(patches < view.tiles().size());
        second.send(
            ResumeAttempt{rebuild(first.session->recordingSoFar().value()).value().release(), 4});  // nobody takes it
    }
};

QTEST_APPLESS_MAIN(TestSessionLoop)
#include "tst_session_loop.moc"
