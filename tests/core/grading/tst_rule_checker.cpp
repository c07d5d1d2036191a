// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include <type_traits>

#include "core/bur/Bur.h"
#include "core/grading/RuleChecker.h"
#include "core/servo/ServoState.h"
#include "core/session/LiveAssessmentLoop.h"
#include "core/session/SessionChannels.h"
#include "core/teeth/Beside.h"
#include "tests/support/Checks.h"
#include "tests/support/Rig.h"
#include "tests/support/Scenes.h"
#include "tests/support/Suite.h"
#include "tests/support/SyntheticMolar.h"

using namespace core;
using namespace core::grading;
using namespace std::chrono_literals;

namespace {

constexpr std::chrono::microseconds kTick = 1ms;

/// Returns whether the checker found this violation exactly once and no other.
bool isOne(const std::vector<Infraction>& found, RuleViolation breach)
{
    return found.size() == 1 && found.front().breach == breach;
}

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
        m_rules = {};
    }

    void watchesOnlyWhatTheRulesName()
    {
        m_referee.emplace(Rules{}, m_anatomy, nullptr);
        m_state.drillOn = true;
        m_state.burIndex = 3;
        m_state.forceN = {0.0, 0.0, 50.0};
        QVERIFY(cut(m_middle, m_middle, 20.0F).empty());
        m_state.touching = false;
        QVERIFY(wait(100'000).empty());
    }

    void tellsPulpOnceUntilItIsMended()
    {
        watch(&Rules::pulpLimitMm2, 0.0);
        std::size_t k = 0;
        while (!terrain::hasPulp(*m_anatomy, k))
            ++k;
        const int i = static_cast<int>(k) % m_anatomy->grid.side;
        const int j = static_cast<int>(k) / m_anatomy->grid.side;
        const float toRoof = m_anatomy->top[k] - m_anatomy->layers[k].pulpRoof;
        QVERIFY(cut(i, j, toRoof - 0.01F).empty());
        const auto found = cut(i, j, toRoof + 0.01F);
        QVERIFY(isOne(found, RuleViolation::PulpExposed));
        QCOMPARE(found.front().tick, std::uint64_t{2});
        QVERIFY(cut(i, j, toRoof + 0.5F).empty());
        // After a restore to a state that was already open, the violation is not reported again. After a restore to an
        // earlier state, it is.
        m_referee->restored(*m_tooth);
        QVERIFY(cut(i, j, toRoof + 0.6F).empty());
        m_tooth.emplace(m_anatomy);
        m_referee->restored(*m_tooth);
        QVERIFY(isOne(cut(i, j, toRoof + 0.01F), RuleViolation::PulpExposed));
    }

    void anOpenedPulpCountsFromItsLimit()
    {
        watch(&Rules::pulpLimitMm2, kPulpLimitMm2);
        const auto open = [this](std::size_t k) {
            const int side = m_anatomy->grid.side;
            return cut(static_cast<int>(k) % side, static_cast<int>(k) / side,
                       m_anatomy->top[k] - m_anatomy->layers[k].pulpRoof + 0.01F);
        };
        const auto openUpToTheLimit = [&] {
            double openMm2 = 0.0;
            std::size_t k = 0;
            for (;; ++k) {
                if (!terrain::hasPulp(*m_anatomy, k))
                    continue;
                const double area = static_cast<double>(m_anatomy->areaMm2[k]);
                if (openMm2 + area > kPulpLimitMm2)
                    return k;
                openMm2 += area;
                if (!open(k).empty() || !open(k).empty())  // a column that is cut again counts once
                    return std::size_t{0};
            }
        };
        const std::size_t next = openUpToTheLimit();
        QVERIFY(next > 0);
        QVERIFY(isOne(open(next), RuleViolation::PulpExposed));
        m_tooth.emplace(m_anatomy);
        m_referee->restored(*m_tooth);
        QCOMPARE(openUpToTheLimit(), next);
        m_referee->restored(*m_tooth);
        QVERIFY(isOne(open(next), RuleViolation::PulpExposed));
    }

    void tellsDepthAtItsLimit()
    {
        watch(&Rules::depthLimitMm, 2.0);
        QVERIFY(cut(m_middle, m_middle, 1.99F).empty());
        const auto found = cut(m_middle, m_middle, 2.01F);
        QVERIFY(isOne(found, RuleViolation::TooDeep));
        QVERIFY(support::near(found.front().value, 2.01, 1e-5));
        QCOMPARE(found.front().limit, 2.0);
    }

    void aScratchIsNoCut()
    {
        watch(&Rules::ridgeLimitMm, 100.0);
        QVERIFY(cut(m_middle, m_middle, 0.09F).empty());
        QVERIFY(isOne(cut(m_middle, m_middle, 0.11F), RuleViolation::RidgeCut));
    }

    void theRidgeIsMeasuredAlongTheRow()
    {
        watch(&Rules::ridgeLimitMm, 1.6);
        int low = 0;
        while (!m_tooth->isSolid(m_anatomy->grid.index(low, m_middle)))
            ++low;
        const double cell = m_anatomy->grid.cellMm;
        QVERIFY(cut(low + static_cast<int>(1.7 / cell), m_middle, 0.5F).empty());
        const auto found = cut(low + static_cast<int>(1.4 / cell), m_middle, 0.5F);
        QVERIFY(isOne(found, RuleViolation::RidgeCut));
        QVERIFY(support::near(found.front().value, 1.4, cell));
    }

    void tellsWhatIsCutBesideTheIdeal()
    {
        const double cell = m_anatomy->grid.cellMm;
        const int edge = m_middle + static_cast<int>(1.0 / cell);
        auto ideal = std::make_shared<std::vector<float>>(m_anatomy->top);
        support::eachOf(m_anatomy->grid, support::around(m_anatomy->grid, m_middle, m_middle, edge - m_middle),
                        [&](std::size_t k) { (*ideal)[k] -= 1.0F; });
        watch(&Rules::besideLimitMm, 0.5, ideal);
        QVERIFY(cut(m_middle, m_middle, 3.0F).empty());
        QVERIFY(cut(edge + static_cast<int>(0.3 / cell), m_middle, 0.5F).empty());
        const auto found = cut(edge + static_cast<int>(0.8 / cell), m_middle, 0.5F);
        QVERIFY(isOne(found, RuleViolation::WrongPlace));
        QVERIFY(support::near(found.front().value, 0.8, 1.5 * cell));
    }

    void forceCountsAfterTwoTenthsOfASecond()
    {
        watch(&Rules::forceLimitN, 3.0);
        m_state.touching = true;
        m_state.forceN = {0.0, 1.9, 2.4};  // 3.06 N
        QVERIFY(wait(200).empty());
        const auto found = wait(1);
        QVERIFY(isOne(found, RuleViolation::TooMuchForce));
        QVERIFY(support::near(found.front().value, 3.0610, 1e-3));
        QVERIFY(wait(1000).empty());
        // If the force drops for a tick, the time starts again.
        m_state.forceN = {0.0, 0.0, 1.0};
        QVERIFY(wait(1).empty());
        m_state.forceN = {0.0, 0.0, 3.5};
        QVERIFY(wait(200).empty());
        QVERIFY(isOne(wait(1), RuleViolation::TooMuchForce));
    }

    void aBurInTheAirIsToldOncePerStretch()
    {
        watch(&Rules::airLimitS, 2.0);
        m_state.drillOn = true;
        // A student who has not cut yet may be reading the task, so the time does not run.
        QVERIFY(wait(9000).empty());
        QVERIFY(cut(m_middle, m_middle, 0.2F).empty());
        m_state.touching = false;
        QVERIFY(wait(2000).empty());
        QVERIFY(isOne(wait(5000), RuleViolation::BurInAir));
        m_state.touching = true;
        QVERIFY(wait(1).empty());
        m_state.touching = false;
        QVERIFY(wait(2000).empty());
        QVERIFY(isOne(wait(1), RuleViolation::BurInAir));
        m_state.drillOn = false;
        QVERIFY(wait(9000).empty());
    }

    void withoutADeviceNothingIsBroken()
    {
        watch(&Rules::forceLimitN, 3.0);
        watch(&Rules::airLimitS, 2.0);
        m_state.drillOn = true;
        QVERIFY(cut(m_middle, m_middle, 0.2F).empty());
        m_state.touching = false;
        QVERIFY(wait(1500).empty());
        m_state.health = core::servo::kDeviceLost;
        QVERIFY(wait(60'000).empty());
        m_state.health = 0;
        QVERIFY(wait(500).empty());
        QVERIFY(isOne(wait(1), RuleViolation::BurInAir));
        // A force before the gap and one after it count separately.
        m_state.touching = true;
        m_state.forceN = {0.0, 0.0, 3.5};
        QVERIFY(wait(150).empty());
        m_state.health = core::servo::kDeviceLost;
        QVERIFY(wait(100).empty());
        m_state.health = 0;
        QVERIFY(wait(200).empty());
        QVERIFY(isOne(wait(1), RuleViolation::TooMuchForce));
    }

    void aWrongBurMayBeHeldButNotCut()
    {
        watch(&Rules::allowedBurs, 0b0011);
        m_state.burIndex = 2;
        QVERIFY(wait(100).empty());
        QVERIFY(isOne(cut(m_middle, m_middle, 0.2F), RuleViolation::WrongBur));
        QVERIFY(cut(m_middle, m_middle, 0.3F).empty());
        m_state.burIndex = 1;
        QVERIFY(cut(m_middle, m_middle, 0.4F).empty());
        m_state.burIndex = bur::kMostBurs - 1;
        QVERIFY(isOne(cut(m_middle, m_middle, 0.5F), RuleViolation::WrongBur));
    }

    void theToothBesideIsSpared()
    {
        QVERIFY(teeth::teethBeside(99) == nullptr);
        const auto neighbours = teeth::teethBeside(36);
        QVERIFY(neighbours != nullptr);
        QVERIFY(teeth::teethBeside(36) == neighbours);  // the teeth are made only once
        m_anatomy = support::builtTooth(36);
        m_tooth.emplace(m_anatomy);
        watch(&Rules::neighbours, neighbours);
        // The extent of tooth 36 along x in its middle row, where the neighbouring teeth are.
        const terrain::Grid& grid = m_anatomy->grid;
        double low = 1.0e9;
        double high = -1.0e9;
        support::eachOf(grid, {0, grid.side - 1, grid.side / 2, grid.side / 2}, [&](std::size_t k) {
            if (!m_tooth->isSolid(k))
                return;
            low = std::min(low, grid.nodeMm(k).x);
            high = std::max(high, grid.nodeMm(k).x);
        });
        m_state.burIndex = 2;
        m_state.drillOn = true;
        const auto at = [&](double x, double z) {
            m_state.anchorMm = {x, grid.nodeMm(0, grid.side / 2).y, z};
            return wait(1);
        };
        // Within its own crown, from rim to rim, the bur touches no neighbour.
        for (double x = low + 0.6; x < high - 0.6; x += 0.1)
            QVERIFY2(at(x, -2.5).empty(), qPrintable(QString::number(x)));
        for (const double beyond : {low - 0.9, high + 0.9}) {
            QVERIFY(isOne(at(beyond, -2.5), RuleViolation::NeighbourHit));
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
        QVERIFY(wait(1).empty());
    }

    void tellsAHoleThrough()
    {
        const std::size_t k = m_anatomy->grid.index(m_middle, m_middle);
        support::cutThrough(*m_tooth, k);
        // A hole where the ideal has one is not a perforation.
        auto ideal = std::make_shared<std::vector<float>>(m_anatomy->top);
        (*ideal)[k] = terrain::kEmptyTop;
        for (const bool isAsked : {false, true}) {
            watch(&Rules::perforated, true, isAsked ? ideal : nullptr);
            m_state.tick = 1;
            auto found = m_referee->look(m_state, {m_middle, m_middle, m_middle, m_middle}, *m_tooth, kTick);
            for (const Infraction& late : wait(100))
                found.push_back(late);
            QVERIFY(isAsked ? found.empty() : isOne(found, RuleViolation::Perforated));
        }
    }

    void liveAndReplayFindTheSame()
    {
        support::Rig rig;
        session::Examination examination;
        examination.rules.depthLimitMm = 0.3;
        examination.rules.forceLimitN = 0.5;
        examination.rules.airLimitS = 0.5;
        session::LiveAssessmentLoop follower(*rig.session);
        rig.open(m_anatomy);
        follower.watch(1, examination);
        rig.send(core::servo::SetDrill{true});
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

        session::LiveAssessor examiner(examination, m_anatomy);
        const auto outcome = recording::replay(concluded->recording,
                                               [&](const core::servo::ServoEvent& event,
                                                   const recording::Replayer& servo) { examiner.take(event, servo); });
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
        session::LiveAssessmentLoop follower(*rig.session);
        rig.drill(m_anatomy);
        support::RestlessHand hand(12);
        rig.follow(hand, 2000);
        // More steps than are stored for a loop that falls behind.
        for (int n = 0; n < 600; ++n) {
            rig.send(n % 2 == 0 ? session::SessionCommand{session::Undo{}} : session::SessionCommand{session::Redo{}});
            rig.run(2);
        }
        rig.follow(hand, 500);
        const auto concluded = follower.conclude();
        QVERIFY(concluded.has_value());
        const auto outcome = recording::replay(concluded->recording);
        QVERIFY(outcome.has_value());
        QCOMPARE(terrain::stateHash(concluded->tooth), outcome->stateHash);
        QCOMPARE(concluded->findings.ticks, concluded->recording.ticks());
    }

private:
    /// Watches this rule in addition to the ones set before.
    template <class Limit>
    void watch(Limit Rules::*rule, const std::type_identity_t<Limit>& limit, const IdealTop& ideal = nullptr)
    {
        m_rules.*rule = limit;
        m_referee.emplace(m_rules, m_anatomy, ideal);
    }
    /// Lowers column (i, j) to this depth below the original surface and runs the checker.
    std::vector<Infraction> cut(int i, int j, float depthMm)
    {
        const std::size_t k = m_anatomy->grid.index(i, j);
        m_tooth->top[k] = m_anatomy->top[k] - depthMm;
        ++m_state.tick;
        m_state.cutting = true;
        m_state.touching = true;
        return m_referee->look(m_state, {i, j, i, j}, *m_tooth, kTick);
    }
    std::vector<Infraction> wait(int ticks)
    {
        std::vector<Infraction> all;
        for (int n = 0; n < ticks; ++n) {
            ++m_state.tick;
            for (const Infraction& infraction : m_referee->look(m_state, {}, *m_tooth, kTick))
                all.push_back(infraction);
        }
        return all;
    }

    std::shared_ptr<const terrain::ToothAnatomy> m_anatomy;
    std::optional<terrain::Tooth> m_tooth;
    Rules m_rules;
    std::optional<RuleChecker> m_referee;
    core::servo::ServoState m_state;
    int m_middle = 0;
};

CUSP_TEST(TestReferee)
#include "tst_rule_checker.moc"
