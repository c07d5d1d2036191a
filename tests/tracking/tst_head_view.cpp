// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <algorithm>
#include <cmath>

#include <glm/vec3.hpp>

#include "core/tracking/HeadView.h"
#include "tests/support/Suite.h"

using namespace core::tracking;

namespace {

constexpr double kFrame60S = 1.0 / 60.0;
const glm::dvec3 kMiddle{0.0, 0.0, 600.0};

/// A view, and a head in front of it, frame by frame.
struct Watcher
{
    HeadView view;
    double nowS = 10.0;
    double mostStepDeg = 0.0;

    /// @param place  position of the head; null: the tag is not seen
    void watch(const glm::dvec3* place, double seconds, bool holds = false)
    {
        for (const double until = nowS + seconds; nowS < until;) {
            nowS += kFrame60S;
            if (place != nullptr) {
                m_head.isSeen = true;
                m_head.seenS = nowS;
                m_head.pose.positionMm = *place;
            } else {
                m_head.isSeen = false;
            }
            const Lean before = view.lean();
            const Lean& lean = view.update(m_head, nowS, kFrame60S, holds);
            mostStepDeg = std::max(
                {mostStepDeg, std::abs(lean.yawDeg - before.yawDeg), std::abs(lean.pitchDeg - before.pitchDeg)});
        }
    }

private:
    Head m_head;
};

}  // namespace

class TestHeadView : public QObject
{
    Q_OBJECT
private slots:
    void theFirstPlaceIsTheMiddle()
    {
        Watcher watcher;
        const glm::dvec3 place{50.0, 20.0, 500.0};
        watcher.watch(&place, 2.0);
        QVERIFY(watcher.view.isAtRest());
    }

    /// The camera faces the user, so the user's right is the camera's left; up is -y.
    void theEyeGoesWithTheHead_data()
    {
        QTest::addColumn<double>("x");
        QTest::addColumn<double>("y");
        QTest::addColumn<int>("yaw");
        QTest::addColumn<int>("pitch");
        QTest::newRow("to the user's right") << -100.0 << 0.0 << 1 << 0;
        QTest::newRow("to the user's left") << 100.0 << 0.0 << -1 << 0;
        QTest::newRow("up") << 0.0 << -100.0 << 0 << 1;
        QTest::newRow("down") << 0.0 << 100.0 << 0 << -1;
    }
    void theEyeGoesWithTheHead()
    {
        QFETCH(double, x);
        QFETCH(double, y);
        QFETCH(int, yaw);
        QFETCH(int, pitch);
        Watcher watcher;
        watcher.watch(&kMiddle, 1.0);
        const glm::dvec3 place = kMiddle + glm::dvec3(x, y, 0.0);
        watcher.watch(&place, 2.0);
        const Lean& lean = watcher.view.lean();
        // 100 mm at 600 mm is 9.46 degrees, doubled, less the dead zone.
        const double turnedDeg = 2.0 * (9.46 - 0.3);
        QVERIFY(std::abs(lean.yawDeg - yaw * turnedDeg) < 0.1);
        QVERIFY(std::abs(lean.pitchDeg - pitch * turnedDeg) < 0.1);
    }

    void farAwayTheToothIsSmaller()
    {
        Watcher watcher;
        watcher.watch(&kMiddle, 1.0);
        const glm::dvec3 nearer{0.0, 0.0, 450.0};
        watcher.watch(&nearer, 2.0);
        QVERIFY(watcher.view.lean().farther < 0.9);
        const glm::dvec3 farther{0.0, 0.0, 800.0};
        watcher.watch(&farther, 3.0);
        QVERIFY(watcher.view.lean().farther > 1.1);
    }

    void recentreMakesAnotherMiddle()
    {
        Watcher watcher;
        watcher.watch(&kMiddle, 1.0);
        const glm::dvec3 place{80.0, 0.0, 600.0};
        watcher.watch(&place, 2.0);
        QVERIFY(!watcher.view.isAtRest());
        watcher.view.recentre();
        watcher.watch(&place, 3.0);
        QVERIFY(watcher.view.isAtRest());
    }

    void neverTurnsByMoreThanADegreeAFrame()
    {
        Watcher watcher;
        watcher.watch(&kMiddle, 1.0);
        for (const double x : {200.0, -200.0, 60.0}) {
            const glm::dvec3 place = kMiddle + glm::dvec3(x, 0.5 * x, 0.0);
            watcher.watch(&place, 0.5);
            watcher.watch(nullptr, x < 0.0 ? 3.0 : 0.3);
        }
        QVERIFY(watcher.mostStepDeg > 0.5);
        QVERIFY(watcher.mostStepDeg <= HeadView::kMostDegPerFrame + 1e-9);
    }

    void withoutATagItHoldsAndGlidesBack()
    {
        Watcher watcher;
        watcher.watch(&kMiddle, 1.0);
        const glm::dvec3 place{-100.0, 0.0, 600.0};
        watcher.watch(&place, 2.0);
        const Lean held = watcher.view.lean();
        watcher.watch(nullptr, 0.8);
        QVERIFY(watcher.view.lean() == held);
        watcher.watch(nullptr, 4.0);
        QVERIFY(watcher.view.isAtRest());
        watcher.mostStepDeg = 0.0;
        watcher.watch(&place, 0.1);
        QVERIFY(watcher.view.lean().yawDeg > 0.0);
        QVERIFY(watcher.view.lean().yawDeg < 0.7 * held.yawDeg);
        watcher.watch(&place, 2.0);
        QVERIFY(std::abs(watcher.view.lean().yawDeg - held.yawDeg) < 0.1);
    }

    void aLostTagMovesNothingWhileTheBurTouches()
    {
        Watcher watcher;
        watcher.watch(&kMiddle, 1.0);
        const glm::dvec3 place{-100.0, 0.0, 600.0};
        watcher.watch(&place, 2.0);
        const Lean held = watcher.view.lean();
        watcher.watch(nullptr, 5.0, true);
        QVERIFY(watcher.view.lean() == held);
        watcher.watch(nullptr, 5.0, false);
        QVERIFY(watcher.view.isAtRest());
    }
};

CUSP_TEST(TestHeadView)
#include "tst_head_view.moc"
