// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include <cmath>

#include "core/recording/Player.h"
#include "core/servo/ServoState.h"
#include "core/session/SessionChannels.h"
#include "lessons/LessonCatalog.h"
#include "lessons/PointLossTimeline.h"
#include "tests/support/Rig.h"
#include "tests/support/Suite.h"
#include "tests/support/SyntheticTooth.h"

using namespace lessons;
using core::recording::Recording;
using core::servo::ServoEvent;
using support::Rig;

namespace {

constexpr double kNewtons = 1.5;
constexpr int kPressTicks = 300;

std::shared_ptr<const core::terrain::ToothAnatomy> block(double cariesFloorMm = 100.0)
{
    support::Block made;
    made.side = 64;
    made.cellMm = 0.12;
    made.cariesFloorMm = cariesFloorMm;
    return support::makeBlock(made);
}

CriterionRule rule(const char* id, const char* measure, double tolerance, double span, int weightTenths)
{
    CriterionRule made;
    made.id = id;
    made.measure = measure;
    made.tolerance = tolerance;
    made.span = span;
    made.weightTenths = weightTenths;
    made.critical = weightTenths == 0;
    return made;
}

Assignment assignmentWith(const std::shared_ptr<const core::terrain::ToothAnatomy>& anatomy,
                          const std::vector<CriterionRule>& criteria, Verdict verdict = Verdict::SumOfErrors)
{
    Assignment made;
    made.anatomy = anatomy;
    made.rubric.id = "test";
    made.rubric.verdict = verdict;
    made.rubric.criteria = criteria;
    return made;
}

/// A rig whose bur is running.
struct ReadyRig : support::Rig
{
    explicit ReadyRig(const Assignment& assignment)
    {
        open(assignment.anatomy);
        send(core::servo::SetDrill{true});
        run(1500);  // up to speed, in the air
    }
    [[nodiscard]] Recording recording() const { return session->recordingSoFar().value(); }
    void takeBack()
    {
        send(core::session::Undo{});
        run(50);
    }
};

void stroke(Rig& rig, double x, double y)
{
    rig.lean(x, y, kNewtons, kPressTicks);
    rig.lift();
}

int lostNow(const Assignment& assignment, const Rig& rig, std::size_t criterion)
{
    return mark(assignment, rig.live()).value().sheet.criteria.at(criterion).lostTenths;
}

PointLossTimeline momentsIn(const Assignment& assignment, const Recording& recording)
{
    return momentsOf(assignment, recording).value().value();
}

/// Checks that each criterion's moments add up to its loss, that they are in order, and that the score sheet is the one
/// that marking alone gives.
bool isSound(const Assignment& assignment, const Recording& recording, const PointLossTimeline& found)
{
    core::session::LiveAssessor examiner(examinationOf(assignment), recording.anatomy());
    const auto outcome =
        core::recording::replay(recording, [&](const ServoEvent& event, const core::recording::Replayer& servo) {
            examiner.take(event, servo);
        });
    const auto marked =
        mark(assignment, outcome->tooth,
             Conduct{examiner.process(), examiner.infractions(), examiner.aids(), examiner.practised()});
    if (!(found.sheet == marked->sheet) || found.ofCriteria.size() != found.sheet.criteria.size())
        return false;
    for (std::size_t k = 0; k < found.ofCriteria.size(); ++k) {
        int sum = 0;
        bool mayBeNever = true;
        std::uint64_t last = 0;
        for (const Moment& moment : found.ofCriteria[k]) {
            sum += moment.lostTenths;
            if (moment.kind == Moment::Kind::Never) {
                if (!mayBeNever || moment.tick != recording.ticks())
                    return false;
            } else if (moment.tick < last || moment.tick == 0 || moment.tick > recording.ticks()) {
                return false;
            } else {
                last = moment.tick;
            }
            mayBeNever = false;
        }
        if (sum != found.sheet.criteria[k].lostTenths)
            return false;
    }
    return true;
}

PointLossTimeline soundMoments(const Assignment& assignment, const Recording& recording)
{
    const PointLossTimeline found = momentsIn(assignment, recording);
    QTest::qVerify(isSound(assignment, recording, found), "isSound", "", __FILE__, __LINE__);
    return found;
}

/// Returns whether the moment belongs to this stroke and loses so many points.
bool isOfStroke(const Moment& moment, int stroke, int lostTenths)
{
    return moment.kind == Moment::Kind::Stroke && moment.stroke == stroke && moment.lostTenths == lostTenths;
}

/// Returns a lesson in which only the removal of sound tissue costs points.
Assignment soundAlone(double spanMm3 = 2.0)
{
    return assignmentWith(block(), {rule("sound", "sound_overcut_mm3", 0.0, spanMm3, 1000)});
}

}  // namespace

class TestMoments : public QObject
{
    Q_OBJECT

private slots:
    void soundTissueIsLostByTheStrokeThatCutIt()
    {
        const Assignment assignment = soundAlone();
        ReadyRig rig(assignment);
        std::vector<int> expected;
        int before = 0;
        for (int k = 0; k < 3; ++k) {
            stroke(rig, -2.0 + 2.0 * k, 0.5 * k);
            expected.push_back(lostNow(assignment, rig, 0) - before);
            before += expected.back();
            QVERIFY(expected.back() > 5);
        }
        const PointLossTimeline found = soundMoments(assignment, rig.recording());
        const auto player = core::recording::Player::make(rig.recording()).value();
        while (player->advance(1000)) {
        }
        const auto strokes = player->strokes();
        QCOMPARE(strokes.size(), std::size_t(3));
        const auto& moments = found.ofCriteria.front();
        QCOMPARE(moments.size(), std::size_t(3));
        for (std::size_t k = 0; k < 3; ++k) {
            QVERIFY(isOfStroke(moments[k], static_cast<int>(k + 1), expected[k]));
            QCOMPARE(moments[k].tick, strokes[k].from);
            QVERIFY(std::abs(moments[k].seconds - 1.0e-3 * static_cast<double>(strokes[k].from - 1)) < 1.0e-9);
        }
    }

    void decayThatIsLeftWasNeverRemoved()
    {
        const Assignment assignment =
            assignmentWith(block(-0.4), {rule("left", "caries_left_percent", 0.0, 100.0, 1000)});
        ReadyRig rig(assignment);
        stroke(rig, 0.0, 0.0);
        stroke(rig, 1.0, 0.0);
        const PointLossTimeline found = soundMoments(assignment, rig.recording());
        const int lost = lostNow(assignment, rig, 0);
        QVERIFY(lost > 100 && lost < 1000);
        QCOMPARE(found.ofCriteria.front().size(), std::size_t(1));
        const Moment& never = found.ofCriteria.front().front();
        QCOMPARE(never.kind, Moment::Kind::Never);
        QCOMPARE(never.lostTenths, lost);
        QCOMPARE(never.tick, rig.recording().ticks());
        QCOMPARE(never.seconds, std::chrono::duration<double>(rig.recording().duration()).count());
    }

    /// With a condition (`once`): when the condition is met, points are lost by the strokes that cost them. Before, the
    /// loss belongs to no stroke.
    void whatIsNotEarnedYetIsOfNoStroke()
    {
        ReadyRig rig(soundAlone());
        stroke(rig, -2.0, 0.0);
        stroke(rig, 1.0, 0.0);
        const Recording recording = rig.recording();
        const double cut = core::grading::measure(rig.live()).overcutMm3;
        const auto momentsOnce = [&](double reaches) {
            Assignment assignment = soundAlone();
            assignment.rubric.criteria[0].once = Once{"removed_mm3", "mm3", reaches};
            return soundMoments(assignment, recording);
        };
        const PointLossTimeline free = momentsOnce(0.0);
        const PointLossTimeline due = momentsOnce(0.99 * cut);
        const PointLossTimeline early = momentsOnce(1.01 * cut);
        QCOMPARE(free.ofCriteria[0].size(), std::size_t{2});
        QVERIFY(due.ofCriteria == free.ofCriteria);
        QCOMPARE(early.ofCriteria[0].size(), std::size_t{1});
        QCOMPARE(early.ofCriteria[0][0].kind, Moment::Kind::Never);
        QCOMPARE(early.ofCriteria[0][0].lostTenths, 1000);
    }

    /// The error of a depth falls while the cut approaches the target and rises when it continues. The final loss
    /// belongs to the strokes that continued.
    void pointsThatWereWonAndLostAreOfTheStrokeThatLostThem()
    {
        CriterionRule depth = rule("depth", "deepest_cut_mm", 0.0, 1.0, 1000);
        depth.side = Side::Both;
        Assignment assignment = assignmentWith(block(), {depth});
        std::vector<double> depths;
        {
            ReadyRig rig(assignment);
            for (int k = 0; k < 3; ++k) {
                stroke(rig, 0.0, 0.0);
                depths.push_back(core::grading::measure(rig.live()).deepestCutMm);
            }
        }
        assignment.rubric.criteria.front().target = depths[0];
        ReadyRig rig(assignment);
        std::vector<int> lost;
        for (int k = 0; k < 3; ++k) {
            stroke(rig, 0.0, 0.0);
            lost.push_back(lostNow(assignment, rig, 0));
        }
        QCOMPARE(lost[0], 0);
        QVERIFY(lost[1] > 20 && lost[2] > lost[1] + 20);
        const PointLossTimeline found = soundMoments(assignment, rig.recording());
        const auto& moments = found.ofCriteria.front();
        QCOMPARE(moments.size(), std::size_t(2));
        QVERIFY(isOfStroke(moments[0], 2, lost[1]) && isOfStroke(moments[1], 3, lost[2] - lost[1]));
    }

    void whatIsTakenBackTakesItsMomentsAlong()
    {
        const Assignment assignment = soundAlone();
        ReadyRig rig(assignment);
        stroke(rig, -2.0, 0.0);
        const int first = lostNow(assignment, rig, 0);
        stroke(rig, 0.0, 0.0);
        rig.takeBack();
        QCOMPARE(lostNow(assignment, rig, 0), first);
        stroke(rig, 2.0, 0.0);
        const int both = lostNow(assignment, rig, 0);
        const PointLossTimeline found = soundMoments(assignment, rig.recording());
        const auto& moments = found.ofCriteria.front();
        QCOMPARE(moments.size(), std::size_t(2));
        QVERIFY(isOfStroke(moments[0], 1, first) && isOfStroke(moments[1], 3, both - first));
    }

    void whatIsDoneAgainHasItsMomentsAgain()
    {
        const Assignment assignment = soundAlone();
        ReadyRig rig(assignment);
        stroke(rig, -2.0, 0.0);
        stroke(rig, 0.0, 0.0);
        const PointLossTimeline before = momentsIn(assignment, rig.recording());
        rig.takeBack();
        rig.send(core::session::Redo{});
        rig.run(50);
        const PointLossTimeline found = soundMoments(assignment, rig.recording());
        QCOMPARE(found.ofCriteria.front().size(), std::size_t(2));
        QCOMPARE(found.ofCriteria, before.ofCriteria);
    }

    void timeIsLostWhenItPasses()
    {
        // Each 10 ms beyond 2 s costs a tenth of a point.
        const Assignment assignment = assignmentWith(block(), {rule("time", "time_total_s", 2.0, 10.0, 1000)});
        ReadyRig rig(assignment);
        stroke(rig, 0.0, 0.0);
        rig.run(400);
        const PointLossTimeline found = soundMoments(assignment, rig.recording());
        const auto& moments = found.ofCriteria.front();
        QVERIFY(moments.size() > 20);
        int lost = 0;
        for (const Moment& moment : moments) {
            QCOMPARE(moment.kind, Moment::Kind::Way);
            lost += moment.lostTenths;
            const double due = 2.0 + 0.01 * (lost - 0.5);
            QVERIFY2(moment.seconds >= due - 1.0e-9 && moment.seconds < due + 0.0101,
                     qPrintable(QString::number(moment.seconds)));
        }
    }

    void aCriticalFaultHasTheMomentOfTheFault()
    {
        auto anatomy = support::slab(-0.1F);
        for (core::terrain::ColumnLayers& column : anatomy->layers) {
            column.pulpRoof = -0.25F;
            column.pulpFloor = -5.0F;
        }
        const Assignment assignment = assignmentWith(anatomy, {rule("sound", "sound_overcut_mm3", 0.0, 20.0, 1000),
                                                               rule("pulp", "pulp_exposed_mm2", 0.0, 0.0, 0),
                                                               rule("deep", "deepest_cut_mm", 0.25, 0.0, 0)});
        ReadyRig rig(assignment);
        int fault = 0;
        for (int n = 1; fault == 0 && n < 20; ++n) {
            rig.lean(0.0, 0.0, kNewtons, 60);
            rig.lift();
            if (core::grading::measure(rig.live()).pulpExposedMm2 > 0.0)
                fault = n;
        }
        QVERIFY(fault > 1);
        stroke(rig, 1.0, 1.0);
        const PointLossTimeline found = soundMoments(assignment, rig.recording());
        QCOMPARE(found.sheet.totalTenths, 0);
        for (const std::size_t critical : {std::size_t{1}, std::size_t{2}}) {
            QCOMPARE(found.ofCriteria[critical].size(), std::size_t(1));
            QCOMPARE(found.ofCriteria[critical].front().stroke, fault);
        }
        QCOMPARE(found.ofCriteria[1].front().lostTenths, found.sheet.criteria[1].lostTenths);
        QVERIFY(found.ofCriteria[1].front().lostTenths > 0);
        QCOMPARE(found.ofCriteria[2].front().lostTenths, 0);  // there was nothing left to lose
    }

    void onlyTheWorstErrorHasMoments()
    {
        const Assignment assignment = assignmentWith(
            block(),
            {rule("sound", "sound_overcut_mm3", 0.0, 2.0, 500), rule("dentin", "enamel_removed_mm3", 0.0, 4.0, 500)},
            Verdict::WorstError);
        ReadyRig rig(assignment);
        stroke(rig, -2.0, 0.0);
        stroke(rig, 1.0, 0.0);
        const PointLossTimeline found = soundMoments(assignment, rig.recording());
        QCOMPARE(found.ofCriteria[0].size(), std::size_t(2));
        QVERIFY(found.ofCriteria[1].empty());
    }

    void aLongStrokeIsLookedAtEverySecond()
    {
        const Assignment assignment = soundAlone(20.0);
        ReadyRig rig(assignment);
        for (int n = 0; n < 3500; ++n)
            rig.lean(-2.5 + 0.0014 * n, 0.0, kNewtons, 1);
        rig.lift();
        const PointLossTimeline found = soundMoments(assignment, rig.recording());
        const auto& moments = found.ofCriteria.front();
        QVERIFY(moments.size() >= 4);
        for (std::size_t k = 0; k < moments.size(); ++k) {
            QCOMPARE(moments[k].stroke, 1);
            if (k > 0)
                QVERIFY(moments[k].tick - moments[k - 1].tick <= 1200);
        }
    }

    void momentsOfRestlessWorkAddUp()
    {
        for (const std::uint64_t seed : {1U, 2U, 3U}) {
            Assignment assignment = assignmentWith(
                block(-0.5),
                {rule("left", "caries_left_percent", 1.0, 100.0, 300),
                 rule("sound", "sound_overcut_mm3", 0.5, 20.0, 200), rule("air", "drill_in_air_s", 1.0, 9.0, 100),
                 rule("force", "force_p95_n", 0.2, 2.0, 100), rule("cut", "deepest_cut_mm", 0.3, 3.0, 100),
                 rule("undo", "undo_count", 1.0, 9.0, 100), rule("jerk", "jerk_rms_mm_s3", 10.0, 50000.0, 100)},
                seed == 3 ? Verdict::WorstError : Verdict::SumOfErrors);
            // An allowance that depends on a measure of the process.
            assignment.rubric.criteria[4].allowance = Allowance{"time_cutting_s", 0.01};
            ReadyRig rig(assignment);
            support::RestlessHand hand(seed);
            core::Rng rng(seed);
            for (int n = 0; n < 9000; ++n) {
                rig.device.tipMm = hand.next();
                rig.run(1, std::chrono::milliseconds(rng.below(50) == 0 ? 3 : 1));
                const int act = rng.below(900);
                if (act < 2)
                    rig.send(core::session::Undo{});
                else if (act == 2)
                    rig.send(core::session::Redo{});
            }
            rig.settle();
            soundMoments(assignment, rig.recording());
        }
    }

    void momentsOfRestlessWorkAtAnIdealAddUp()
    {
        for (const CatalogEntry& entry : readCatalog({})) {
            if (entry.read.lesson->id != "block-cross" && entry.read.lesson->id != "class1-36")
                continue;
            const Assignment assignment = assign(*entry.read.lesson).value().assignment;
            ReadyRig rig(assignment);
            support::RestlessHand hand(5);
            for (int n = 0; n < 20000; ++n) {
                rig.device.tipMm = hand.next();
                rig.run(1);
                if (n % 1700 == 1600)
                    rig.send(core::session::Undo{});
            }
            rig.settle();
            soundMoments(assignment, rig.recording());
        }
    }

    void itCanBeLeftOff()
    {
        const Assignment assignment = soundAlone();
        ReadyRig rig(assignment);
        stroke(rig, 0.0, 0.0);
        const Recording recording = rig.recording();
        std::vector<double> shares;
        const auto whole = momentsOf(assignment, recording, [&](double share) {
            shares.push_back(share);
            return true;
        });
        QVERIFY(whole.value().has_value());
        QVERIFY(shares.size() > 3);
        QVERIFY(std::is_sorted(shares.begin(), shares.end()));
        QVERIFY(shares.front() == 0.0 && shares.back() < 1.0);
        const auto none = momentsOf(assignment, recording, [](double share) { return share < 0.5; });
        QVERIFY(none.has_value());
        QVERIFY(!none->has_value());
    }
};

CUSP_TEST(TestMoments)
#include "tst_point_loss_timeline.moc"
