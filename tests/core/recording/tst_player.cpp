// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <atomic>
#include <cmath>
#include <map>
#include <thread>

#include "core/recording/Format.h"
#include "core/recording/Player.h"
#include "core/servo/ServoState.h"
#include "core/session/SessionChannels.h"
#include "tests/support/Rig.h"
#include "tests/support/SyntheticTooth.h"

using namespace core;
using core::servo::ServoEvent;
using recording::Player;
using recording::Recording;

namespace {

/// Records random motion with undo, redo, other burs, missed ticks and notes. The attempt is ended and resumed once.
Recording attempt(int ticks)
{
    std::optional<Recording> left;
    Rng rng(12);
    support::RestlessHand hand(13);
    for (int life = 0; life < 2; ++life) {
        support::Rig rig;
        if (left)
            rig.resume(*left);
        else
            rig.drill(support::smallBlock());
        for (int n = 0; n < ticks / 2; ++n) {
            rig.device.tipMm = hand.next();
            rig.run(1, std::chrono::milliseconds(rng.below(50) == 0 ? 3 : 1));
            switch (rng.below(600)) {
            case 0:
                rig.send(session::Undo{});
                break;
            case 1:
                rig.send(session::Redo{});
                break;
            case 2:
                rig.send(core::servo::SetBur{static_cast<std::uint8_t>(rng.below(4))});
                break;
            case 3:
                rig.send(session::AddNote{static_cast<std::uint64_t>(n)});
                break;
            default:
                break;
            }
        }
        rig.settle();
        left = rig.session->recordingSoFar();
    }
    return *left;
}

/// The top map after each tick for which the player is exact, and the state after each tick that it keeps.
struct Truth
{
    std::map<std::uint64_t, std::vector<float>> heights;
    std::map<std::uint64_t, core::servo::ServoState> states;
    std::map<std::uint64_t, double> seconds;
};

Truth truthOf(const Recording& made)
{
    Truth truth;
    auto servo = recording::Replayer::make(made).value();
    double seconds = 0.0;
    made.forEach([&](const ServoEvent& event) {
        seconds += 1.0e-6 * event.dtUs;
        servo.play(event);
        // A restored or resumed tooth belongs to the same tick and replaces the map stored for it.
        if (servo.tick() % Player::kTicksAPatch == 0 || event.kind == ServoEvent::Kind::Restore ||
            event.kind == ServoEvent::Kind::Resume)
            truth.heights[servo.tick()] = servo.tooth().tooth().top;
        if (servo.tick() % Player::kTicksAPose == 0)
            truth.states.emplace(servo.tick(), servo.state());
        truth.seconds[servo.tick()] = seconds;
    });
    return truth;
}

}  // namespace

class TestPlayer : public QObject
{
    Q_OBJECT
private slots:
    void everyMomentIsAsItWas()
    {
        const Recording made = attempt(12000);
        const Truth truth = truthOf(made);
        const auto player = Player::make(made).value();
        int steps = 0;
        while (player->advance(997))
            ++steps;
        QCOMPARE(steps, static_cast<int>((made.ticks() - 1) / 997));
        QVERIFY(!player->advance(1));
        QCOMPARE(player->readyTicks(), made.ticks());
        QCOMPARE(player->ticks(), made.ticks());
        // Looks at random ticks.
        Rng rng(3);
        int cut = 0;
        for (int n = 0; n < 400; ++n) {
            const std::uint64_t tick = static_cast<std::uint64_t>(rng.below(static_cast<int>(made.ticks()) + 1));
            const auto known = truth.heights.upper_bound(tick);
            const std::vector<float> heights = player->heightsAt(tick);
            if (known != truth.heights.begin())
                QVERIFY2(heights == std::prev(known)->second, qPrintable(QString::number(tick)));
            cut += heights != made.anatomy()->top ? 1 : 0;
            const core::servo::ServoState state = player->stateAt(tick);
            const core::servo::ServoState& was = truth.states.at(tick / Player::kTicksAPose * Player::kTicksAPose);
            QCOMPARE(state.tick, was.tick);
            QCOMPARE(glm::vec3(state.anchorMm), glm::vec3(was.anchorMm));
            QCOMPARE(glm::vec3(state.deviceMm), glm::vec3(was.deviceMm));
            QCOMPARE(glm::vec3(state.forceN), glm::vec3(was.forceN));
            QCOMPARE(state.burIndex, was.burIndex);
            QCOMPARE(state.drillOn, was.drillOn);
            QCOMPARE(state.cutting, was.cutting);
            QCOMPARE(state.touching, was.touching);
            QCOMPARE(state.health, was.health);
            QCOMPARE(static_cast<float>(state.removedMm3[1]), static_cast<float>(was.removedMm3[1]));
            QVERIFY(std::abs(player->secondsAt(tick) - truth.seconds.at(std::max<std::uint64_t>(tick, 1))) < 0.012);
            QVERIFY(std::abs(static_cast<double>(player->tickAt(player->secondsAt(tick))) -
                             static_cast<double>(tick)) <= 4.0);
        }
        QVERIFY(cut > 200);
        QCOMPARE(player->heightsAt(0), made.anatomy()->top);
        QCOMPARE(player->heightsAt(made.ticks() + 1000), recording::replay(made)->tooth.top);
        QVERIFY(player->bytes() < 8'000'000);
    }

    void strokesAndMarksAreTold()
    {
        support::Rig rig;
        rig.drill(support::smallBlock());
        for (int n = 0; n < 4; ++n) {
            rig.lean(0.8 * n - 1.2, 0.0, 2.0, 100);
            rig.lift();
            if (n == 2)
                rig.give(session::Undo{});
        }
        rig.lean(0.0, 1.0, 2.0, 60);  // interrupted by an undo
        rig.send(session::Undo{});
        rig.settle();
        rig.device.tipMm.z = 5.0F;
        rig.run(30);
        const Recording made = rig.session->recordingSoFar().value();
        const auto player = Player::make(made).value();
        while (player->advance(1000)) {
        }
        const auto strokes = player->strokes();
        QCOMPARE(strokes.size(), 5U);
        for (std::size_t n = 0; n < strokes.size(); ++n) {
            QVERIFY(strokes[n].from <= strokes[n].to);
            QVERIFY2(strokes[n].to - strokes[n].from < 110,
                     qPrintable(QString("%1 to %2").arg(strokes[n].from).arg(strokes[n].to)));
            QVERIFY(player->stateAt(strokes[n].from + Player::kTicksAPose).cutting);
            QVERIFY(!player->stateAt(strokes[n].to + Player::kTicksAPose).cutting);
            QVERIFY(n == 0 || strokes[n].from > strokes[n - 1].to);
            // Only strokes and undo change the tooth.
            QVERIFY(player->heightsAt(strokes[n].from - 1) != player->heightsAt(strokes[n].to - 1));
        }
        int undone = 0;
        std::uint64_t last = 0;
        for (const recording::MarkedEvent& mark : player->marks()) {
            QVERIFY(!recording::isTick(mark.event.kind));
            QVERIFY(mark.tick >= last && mark.tick <= made.ticks());
            last = mark.tick;
            undone += mark.event.kind == ServoEvent::Kind::Restore ? 1 : 0;
        }
        QCOMPARE(undone, 2);
    }

    void canBeLookedAtWhileItIsMade()
    {
        const Recording made = attempt(8000);
        const Truth truth = truthOf(made);
        const auto player = Player::make(made).value();
        std::atomic<bool> done{false};
        std::thread maker([&] {
            while (player->advance(100)) {
            }
            done = true;
        });
        Rng rng(6);
        int looks = 0;
        int wrong = 0;
        while (!done || looks < 20) {
            const std::uint64_t ready = player->readyTicks();
            if (ready < 100)
                continue;
            // An undo may still change the last patch.
            const auto tick = static_cast<std::uint64_t>(rng.below(static_cast<int>(ready) - 32));
            const auto known = truth.heights.upper_bound(tick);
            if (known != truth.heights.begin() && player->heightsAt(tick) != std::prev(known)->second)
                ++wrong;
            ++looks;
        }
        maker.join();
        QCOMPARE(wrong, 0);
        QCOMPARE(player->readyTicks(), made.ticks());
    }

    void anEmptyAttempt()
    {
        const auto player = Player::make(Recording({}, support::smallBlock())).value();
        QVERIFY(!player->advance(10));
        QCOMPARE(player->readyTicks(), 0U);
        QCOMPARE(player->heightsAt(0), support::smallBlock()->top);
        QCOMPARE(player->stateAt(5).tick, 0U);
        QCOMPARE(player->secondsAt(5), 0.0);
        QCOMPARE(player->tickAt(5.0), 0U);
        QVERIFY(player->strokes().empty());
    }
};

QTEST_APPLESS_MAIN(TestPlayer)
#include "tst_player.moc"
