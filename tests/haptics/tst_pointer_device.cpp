// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/cutting/Feed.h"
#include "core/rt/TripleBuffer.h"
#include "core/servo/ServoState.h"
#include "core/servo/ServoTick.h"
#include "haptics/pointer/PointerDevice.h"
#include "tests/support/Suite.h"
#include "tests/support/SyntheticTooth.h"
#include "tests/support/Tables.h"

using namespace core;
using namespace std::chrono_literals;

namespace {

/// The pointer's hand, connected to a servo tick.
struct Bench
{
    rt::TripleBuffer<core::servo::PointerInput> input;
    std::unique_ptr<contact::LiveTooth> tooth;
    std::unique_ptr<core::servo::ServoTick> servo = core::servo::makeServoTick({}).value();
    haptics::PointerDevice device{input, contact::ForceSettings{}.stiffnessNPerMm, 0.001};
    core::servo::PointerInput want;
    glm::vec3 tipMm{0.0F};
    std::optional<bool> pedal;

    explicit Bench(const support::Block& block, bool drill = false)
        : tooth(std::make_unique<contact::LiveTooth>(terrain::Tooth(support::makeBlock(block))))
    {
        servo->setBur(1);
        servo->swapTooth(tooth.get(), true);
        servo->setDrill(drill);
    }
    /// Runs for some ticks and returns the largest force.
    double run(int ticks)
    {
        double most = 0.0;
        for (int n = 0; n < ticks; ++n) {
            input.publish(want);
            device.seeBur(servo->state().anchorMm);
            const haptics::DeviceSample sample = device.exchange(servo->state().forceN);
            tipMm = sample.tipInToothMm;
            pedal = sample.pedal;
            servo->step(&tipMm, 1ms);
            most = std::max(most, force());
        }
        return most;
    }
    [[nodiscard]] double force() const { return glm::length(servo->state().forceN); }
};

}  // namespace

class TestPointerDevice : public QObject
{
    Q_OBJECT
private slots:
    void forceBuildsUpAndHolds_data()
    {
        support::columns<double, bool>("newtons", "drill");
        for (const double newtons : {0.5, 1.0, 2.0, 4.0})
            for (const bool drill : {false, true})
                QTest::addRow("%g N, %s", newtons, drill ? "drilling" : "resting") << newtons << drill;
    }

    void forceBuildsUpAndHolds()
    {
        QFETCH(double, newtons);
        QFETCH(bool, drill);
        support::Block block;
        block.bottomMm = -13.0;  // too thick to bore through within the time
        Bench bench(block, drill);
        bench.want.hoverMm = 0.5;
        bench.want.pushForceN = newtons;
        bench.run(500);
        QCOMPARE(bench.force(), 0.0);
        bench.want.pushing = true;
        const double most = bench.run(600);
        QVERIFY2(most < 1.6 * newtons, qPrintable(QString::number(most)));
        bench.run(400);
        double sum = 0.0;
        for (int n = 0; n < 1000; ++n) {
            bench.run(1);
            sum += bench.force();
            QVERIFY2(std::abs(bench.force() - newtons) < 0.05 * newtons, qPrintable(QString::number(bench.force())));
        }
        QVERIFY2(std::abs(sum / 1000.0 - newtons) < 0.01 * newtons, qPrintable(QString::number(sum / 1000.0)));
        QCOMPARE(bench.servo->state().removedMm3[1] > 0.0, drill);
    }

    void releasingLifts()
    {
        Bench bench({});
        bench.want.hoverMm = 0.8;
        bench.want.pushing = true;
        bench.run(800);
        QVERIFY(bench.force() > 0.5);
        bench.want.pushing = false;
        bench.run(300);
        QCOMPARE(bench.force(), 0.0);
        QVERIFY(std::abs(bench.tipMm.z - 0.8F) < 0.05F);
    }

    void glidesOverACusp()
    {
        support::Block block;
        block.topMm = [](double x, double y) { return 1.5 * std::exp(-(x * x + y * y) / 0.8); };
        Bench bench(block);
        bench.want.targetMm = {-3.0, 0.0};
        bench.want.hoverMm = 1.0;
        bench.run(500);
        bench.want.pushing = true;
        bench.run(600);
        double most = 0.0;
        for (int n = 0; n <= 3000; ++n) {
            bench.want.targetMm.x = -3.0 + 0.002 * n;
            most = std::max(most, bench.run(1));
        }
        most = std::max(most, bench.run(500));
        QVERIFY2(most < 2.0 * bench.want.pushForceN, qPrintable(QString::number(most)));
        QVERIFY2(bench.servo->state().anchorMm.x > 2.5, qPrintable(QString::number(bench.servo->state().anchorMm.x)));
    }

    void jumpWhileLeaningIsDragged()
    {
        Bench bench({});
        bench.want.targetMm = {-4.0, 0.0};
        bench.run(500);
        bench.want.pushing = true;
        bench.run(600);
        bench.want.targetMm.x = 4.0;
        float before = bench.tipMm.x;
        for (int n = 0; n < 1000; ++n) {
            bench.run(1);
            QVERIFY2(bench.tipMm.x - before <= 0.0401F, qPrintable(QString::number(bench.tipMm.x - before)));
            before = bench.tipMm.x;
        }
        QVERIFY2(bench.tipMm.x > 3.5F, qPrintable(QString::number(bench.tipMm.x)));
    }

    void idleHandDoesNotDrift()
    {
        Bench bench({});
        bench.want.targetMm = {1.25, -0.75};
        bench.run(1000);
        const glm::vec3 at = bench.tipMm;
        bench.run(20000);
        QVERIFY(glm::length(bench.tipMm - at) < 1.0e-5F);
        // It does not move either while it presses without drilling.
        bench.want.pushing = true;
        bench.run(2000);
        const glm::vec3 leaning = bench.tipMm;
        bench.run(20000);
        QVERIFY(glm::length(bench.tipMm - leaning) < 1.0e-3F);
    }

    void besideTheToothTheHandpieceStopsIt()
    {
        Bench bench({});
        bench.want.targetMm = {9.0, 9.0};
        bench.run(500);
        bench.want.pushing = true;
        bench.run(5000);
        // The top of the block is at 0: the bur goes in as far as it sticks out of its chuck, and the hand continues to
        // press.
        QCOMPARE(bench.servo->state().anchorMm.z, -core::bur::kChuckMm);
        const float resting = bench.tipMm.z;
        bench.run(1000);
        QVERIFY(std::abs(bench.tipMm.z - resting) < 1.0e-3F);
        QVERIFY(std::abs(bench.force() - bench.want.pushForceN) < 0.02);
        QVERIFY(bench.servo->state().handpieceOnCrown);
        bench.want.pushing = false;
        bench.run(2000);
        QVERIFY(!bench.servo->state().handpieceOnCrown);
    }

    void theFeedIsTheSameInEveryTissue_data()
    {
        support::columns<double, double, double>("dejMm", "cariesFloorMm", "feed");
        for (const double feed : {0.1, 0.5, 1.0}) {
            if (feed < 1.0)  // with 1 mm/s no force makes the bur follow in enamel
                QTest::addRow("enamel, %g mm/s", feed) << -100.0 << 100.0 << feed;
            QTest::addRow("dentin, %g mm/s", feed) << 10.0 << 100.0 << feed;
            QTest::addRow("decay, %g mm/s", feed) << -100.0 << -100.0 << feed;
        }
    }

    void theFeedIsTheSameInEveryTissue()
    {
        QFETCH(double, dejMm);
        QFETCH(double, cariesFloorMm);
        QFETCH(double, feed);
        support::Block block;
        block.bottomMm = -13.0;
        block.dejMm = dejMm;
        block.cariesFloorMm = cariesFloorMm;
        Bench bench(block, true);
        bench.want.feedMmPerS = feed;
        bench.want.pushForceN = 3.0;
        bench.want.hoverMm = 0.5;
        bench.run(200);
        bench.want.pushing = true;
        while (!bench.servo->state().cutting)
            bench.run(1);
        double before = bench.servo->state().anchorMm.z;
        const double begin = before;
        for (int n = 0; n < 20; ++n) {
            bench.run(100);
            const double fell = before - bench.servo->state().anchorMm.z;
            QVERIFY2(fell < 0.12 * feed + 0.005, qPrintable(QString::number(fell)));
            before = bench.servo->state().anchorMm.z;
        }
        QVERIFY2(std::abs(begin - before - 2.0 * feed) < 0.05 * feed + 0.02,
                 qPrintable(QString::number(begin - before)));
    }

    void aFeedBeyondTheBursPaceWaitsForTheBur()
    {
        Bench bench({.bottomMm = -13.0}, true);
        bench.want.targetMm = {0.013, 0.021};  // between nodes, so that the columns add up to the area of the bur
        bench.want.feedMmPerS = 1.0;
        bench.want.pushForceN = 3.0;
        bench.want.hoverMm = 0.5;
        bench.run(200);
        bench.want.pushing = true;
        bench.run(1500);
        const double before = bench.servo->state().anchorMm.z;
        bench.run(1000);
        const core::settings::HardnessPreset preset;
        const double pace = core::cutting::feedMmPerS(preset, preset.material[1], core::settings::Handpiece{},
                                                      core::bur::burs()[1], 3.0);
        const double sunk = before - bench.servo->state().anchorMm.z;
        QVERIFY2(std::abs(sunk / pace - 1.0) < 0.05,
                 qPrintable(QString("%1 mm, %2 mm/s, %3 N").arg(sunk).arg(pace).arg(bench.force())));
        QVERIFY(bench.force() > 2.5);
    }

    void aHandWithAFeedPressesNoHarderThanAsked()
    {
        Bench bench({});
        bench.want.feedMmPerS = 0.5;
        bench.want.pushForceN = 0.8;
        bench.want.pushing = true;
        const double most = bench.run(3000);
        QVERIFY2(most < 1.25 * 0.8, qPrintable(QString::number(most)));
        QVERIFY(std::abs(bench.force() - 0.8) < 0.05);
    }

    void theForceOfAHandWithAFeedNeverJumps_data()
    {
        support::columns<double, bool>("stepMm", "drill");
        QTest::newRow("over an edge") << -0.25 << false;
        QTest::newRow("against a step") << 0.25 << false;
        QTest::newRow("over an edge, drilling") << -0.25 << true;
        QTest::newRow("against a step, drilling") << 0.25 << true;
    }

    void theForceOfAHandWithAFeedNeverJumps()
    {
        QFETCH(double, stepMm);
        QFETCH(bool, drill);
        support::Block block;
        block.bottomMm = -13.0;
        block.topMm = [=](double x, double) { return x < 0.0 ? 0.0 : stepMm; };
        Bench bench(block, drill);
        bench.want.feedMmPerS = 0.5;
        bench.want.pushForceN = 0.6;
        bench.want.targetMm = {-0.6, 0.0};
        bench.run(200);
        bench.want.pushing = true;
        double most = bench.run(1500);
        for (int n = 0; n < 600; ++n) {
            bench.want.targetMm.x += 0.002;
            most = std::max(most, bench.run(1));
        }
        // The hand leaves the cavity while the pointer moves on.
        bench.want.pushing = false;
        for (int n = 0; n < 300; ++n) {
            bench.want.targetMm.x += 0.01;
            most = std::max(most, bench.run(1));
        }
        QVERIFY2(most < 2.0 * 0.6, qPrintable(QString::number(most)));
        QCOMPARE(bench.force(), 0.0);
    }

    void theStopMakesAFlatFloor_data()
    {
        support::columns<double, double, double>("wave", "slope", "beyondMm");
        QTest::newRow("waves") << 0.15 << 0.0 << 0.005;
        QTest::newRow("slope up") << 0.0 << 0.5 << 0.005;
        QTest::newRow("slope down") << 0.0 << -0.5 << 0.01;
    }

    void theStopMakesAFlatFloor()
    {
        QFETCH(double, wave);
        QFETCH(double, slope);
        QFETCH(double, beyondMm);
        support::Block block;
        block.bottomMm = -13.0;
        block.topMm = [=](double x, double) { return wave * std::sin(2.0 * x) + slope * (x + 1.0); };
        Bench bench(block, true);
        bench.want.feedMmPerS = 1.0;
        bench.want.pushForceN = 1.5;
        bench.want.stopMm = -1.2;
        bench.want.targetMm = {-1.0, 0.0};
        bench.want.pushing = true;
        bench.run(3000);
        QVERIFY2(std::abs(bench.servo->state().anchorMm.z + 1.2) < 0.01,
                 qPrintable(QString::number(bench.servo->state().anchorMm.z)));
        double lowest = 0.0;
        for (int n = 0; n < 24000; ++n) {
            bench.want.targetMm.x = -1.0 + 2.0 * (n < 12000 ? n : 24000 - n) / 12000.0;
            bench.run(1);
            lowest = std::min(lowest, bench.servo->state().anchorMm.z);
        }
        QVERIFY2(lowest > -1.2 - beyondMm, qPrintable(QString::number(lowest)));
        const terrain::Tooth& tooth = bench.tooth->tooth();
        for (double x = -0.9; x < 0.91; x += 0.1) {
            const glm::dvec2 at = tooth.grid().latticeOf({x, 0.0});
            const float top =
                tooth.top[tooth.grid().index(static_cast<int>(std::lround(at.x)), static_cast<int>(std::lround(at.y)))];
            QVERIFY2(std::abs(top + 1.2F) < 0.05F, qPrintable(QStringLiteral("%1 at %2").arg(top).arg(x)));
        }
    }

    void theButtonIsThePedal()
    {
        Bench bench({}, true);
        bench.run(10);
        QVERIFY(!bench.pedal);
        bench.want.buttonIsPedal = true;
        bench.want.hoverMm = 0.5;
        bench.want.feedMmPerS = 0.5;
        bench.run(200);
        QVERIFY(bench.pedal && !*bench.pedal);
        bench.want.pushing = true;
        bench.run(400);
        QVERIFY(*bench.pedal);
        bench.want.pushing = false;
        bench.run(10);
        QVERIFY(!*bench.pedal);
        // Holding the button beside the tooth does not start the bur in the air.
        bench.want.targetMm = {20.0, 20.0};
        bench.run(500);
        bench.want.pushing = true;
        bench.run(100);
        QVERIFY(*bench.pedal);
        bench.run(300);
        QVERIFY(!*bench.pedal);
    }

    void aFreeHandWithAFeedFollowsAtOnce()
    {
        Bench bench({});
        bench.want.feedMmPerS = 0.5;
        bench.want.hoverMm = 1.0;
        bench.run(500);
        bench.want.targetMm = {0.3, -0.2};
        bench.run(2);
        QVERIFY(glm::length(glm::vec2(bench.tipMm) - glm::vec2(0.3F, -0.2F)) < 1.0e-4F);
    }

    void aWishThatIsNoNumberIsPassedOver()
    {
        const double nan = std::nan("");
        Bench bench({});
        bench.want.targetMm = {1.0, 0.5};
        bench.want.pushing = true;
        bench.run(1000);
        const core::servo::PointerInput sound = bench.want;
        const auto bad = [&](auto&& spoil) {
            bench.want = sound;
            spoil(bench.want);
            bench.run(50);
            QVERIFY(std::abs(bench.tipMm.x - 1.0F) < 0.01F && std::isfinite(bench.tipMm.y) &&
                    std::isfinite(bench.tipMm.z));
        };
        bad([&](auto& want) { want.targetMm.x = nan; });
        bad([&](auto& want) { want.targetMm.y = nan; });
        bad([&](auto& want) { want.hoverMm = nan; });
        bad([&](auto& want) { want.pushForceN = nan; });
        bench.want = sound;
        bench.want.targetMm.x = -1.0;
        bench.run(1000);
        QVERIFY(std::abs(bench.tipMm.x + 1.0F) < 0.05F);
    }
};

CUSP_TEST(TestPointerDevice)
#include "tst_pointer_device.moc"
