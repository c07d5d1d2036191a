// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <cmath>
#include <numbers>
#include <optional>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "core/tracking/HeadFilter.h"
#include "tests/support/Suite.h"

using namespace core::tracking;

namespace {

constexpr double kFrameS = 1.0 / 30.0;
const glm::dvec3 kPlace{20.0, -30.0, 600.0};

glm::dmat3 nodded(double deg)
{
    return glm::dmat3(glm::rotate(glm::dmat4(1.0), glm::radians(deg), glm::dvec3(1.0, 0.0, 0.0)));
}

PosedTag at(const glm::dvec3& positionMm, double tiltDeg = 20.0)
{
    PosedTag tag;
    tag.pose = {positionMm, nodded(tiltDeg)};
    tag.other = {positionMm, nodded(-tiltDeg)};
    tag.reprojectionPx = 0.05;
    tag.otherPx = 0.5;
    return tag;
}

/// Takes the same picture again and again, from a time on.
double rest(HeadFilter& filter, const std::optional<PosedTag>& tag, int frames, double fromS)
{
    for (int n = 0; n < frames; ++n)
        filter.take(tag, fromS += kFrameS);
    return fromS;
}

}  // namespace

class TestHeadFilter : public QObject
{
    Q_OBJECT
private slots:
    void aTagCountsFromItsSecondPictureOn()
    {
        HeadFilter filter;
        QVERIFY(!filter.take(at(kPlace), 1.0).isSeen);
        QCOMPARE(filter.head().seenS, 0.0);
        const Head& head = filter.take(at(kPlace), 1.0 + kFrameS);
        QVERIFY(head.isSeen);
        QVERIFY(glm::distance(head.pose.positionMm, kPlace) < 1e-9);
    }

    void twoTagsFarApartAreNotTheSame()
    {
        HeadFilter filter;
        filter.take(at(kPlace), 1.0);
        QVERIFY(!filter.take(at(kPlace + glm::dvec3(200.0, 0.0, 0.0)), 1.0 + kFrameS).isSeen);
    }

    void aSingleJumpIsNotBelieved()
    {
        HeadFilter filter;
        double time = rest(filter, at(kPlace), 10, 1.0);
        const glm::dvec3 far = kPlace + glm::dvec3(400.0, 0.0, 0.0);
        QVERIFY(!filter.take(at(far), time += kFrameS).isSeen);
        QVERIFY(glm::distance(filter.head().pose.positionMm, kPlace) < 1e-6);
        QVERIFY(filter.take(at(kPlace), time += kFrameS).isSeen);
        // But one that lasts is.
        time = rest(filter, at(far), 3, time);
        QVERIFY(filter.head().isSeen);
        QVERIFY(glm::distance(filter.head().pose.positionMm, far) < 1e-6);
    }

    void aTagThatIsLostIsFoundAnew()
    {
        HeadFilter filter;
        double time = rest(filter, at(kPlace), 10, 1.0);
        const double seen = filter.head().seenS;
        time = rest(filter, std::nullopt, 30, time);
        QVERIFY(!filter.head().isSeen);
        QCOMPARE(filter.head().seenS, seen);
        QVERIFY(!filter.take(at(kPlace), time += kFrameS).isSeen);
        QVERIFY(filter.take(at(kPlace), time += kFrameS).isSeen);
    }

    /// Seen almost straight on, noise decides which of the two poses has the smaller error.
    void theOrientationDoesNotFlip()
    {
        HeadFilter filter;
        double time = rest(filter, at(kPlace, 10.0), 10, 1.0);
        for (int n = 0; n < 30; ++n) {
            PosedTag tag = at(kPlace, 10.0);
            if (n % 2 == 0)
                std::swap(tag.pose, tag.other);
            tag.otherPx = 0.06;
            const Head& head = filter.take(tag, time += kFrameS);
            QVERIFY(head.isSeen);
            QVERIFY(angleBetweenDeg(head.raw.rotation, nodded(10.0)) < 1e-6);
        }
    }

    /// Unless the other pose explains the pictures clearly better for some time: then the first choice was wrong.
    void aWrongChoiceIsRevised()
    {
        HeadFilter filter;
        const double time = rest(filter, at(kPlace, 20.0), 10, 1.0);
        rest(filter, at(kPlace, -20.0), 20, time);
        QVERIFY(angleBetweenDeg(filter.head().raw.rotation, nodded(-20.0)) < 1e-6);
    }

    void atRestItIsCalmAndInMotionItIsPrompt_data()
    {
        QTest::addColumn<double>("hz");
        QTest::newRow("30 Hz") << 30.0;
        QTest::newRow("60 Hz") << 60.0;
    }
    void atRestItIsCalmAndInMotionItIsPrompt()
    {
        QFETCH(double, hz);
        HeadFilter filter;
        double time = 1.0;
        // Sideways noise as of a tag at 60 cm, in a fixed pattern.
        double sum = 0.0;
        int count = 0;
        for (int n = 0; n < 300; ++n) {
            const double noise = 0.08 * std::sin(n * 12.9898) * std::numbers::sqrt2;
            const Head& head = filter.take(at(kPlace + glm::dvec3(noise, 0.0, 0.0)), time += 1.0 / hz);
            if (n > 100) {
                sum += (head.pose.positionMm.x - kPlace.x) * (head.pose.positionMm.x - kPlace.x);
                ++count;
            }
        }
        const double jitterMm = std::sqrt(sum / count);
        constexpr double kMmPerS = 200.0;
        double x = kPlace.x;
        for (int n = 0; n < 60; ++n)
            filter.take(at({x += kMmPerS / hz, kPlace.y, kPlace.z}), time += 1.0 / hz);
        const double lagS = (x - filter.head().pose.positionMm.x) / kMmPerS;
        qInfo("jitter %.3f mm of 0.08 mm, lag %.1f ms", jitterMm, 1000.0 * lagS);
        QVERIFY(jitterMm < 0.05);
        QVERIFY(lagS < 0.020);
    }

    void aheadIsAtMostThirtyMilliseconds()
    {
        Head head;
        head.seenS = 5.0;
        head.mmPerS = {100.0, 0.0, 0.0};
        QCOMPARE(head.positionAtMm(4.9).x, 0.0);
        QCOMPARE(head.positionAtMm(5.02).x, 2.0);
        QCOMPARE(head.positionAtMm(6.0).x, 3.0);
    }
};

CUSP_TEST(TestHeadFilter)
#include "tst_head_filter.moc"
