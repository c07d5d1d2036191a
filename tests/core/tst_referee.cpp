// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "core/grading/Referee.h"
#include "core/session/Follower.h"
#include "core/teeth/Beside.h"
#include "core/teeth/ToothBuilder.h"
#include "tests/support/Rig.h"
#include "tests/support/Solids.h"
#include "tests/support/SyntheticMolar.h"

using namespace core;
using namespace core::grading;
using namespace std::chrono_literals;

namespace {

constexpr std::chrono::microseconds kTick = 1ms;

}  // namespace

class TestReferee : public QObject
{
    Q_OBJECT

private slots:
    void init()
    {
        m_anatomy = support::syntheticMolar();
        m_tooth.emplace(m_anatomy);
        m_state = {};
        m_middle = m_anatomy->grid.side / 2;
    }

    void watchesOnlyWhatTheRulesName()
    {
        Referee referee(Rules{}, m_anatomy, nullptr);
        m_state.drillOn = true;
        m_state.burIndex = 3;
        m_state.forceN = {0.0, 0.0, 50.0};
        QVERIFY(cut(referee, m_middle, m_middle, 20.0F).empty());
        m_state.touching = false;
        QVERIFY(wait(referee, 100'000).empty());
    }

    void tellsPulpOnceUntilItIsMended()
    {
        Rules rules;
        rules.pulpExposed = true;
        Referee referee(rules, m_anatomy, nullptr);
        std::size_t k = 0;
        while (!terrain::hasPulp(*m_anatomy, k))
            ++k;
        const int i = static_cast<int>(k) % m_anatomy->grid.side;
        const int j = static_cast<int>(k) / m_anatomy->grid.side;
        const float toRoof = m_anatomy->top[k] - m_anatomy->layers[k].pulpRoof;
        QVERIFY(cut(referee, i, j, toRoof - 0.01F).empty());
        const auto found = cut(referee, i, j, toRoof + 0.01F);
        QCOMPARE(found.size(), std::size_t{1});
        QCOMPARE(found.front().breach, Breach::PulpExposed);
        QCOMPARE(found.front().tick, std::uint64_t{2});
        QVERIFY(cut(referee, i, j, toRoof + 0.5F).empty());
        // Put back to where it was open already: not told again. Put back further: told when it happens again.
        referee.restored(*m_tooth);
        QVERIFY(cut(referee, i, j, toRoof + 0.6F).empty());
        m_tooth.emplace(m_anatomy);
        referee.restored(*m_tooth);
        QCOMPARE(cut(referee, i, j, toRoof + 0.01F).size(), std::size_t{1});
    }

    void tellsDepthAtItsLimit()
    {
        Rules rules;
        rules.depthLimitMm = 2.0;
        Referee referee(rules, m_anatomy, nullptr);
        QVERIFY(cut(referee, m_middle, m_middle, 1.99F).empty());
        const auto found = cut(referee, m_middle, m_middle, 2.01F);
        QCOMPARE(found.size(), std::size_t{1});
        QCOMPARE(found.front().breach, Breach::TooDeep);
        QVERIFY(std::abs(found.front().value - 2.01) < 1e-5);
        QCOMPARE(found.front().limit, 2.0);
    }

    void aScratchIsNoCut()
    {
        Rules rules;
        rules.ridgeLimitMm = 100.0;
        Referee referee(rules, m_anatomy, nullptr);
        QVERIFY(cut(referee, m_middle, m_middle, 0.09F).empty());
        QCOMPARE(cut(referee, m_middle, m_middle, 0.11F).size(), std::size_t{1});
    }

    void theRidgeIsMeasuredAlongTheRow()
    {
        Rules rules;
        rules.ridgeLimitMm = 1.6;
        Referee referee(rules, m_anatomy, nullptr);
        int low = 0;
        while (!m_tooth->isSolid(m_anatomy->grid.index(low, m_middle)))
            ++low;
        const double cell = m_anatomy->grid.cellMm;
        const int outside = low + static_cast<int>(1.7 / cell);
        QVERIFY(cut(referee, outside, m_middle, 0.5F).empty());
        const auto found = cut(referee, low + static_cast<int>(1.4 / cell), m_middle, 0.5F);
        QCOMPARE(found.size(), std::size_t{1});
        QCOMPARE(found.front().breach, Breach::RidgeCut);
        QVERIFY(std::abs(found.front().value - 1.4) < cell);
    }

    void tellsWhatIsCutBesideTheIdeal()
    {
        std::vector<float> ideal = m_anatomy->top;
        const int half = static_cast<int>(1.0 / m_anatomy->grid.cellMm);
        for (int j = m_middle - half; j <= m_middle + half; ++j)
            for (int i = m_middle - half; i <= m_middle + half; ++i)
                ideal[m_anatomy->grid.index(i, j)] -= 1.0F;
        Rules rules;
        rules.besideLimitMm = 0.5;
        Referee referee(rules, m_anatomy, std::make_shared<const std::vector<float>>(ideal));
        const int nearBy = m_middle + half + static_cast<int>(0.3 / m_anatomy->grid.cellMm);
        const int far = m_middle + half + static_cast<int>(0.8 / m_anatomy->grid.cellMm);
        QVERIFY(cut(referee, m_middle, m_middle, 3.0F).empty());
        QVERIFY(cut(referee, nearBy, m_middle, 0.5F).empty());
        const auto found = cut(referee, far, m_middle, 0.5F);
        QCOMPARE(found.size(), std::size_t{1});
        QCOMPARE(found.front().breach, Breach::WrongPlace);
        QVERIFY(std::abs(found.front().value - 0.8) < 1.5 * m_anatomy->grid.cellMm);
    }

    void forceCountsAfterTwoTenthsOfASecond()
    {
        Rules rules;
        rules.forceLimitN = 3.0;
        Referee referee(rules, m_anatomy, nullptr);
        m_state.touching = true;
        m_state.forceN = {0.0, 1.9, 2.4};  // 3.06 N
        QVERIFY(wait(referee, 200).empty());
        const auto found = wait(referee, 1);
        QCOMPARE(found.size(), std::size_t{1});
        QVERIFY(std::abs(found.front().value - 3.0610) < 1e-3);
        QVERIFY(wait(referee, 1000).empty());
        // Let go for a tick, it counts from the beginning.
        m_state.forceN = {0.0, 0.0, 1.0};
        QVERIFY(wait(referee, 1).empty());
        m_state.forceN = {0.0, 0.0, 3.5};
        QVERIFY(wait(referee, 200).empty());
        QCOMPARE(wait(referee, 1).size(), std::size_t{1});
    }

    void aBurInTheAirIsToldOncePerStretch()
    {
        Rules rules;
        rules.airLimitS = 2.0;
        Referee referee(rules, m_anatomy, nullptr);
        m_state.drillOn = true;
        // Who has not cut yet may be reading what is asked.
        QVERIFY(wait(referee, 9000).empty());
        QVERIFY(cut(referee, m_middle, m_middle, 0.2F).empty());
        m_state.touching = false;
        QVERIFY(wait(referee, 2000).empty());
        QCOMPARE(wait(referee, 5000).size(), std::size_t{1});
        m_state.touching = true;
        QVERIFY(wait(referee, 1).empty());
        m_state.touching = false;
        QVERIFY(wait(referee, 2000).empty());
        QCOMPARE(wait(referee, 1).size(), std::size_t{1});
        m_state.drillOn = false;
        QVERIFY(wait(referee, 9000).empty());
    }

    void withoutADeviceNothingIsBroken()
    {
        Rules rules;
        rules.airLimitS = 2.0;
        rules.forceLimitN = 3.0;
        Referee referee(rules, m_anatomy, nullptr);
        m_state.drillOn = true;
        QVERIFY(cut(referee, m_middle, m_middle, 0.2F).empty());
        m_state.touching = false;
        QVERIFY(wait(referee, 1500).empty());
        m_state.health = session::kDeviceLost;
        QVERIFY(wait(referee, 60'000).empty());
        m_state.health = 0;
        QVERIFY(wait(referee, 500).empty());
        QCOMPARE(wait(referee, 1).size(), std::size_t{1});
        // A force before the gap and one after it are two.
        m_state.touching = true;
        m_state.forceN = {0.0, 0.0, 3.5};
        QVERIFY(wait(referee, 150).empty());
        m_state.health = session::kDeviceLost;
        QVERIFY(wait(referee, 100).empty());
        m_state.health = 0;
        QVERIFY(wait(referee, 200).empty());
        QCOMPARE(wait(referee, 1).front().breach, Breach::TooMuchForce);
    }

    void aWrongBurMayBeHeldButNotCut()
    {
        Rules rules;
        rules.allowedBurs = 0b0011;
        Referee referee(rules, m_anatomy, nullptr);
        m_state.burIndex = 2;
        QVERIFY(wait(referee, 100).empty());
        QCOMPARE(cut(referee, m_middle, m_middle, 0.2F).size(), std::size_t{1});
        QVERIFY(cut(referee, m_middle, m_middle, 0.3F).empty());
        m_state.burIndex = 1;
        QVERIFY(cut(referee, m_middle, m_middle, 0.4F).empty());
        m_state.burIndex = 3;
        QCOMPARE(cut(referee, m_middle, m_middle, 0.5F).size(), std::size_t{1});
    }

    void theToothBesideIsSpared()
    {
        QVERIFY(teeth::teethBeside(99) == nullptr);
        Rules rules;
        rules.neighbours = teeth::teethBeside(36);
        QVERIFY(rules.neighbours != nullptr);
        QVERIFY(teeth::teethBeside(36) == rules.neighbours);  // made once
        const auto built = teeth::buildTooth({36}, {}).value();
        m_anatomy = built.anatomy;
        m_tooth.emplace(m_anatomy);
        Referee referee(rules, m_anatomy, nullptr);
        // How far 36 reaches along x in its middle row, where the neighbours stand next to it.
        const terrain::Grid& grid = m_anatomy->grid;
        double low = 1.0e9;
        double high = -1.0e9;
        for (int i = 0; i < grid.side; ++i)
            if (const std::size_t k = grid.index(i, grid.side / 2); m_anatomy->top[k] > m_anatomy->bottom[k]) {
                low = std::min(low, grid.nodeMm(i, 0).x);
                high = std::max(high, grid.nodeMm(i, 0).x);
            }
        const double row = grid.nodeMm(0, grid.side / 2).y;
        m_state.burIndex = 2;
        m_state.drillOn = true;
        const auto at = [&](double x, double z) {
            m_state.anchorMm = {x, row, z};
            return wait(referee, 1);
        };
        // All along its own crown, from rim to rim, nobody else is touched.
        for (double x = low + 0.6; x < high - 0.6; x += 0.1)
            QVERIFY2(at(x, -2.5).empty(), qPrintable(QString::number(x)));
        for (const double beyond : {low - 0.9, high + 0.9}) {
            const auto found = at(beyond, -2.5);
            QCOMPARE(found.size(), std::size_t{1});
            QCOMPARE(found.front().breach, Breach::NeighbourHit);
            QVERIFY2(at(beyond, -2.6).empty(), "told once");
            m_state.drillOn = false;
            QVERIFY(at(beyond, -2.6).empty());
            m_state.drillOn = true;
            QVERIFY2(at(beyond, -2.6).empty(), "nor again where it was stopped and goes on");
            QVERIFY(at(0.0, 5.0).empty());
            m_state.drillOn = false;
            QVERIFY2(at(beyond, -2.5).empty(), "a bur at rest does no harm");
            m_state.drillOn = true;
            QVERIFY2(at(beyond, 9.0).empty(), "nor one high above");
        }
        m_state.anchorMm = {1.0e9, 0.0, 0.0};
        QVERIFY(wait(referee, 1).empty());
    }

    void tellsAHoleThrough()
    {
        Rules rules;
        rules.perforated = true;
        Referee referee(rules, m_anatomy, nullptr);
        const std::size_t k = m_anatomy->grid.index(m_middle, m_middle);
        m_tooth->top[k] = terrain::kEmptyTop;
        m_tooth->bottom[k] = terrain::kEmptyBottom;
        m_state.tick = 1;
        std::vector<Infraction> found =
            referee.look(m_state, {m_middle, m_middle, m_middle, m_middle}, *m_tooth, kTick);
        for (const Infraction& late : wait(referee, 100))
            found.push_back(late);
        QCOMPARE(found.size(), std::size_t{1});
        QCOMPARE(found.front().breach, Breach::Perforated);

        // Where a hole is asked for, it is none.
        auto ideal = std::make_shared<std::vector<float>>(m_anatomy->top);
        (*ideal)[k] = terrain::kEmptyTop;
        Referee lenient(rules, m_anatomy, ideal);
        m_state.tick = 1;
        QVERIFY(lenient.look(m_state, {m_middle, m_middle, m_middle, m_middle}, *m_tooth, kTick).empty());
        QVERIFY(wait(lenient, 100).empty());
    }

    void liveAndReplayFindTheSame()
    {
        support::Rig rig;
        session::Examination examination;
        examination.rules.depthLimitMm = 0.3;
        examination.rules.forceLimitN = 0.5;
        examination.rules.airLimitS = 0.5;
        session::Follower follower(*rig.session);
        rig.open(m_anatomy);
        follower.watch(1, examination);
        rig.send(session::SetDrill{true});
        support::RestlessHand hand(11);
        for (int n = 0; n < 6000; ++n) {
            rig.device.tipMm = hand.next();
            rig.run(1);
            if (n % 50 == 0)
                follower.tick(50ms);
            if (n == 3000)
                rig.send(session::Undo{});
        }
        const auto concluded = follower.conclude();
        QVERIFY(concluded.has_value());
        QCOMPARE(concluded->findings.ticks, concluded->recording.ticks());
        QVERIFY(!concluded->findings.infractions.empty());

        session::Examiner examiner(examination, m_anatomy);
        const auto outcome = recording::replay(
            concluded->recording,
            [&](const session::ServoEvent& event, const recording::Replayer& servo) { examiner.take(event, servo); });
        QVERIFY(outcome.has_value());
        QVERIFY(outcome->agreesWithWitness);
        QCOMPARE(outcome->stateHash, terrain::stateHash(concluded->tooth));
        QVERIFY(examiner.process() == concluded->findings.process);
        QVERIFY(examiner.infractions() == concluded->findings.infractions);
        QVERIFY(examiner.process().undos > 0);
    }

    void followsThroughAStormOfUndos()
    {
        support::Rig rig;
        session::Follower follower(*rig.session);
        rig.drill(m_anatomy);
        support::RestlessHand hand(12);
        const auto drill = [&](int ticks) { rig.follow(hand, ticks); };
        drill(2000);
        // More steps than are kept for who falls behind.
        for (int n = 0; n < 600; ++n) {
            rig.send(n % 2 == 0 ? session::SessionCommand{session::Undo{}} : session::SessionCommand{session::Redo{}});
            rig.run(2);
        }
        drill(500);
        const auto concluded = follower.conclude();
        QVERIFY(concluded.has_value());
        const auto outcome = recording::replay(concluded->recording);
        QVERIFY(outcome.has_value());
        QCOMPARE(terrain::stateHash(concluded->tooth), outcome->stateHash);
        QCOMPARE(concluded->findings.ticks, concluded->recording.ticks());
    }

private:
    /// Lowers column (i, j) so far below the original surface and lets the referee look.
    std::vector<Infraction> cut(Referee& referee, int i, int j, float depthMm)
    {
        const std::size_t k = m_anatomy->grid.index(i, j);
        m_tooth->top[k] = m_anatomy->top[k] - depthMm;
        ++m_state.tick;
        m_state.cutting = true;
        m_state.touching = true;
        return referee.look(m_state, {i, j, i, j}, *m_tooth, kTick);
    }
    std::vector<Infraction> wait(Referee& referee, int ticks)
    {
        std::vector<Infraction> all;
        for (int n = 0; n < ticks; ++n) {
            ++m_state.tick;
            for (const Infraction& infraction : referee.look(m_state, {}, *m_tooth, kTick))
                all.push_back(infraction);
        }
        return all;
    }

    std::shared_ptr<const terrain::ToothAnatomy> m_anatomy;
    std::optional<terrain::Tooth> m_tooth;
    session::ServoState m_state;
    int m_middle = 0;
};

QTEST_GUILESS_MAIN(TestReferee)
#include "tst_referee.moc"
