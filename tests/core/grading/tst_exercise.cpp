// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include <limits>

#include "core/base/Rng.h"
#include "core/grading/MeasureTable.h"
#include "core/servo/ServoState.h"
#include "core/session/LiveAssessmentLoop.h"
#include "core/session/SessionChannels.h"
#include "core/teeth/Block.h"
#include "core/teeth/ToothBuilder.h"
#include "haptics/pointer/PointerDevice.h"
#include "tests/support/Checks.h"
#include "tests/support/Rig.h"
#include "tests/support/Suite.h"
#include "tests/support/SyntheticTooth.h"
#include "tests/support/Tables.h"

using namespace core;
using namespace core::grading;
using namespace std::chrono_literals;
using terrain::Material;

namespace {

/// Returns the state of a bur that rests on the tooth.
core::servo::ServoState pressing(double newtons, glm::dvec2 at = {0.0, 0.0}, bool drillOn = false)
{
    core::servo::ServoState state;
    state.anchorMm = state.deviceMm = {at, 0.0};
    state.forceN = {0.0, 0.0, newtons};
    state.touching = true;
    state.drillOn = drillOn;
    return state;
}

core::servo::ServoState stateInAir()
{
    return {};
}

void practise(ExerciseMeter& meter, const core::servo::ServoState& state, int ticks)
{
    for (int n = 0; n < ticks; ++n)
        meter.take(state, 1ms);
}

std::optional<double> measuredOf(const char* id, const Practised& practised)
{
    Measured all;
    all.practised = practised;
    return findMeasure(id).value().value(all);
}

const Held& held(const ExerciseMeter& meter)
{
    return std::get<Held>(meter.practised());
}

PointsToTouch threePoints()
{
    return {{{0.0, 0.0}, {2.0, 0.0}, {0.0, 3.0}}, 0.5};
}

}  // namespace

class TestExercise : public QObject
{
    Q_OBJECT

private slots:
    void pointsCountInAnyOrderWithTheirTime()
    {
        ExerciseMeter meter(threePoints());
        QVERIFY(!isBegun(meter.practised()));
        practise(meter, stateInAir(), 1000);
        practise(meter, pressing(0.5, {0.1, 2.8}), 1);
        practise(meter, stateInAir(), 499);
        practise(meter, pressing(0.5, {0.3, 0.3}), 1000);
        const auto& touched = std::get<Touched>(meter.practised());
        QCOMPARE(touched.atS, (std::vector<std::optional<double>>{1.501, std::nullopt, 1.001}));
        QCOMPARE(measuredOf("points_touched_percent", meter.practised()), std::optional(100.0 * (2.0 / 3.0)));
        QCOMPARE(measuredOf("time_to_touch_all_s", meter.practised()), std::nullopt);
        QVERIFY(isBegun(meter.practised()) && !isDone(meter.practised()));
        practise(meter, pressing(0.5, {2.0, -0.4}), 1);
        QVERIFY(isDone(meter.practised()));
        QCOMPARE(measuredOf("points_touched_percent", meter.practised()), std::optional(100.0));
        QCOMPARE(measuredOf("time_to_touch_all_s", meter.practised()), std::optional(2.501));
        // A second touch of the same point changes nothing.
        practise(meter, pressing(0.5, {0.0, 0.0}), 100);
        QCOMPARE(measuredOf("time_to_touch_all_s", meter.practised()), std::optional(2.501));
    }

    void noTouchCounts_data()
    {
        support::columns<double, bool, bool, bool>("newtons", "drill", "touching", "lost");
        QTest::newRow("in the air above it") << 0.0 << false << false << false;
        QTest::newRow("a graze") << 0.09 << false << true << false;
        QTest::newRow("with the drill on") << 1.0 << true << true << false;
        QTest::newRow("the device is lost") << 1.0 << false << true << true;
        QTest::newRow("a force that is no number")
            << std::numeric_limits<double>::quiet_NaN() << false << true << false;
    }

    void noTouchCounts()
    {
        QFETCH(double, newtons);
        QFETCH(bool, drill);
        QFETCH(bool, touching);
        QFETCH(bool, lost);
        core::servo::ServoState state = pressing(newtons, {0.0, 0.0}, drill);
        state.touching = touching;
        state.health = lost ? core::servo::kDeviceLost : 0U;
        ExerciseMeter meter(threePoints());
        practise(meter, state, 1000);
        QCOMPARE(std::get<Touched>(meter.practised()).count(), std::size_t{0});
        // For the force exercise, a light touch is a force like any other.
        ExerciseMeter holding(ForceToHold{1.0, 1.0, 10.0});
        practise(holding, state, 12000);
        const bool counts = std::isfinite(newtons) && touching && !drill && !lost;
        QCOMPARE(isBegun(holding.practised()), counts);
        QCOMPARE(held(holding).heldS, counts ? 10.0 : 0.0);
        QCOMPARE(held(holding).longestS, counts ? 10.0 : 0.0);
    }

    void aReachEndsWhereItIsSaid()
    {
        for (const double at : {0.499, 0.501}) {
            ExerciseMeter meter(PointsToTouch{{{1.0, 1.0}}, 0.5});
            practise(meter, pressing(0.5, {1.0 - at, 1.0}), 1);
            QCOMPARE(isDone(meter.practised()), at < 0.5);
        }
    }

    void aForceIsHeldToTheTick()
    {
        ExerciseMeter meter(ForceToHold{1.0, 0.2, 10.0});
        practise(meter, pressing(0.7), 500);  // not in the band yet, so no contact that counts
        practise(meter, pressing(1.1), 9999);
        QVERIFY(!isDone(meter.practised()));
        QCOMPARE(held(meter).longestS, 9.999);
        QCOMPARE(held(meter).nowS, 9.999);
        practise(meter, pressing(1.1), 1);
        QVERIFY(isDone(meter.practised()));
        QCOMPARE(measuredOf("hold_longest_s", meter.practised()), std::optional(10.0));
        QCOMPARE(measuredOf("hold_within_percent", meter.practised()), std::optional(100.0));
        QVERIFY(support::near(*measuredOf("hold_error_n", meter.practised()), 0.1));
    }

    void aTrembleDoesNotEndTheStretchAndALapseDoes()
    {
        ExerciseMeter meter(ForceToHold{1.0, 0.2, 10.0});
        practise(meter, pressing(1.0), 2000);
        practise(meter, pressing(1.5), 200);
        practise(meter, pressing(1.0), 1000);
        QCOMPARE(held(meter).nowS, 3.0);  // time outside the band does not count
        practise(meter, stateInAir(), 201);
        QCOMPARE(held(meter).nowS, 0.0);
        practise(meter, pressing(0.9), 500);
        QCOMPARE(held(meter).nowS, 0.5);
        QCOMPARE(held(meter).longestS, 3.0);
        QCOMPARE(held(meter).heldS, 3.5);
        QCOMPARE(held(meter).pressedS, 3.7);
        QCOMPARE(measuredOf("hold_within_percent", meter.practised()), std::optional(100.0 * (3.5 / 3.7)));
    }

    void aLostDeviceEndsTheStretch()
    {
        core::servo::ServoState lost = stateInAir();
        lost.health = core::servo::kDeviceLost;
        ExerciseMeter meter(ForceToHold{1.0, 0.2, 10.0});
        practise(meter, pressing(1.0), 6000);
        practise(meter, lost, 200);
        QCOMPARE(held(meter).nowS, 6.0);
        practise(meter, lost, 1);
        QCOMPARE(held(meter).nowS, 0.0);
        practise(meter, pressing(1.0), 6000);
        QVERIFY(!isDone(meter.practised()));
        QCOMPARE(held(meter).longestS, 6.0);
        QCOMPARE(measuredOf("hold_within_percent", meter.practised()), std::optional(100.0));
    }

    void theMeanErrorIsThatOfTheContact()
    {
        ExerciseMeter meter(ForceToHold{1.0, 0.2, 10.0});
        QCOMPARE(measuredOf("hold_error_n", meter.practised()), std::nullopt);
        QCOMPARE(measuredOf("hold_within_percent", meter.practised()), std::nullopt);
        QCOMPARE(measuredOf("hold_longest_s", meter.practised()), std::optional(0.0));
        practise(meter, pressing(1.0), 1000);
        practise(meter, pressing(2.0), 500);
        practise(meter, pressing(0.5), 500);
        practise(meter, stateInAir(), 5000);
        QVERIFY(support::near(*measuredOf("hold_error_n", meter.practised()), (0.5 + 0.25) / 2.0));
        QCOMPARE(measuredOf("hold_within_percent", meter.practised()), std::optional(50.0));
    }

    void whatComesAfterItWasHeldChangesNothing()
    {
        ExerciseMeter meter(ForceToHold{1.0, 0.2, 2.0});
        practise(meter, pressing(1.05), 2000);
        const Practised then = meter.practised();
        QVERIFY(isDone(then));
        practise(meter, pressing(3.0), 5000);
        QVERIFY(meter.practised() == then);
    }

    void theLastAnswerCounts()
    {
        const PadsToName pads{teeth::padMaterials(3)};
        ExerciseMeter meter(pads);
        QCOMPARE(measuredOf("layers_named_percent", meter.practised()), std::optional(0.0));
        for (std::size_t pad = 0; pad < kPads; ++pad)
            meter.noted(answerNote(pad, pads.madeOf[0]));
        QVERIFY(isDone(meter.practised()));
        QCOMPARE(measuredOf("layers_named_percent", meter.practised()), std::optional(100.0 * (1.0 / 3.0)));
        meter.noted(answerNote(2, pads.madeOf[2]));
        QCOMPARE(std::get<Named>(meter.practised()).right, std::size_t{2});
        meter.noted(answerNote(1, pads.madeOf[1]));
        QCOMPARE(measuredOf("layers_named_percent", meter.practised()), std::optional(100.0));
        meter.noted(answerNote(0, pads.madeOf[2]));
        QCOMPARE(std::get<Named>(meter.practised()).right, std::size_t{2});
    }

    void notesThatAreNoAnswersAreNothing()
    {
        for (std::size_t pad = 0; pad < kPads; ++pad)
            for (const Material said : {Material::Caries, Material::Enamel, Material::Dentin, Material::Pulp})
                QCOMPARE(answerOf(answerNote(pad, said)), (std::optional(Answer{pad, said})));
        ExerciseMeter meter(PadsToName{teeth::padMaterials(3)});
        const std::uint64_t answer = answerNote(0, Material::Enamel);
        Rng rng(5);
        for (const std::uint64_t note : {std::uint64_t{0}, std::uint64_t{1}, ~std::uint64_t{0}, answer | 0x300U,
                                         answer | 0x80U, answer | 0x10000U, answer ^ (std::uint64_t{1} << 63U)}) {
            QVERIFY2(!answerOf(note), qPrintable(QString::number(note, 16)));
            meter.noted(note);
        }
        for (int n = 0; n < 1000; ++n)
            meter.noted(rng.next() >> 1U << 32U);
        QVERIFY(!isBegun(meter.practised()));
        // Another exercise ignores the answer.
        ExerciseMeter holding(ForceToHold{});
        holding.noted(answer);
        QVERIFY(holding.practised() == Practised(Held{}));
    }

    void ofAnotherExerciseNothingIsMeasured()
    {
        const auto known = [](const Practised& practised) {
            QStringList ids;
            for (const char* id : {"points_touched_percent", "time_to_touch_all_s", "hold_longest_s",
                                   "hold_within_percent", "hold_error_n", "layers_named_percent"})
                if (measuredOf(id, practised))
                    ids << id;
            return ids.join(' ');
        };
        QCOMPARE(known(Touched{{1.0, 2.0}}), QStringLiteral("points_touched_percent time_to_touch_all_s"));
        QCOMPARE(known(Held{1.0, 0.0, 1.0, 2.0, 0.1, false}),
                 QStringLiteral("hold_longest_s hold_within_percent hold_error_n"));
        QCOMPARE(known(Named{}), QStringLiteral("layers_named_percent"));
    }

    /// For the points, the force and the layers.
    void liveAndReplayFindTheSame_data() { support::rows<int>("which", {0, 1, 2}); }

    void liveAndReplayFindTheSame()
    {
        QFETCH(int, which);
        const auto block = support::makeBlock({});
        session::Examination examination;
        const Exercise all[] = {threePoints(), ForceToHold{1.0, 0.4, 60.0}, PadsToName{teeth::padMaterials(2)}};
        examination.exercise = all[which];
        support::Rig rig;
        session::LiveAssessmentLoop follower(*rig.session);
        rig.open(block);
        follower.watch(1, examination);
        Rng rng(7);
        for (int n = 0; n < 60; ++n) {
            rig.lean(rng.uniform(-3.0, 3.0), rng.uniform(-3.0, 3.0), rng.uniform(0.5, 1.5), 60);
            rig.lean(2.0 * (n % 2), 0.0, 1.0, 60);
            rig.send(session::AddNote{
                answerNote(static_cast<std::size_t>(rng.below(3)), static_cast<Material>(rng.below(3)))});
            if (n % 7 == 0)
                rig.send(core::servo::SetDrill{n % 2 == 0});
            if (n % 10 == 0)
                rig.send(session::Undo{});
            if (n % 3 == 0)
                follower.tick(50ms);
        }
        const auto concluded = follower.conclude();
        QVERIFY(concluded.has_value());
        QVERIFY(concluded->findings.practised.has_value());
        QVERIFY(isBegun(*concluded->findings.practised));
        const auto examined = [&](const recording::Recording& recording) {
            session::LiveAssessor examiner(examination, block);
            const auto outcome =
                recording::replay(recording, [&](const core::servo::ServoEvent& event,
                                                 const recording::Replayer& servo) { examiner.take(event, servo); });
            return outcome ? examiner.practised() : std::nullopt;
        };
        QVERIFY(examined(concluded->recording) == concluded->findings.practised);
        // The recording read from its file gives the same.
        const auto read = recording::Recording::fromBytes(concluded->recording.toBytes());
        QVERIFY(read.has_value());
        QVERIFY(examined(*read) == concluded->findings.practised);
    }

    /// Under the same force, decay yields far faster than dentin, and dentin faster than enamel, so that a student can
    /// tell them apart.
    void theThreeLayersGiveWayDifferently()
    {
        constexpr std::uint64_t kSeed = 5;
        teeth::BuildOptions options;
        options.seed = kSeed;
        const auto built = teeth::buildTooth({teeth::findBlock("block:layers").value().value()}, options);
        QVERIFY(built.has_value());
        std::map<Material, double> sunkMm;
        for (std::size_t pad = 0; pad < kPads; ++pad) {
            support::Rig rig;
            rig.open(built->anatomy);
            rig.give(core::servo::SetBur{0});
            rig.lean(teeth::kPadX[pad], 0.0, 0.6, 500);
            const double before = rig.servo->state().anchorMm.z;
            rig.send(core::servo::SetDrill{true});
            rig.lean(teeth::kPadX[pad], 0.0, 0.6, 1000);
            sunkMm[teeth::padMaterials(kSeed)[pad]] = before - rig.servo->state().anchorMm.z;
        }
        QVERIFY(sunkMm[Material::Enamel] > 0.05);
        QVERIFY(sunkMm[Material::Dentin] > 1.5 * sunkMm[Material::Enamel]);
        QVERIFY(sunkMm[Material::Caries] > 1.5 * sunkMm[Material::Dentin]);
    }

    /// A mouse presses with 1 N into the pit of the tooth of the shipped exercise.
    void aMouseHoldsANewton()
    {
        const auto built = teeth::buildTooth({36}, {});
        QVERIFY(built.has_value());
        rt::TripleBuffer<core::servo::PointerInput> wishes;
        haptics::PointerDevice device(wishes, contact::ForceSettings{}.stiffnessNPerMm, 0.001);
        const support::Bench bench(terrain::Tooth(built->anatomy), "2");
        bench.servo->setDrill(false);
        ExerciseMeter meter(ForceToHold{});
        const auto run = [&](const core::servo::PointerInput& wish, int ticks) {
            for (int n = 0; n < ticks; ++n) {
                wishes.publish(wish);
                const auto sample = device.exchange(bench.state().forceN);
                bench.servo->step(&sample.tipInToothMm, 1ms);
                meter.take(bench.state(), 1ms);
            }
        };
        core::servo::PointerInput wish;
        wish.targetMm = {-0.27, 0.64};
        wish.hoverMm = 1.0;
        wish.pushForceN = 1.0;
        run(wish, 500);
        wish.pushing = true;
        run(wish, 11500);
        QVERIFY(isDone(meter.practised()));
        QVERIFY(held(meter).meanErrorN < 0.1);
    }
};

CUSP_TEST(TestExercise)
#include "tst_exercise.moc"
