// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/rt/TripleBuffer.h"
#include "core/servo/ServoState.h"
#include "core/servo/ServoTick.h"
#include "haptics/simulated/GuidedFalcon.h"
#include "tests/support/Suite.h"
#include "tests/support/SyntheticTooth.h"

using namespace core;
using namespace std::chrono_literals;

namespace {

/// A simulated handpiece over a block of enamel.
struct GuidedFalcon
{
    rt::TripleBuffer<core::servo::PointerInput> input;
    std::unique_ptr<contact::LiveTooth> tooth =
        std::make_unique<contact::LiveTooth>(terrain::Tooth(support::makeBlock({})));
    std::unique_ptr<core::servo::ServoTick> servo = core::servo::makeServoTick({}).value();
    haptics::GuidedFalcon device{input, contact::ForceSettings{}.stiffnessNPerMm, 0.001};
    core::servo::PointerInput want;

    GuidedFalcon() { servo->swapTooth(tooth.get(), true); }
    glm::vec3 tick()
    {
        input.publish(want);
        const glm::vec3 tip = device.exchange(servo->state().forceN).tipInToothMm;
        servo->step(&tip, 1ms);
        return tip;
    }
};

}  // namespace

class TestGuidedFalcon : public QObject
{
    Q_OBJECT
private slots:
    void goesWhereItIsWanted()
    {
        GuidedFalcon bench;
        for (const glm::dvec2 target : {glm::dvec2(2.0, -1.0), glm::dvec2(-1.5, 0.5)}) {
            bench.want.targetMm = target;
            for (int n = 0; n < 3000; ++n)
                bench.tick();
            const glm::vec3 tip = bench.tick();
            QVERIFY2(glm::length(glm::dvec2(tip.x, tip.y) - target) < 0.3, qPrintable(QString::number(tip.x)));
        }
    }

    void leansAsHardAsItIsWanted()
    {
        GuidedFalcon bench;
        bench.want.hoverMm = 0.5;
        bench.want.pushing = true;
        for (int n = 0; n < 4000; ++n)
            bench.tick();
        double sum = 0.0;
        for (int n = 0; n < 2000; ++n) {
            bench.tick();
            sum += glm::length(bench.servo->state().forceN);
        }
        QVERIFY2(std::abs(sum / 2000.0 - bench.want.pushForceN) < 0.1, qPrintable(QString::number(sum / 2000.0)));
    }
};

CUSP_TEST(TestGuidedFalcon)
#include "tst_guided_falcon.moc"
