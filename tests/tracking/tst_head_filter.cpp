// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include <glm/geometric.hpp>

#include "core/tracking/HeadFilter.h"
#include "core/tracking/TagTracker.h"
#include "tests/support/Suite.h"
#include "tests/support/Tables.h"
#include "tests/tracking/TagSpread.h"

using namespace core::tracking;

namespace {

constexpr double kBeginsS = 1.0;

/// Returns a tag at rest, as detected in pictures that differ only by their noise.
std::vector<PosedTag> tagAtRest(double distanceMm, int pictures)
{
    lab::TagScene scene;
    scene.camera = support::usualCamera();
    scene.tag = support::tagBefore(distanceMm, {0.05, -0.05}, 20.0, 60.0, 4.0);
    TagTracker tracker({});
    std::vector<PosedTag> tags;
    for (int n = 0; n < pictures; ++n) {
        scene.grain = static_cast<std::uint64_t>(n + 1);
        const TagFrame frame = tracker.look(lab::render(scene).view()).value();
        tags.insert(tags.end(), frame.tags.begin(), frame.tags.end());
    }
    return tags;
}

void move(PosedTag& tag, const glm::dvec3& mm)
{
    tag.pose.positionMm += mm;
    tag.other.positionMm += mm;
}

PosedTag exactTag(const Pose& pose)
{
    PosedTag tag;
    tag.pose = tag.other = pose;
    return tag;
}

}  // namespace

class TestHeadFilter : public QObject
{
    Q_OBJECT
private slots:
    void isCalmAtRestAndQuickInMotion_data() { support::rows<double>("hz", {30.0, 60.0}); }

    void isCalmAtRestAndQuickInMotion()
    {
        QFETCH(double, hz);
        const std::vector<PosedTag> tags = tagAtRest(600.0, 150);
        QCOMPARE(tags.size(), std::size_t{150});
        HeadFilter rest;
        std::vector<Pose> poses;
        for (std::size_t n = 0; n < tags.size(); ++n) {
            const Head& head = rest.take(tags[n], kBeginsS + static_cast<double>(n) / hz);
            if (n >= 30)
                poses.push_back(head.pose);
        }
        glm::dvec3 mean(0.0);
        for (const Pose& pose : poses)
            mean += pose.positionMm / static_cast<double>(poses.size());
        double mm2 = 0.0;
        double deg2 = 0.0;
        for (const Pose& pose : poses) {
            const glm::dvec3 apart = pose.positionMm - mean;
            const double deg = angleBetweenDeg(poses.front().rotation, pose.rotation);
            mm2 += glm::dot(apart, apart) / static_cast<double>(poses.size());
            // The difference of two poses is the square root of two times the difference of one from the mean.
            deg2 += 0.5 * deg * deg / static_cast<double>(poses.size());
        }
        QVERIFY(support::between(std::sqrt(mm2), 0.0, 0.05));
        QVERIFY(support::between(std::sqrt(deg2), 0.0, 0.05));

        constexpr double kMmPerS = 200.0;
        HeadFilter motion;
        for (int n = 0; n < static_cast<int>(1.5 * hz); ++n) {
            PosedTag tag = tags[static_cast<std::size_t>(n) % tags.size()];
            move(tag, {kMmPerS * n / hz, 0.0, 0.0});
            const Head& head = motion.take(tag, kBeginsS + n / hz);
            if (n > hz)
                QVERIFY(support::between((tag.pose.positionMm.x - head.pose.positionMm.x) / kMmPerS, 0.0, 0.020));
        }
    }

    /// The two possible poses of a tag seen nearly straight on swap at random.
    void keepsToOneOfTwoPoses()
    {
        const Pose one = lab::facing({0.0, 0.0, 600.0}, 0.0, 8.0, 0.0);
        const Pose two = lab::facing({0.0, 0.0, 600.0}, 0.0, -8.0, 0.0);
        HeadFilter filter;
        core::Rng rng(2);
        for (int n = 0; n < 200; ++n) {
            PosedTag tag;
            const bool isSwapped = n > 2 && rng.below(2) == 0;
            tag.pose = isSwapped ? two : one;
            tag.other = isSwapped ? one : two;
            tag.reprojectionPx = 0.04;
            tag.otherPx = 0.05;
            const Head& head = filter.take(tag, kBeginsS + n / 30.0);
            if (n > 2)
                QVERIFY(angleBetweenDeg(head.pose.rotation, one.rotation) < 0.01);
        }
        // The filter began with the wrong pose. Three clear pictures must be enough to correct it.
        for (int n = 0; n < 3; ++n) {
            PosedTag tag;
            tag.pose = two;
            tag.other = one;
            tag.reprojectionPx = 0.04;
            tag.otherPx = 0.2;
            QVERIFY(filter.take(tag, kBeginsS + (200 + n) / 30.0).isSeen);
        }
        QVERIFY(angleBetweenDeg(filter.head().pose.rotation, two.rotation) < 0.01);
    }

    /// If the filter had chosen the wrong pose, the correction must not count as a jump of the head.
    void mendingAPoseIsNoJump()
    {
        const Pose wrong = lab::facing({0.0, 0.0, 600.0}, -25.0, 0.0, 0.0);
        const Pose right = lab::facing({0.0, 0.0, 600.0}, 25.0, 0.0, 0.0);
        HeadFilter filter;
        filter.take(exactTag(wrong), kBeginsS);
        filter.take(exactTag(wrong), kBeginsS + 1 / 30.0);
        for (int n = 2; n < 6; ++n) {
            PosedTag tag;
            tag.pose = right;
            tag.other = wrong;
            tag.reprojectionPx = 0.05;
            tag.otherPx = 0.5;
            QVERIFY(filter.take(tag, kBeginsS + n / 30.0).isSeen);
        }
        QVERIFY(angleBetweenDeg(filter.head().pose.rotation, right.rotation) < 0.01);
    }

    void aSingleJumpMovesNothing()
    {
        HeadFilter filter;
        const Pose home = lab::facing({0.0, 0.0, 600.0}, 0.0, 20.0, 0.0);
        const Pose away = lab::facing({250.0, 0.0, 600.0}, 0.0, 20.0, 0.0);
        int n = 0;
        const auto take = [&](const Pose& pose) { return filter.take(exactTag(pose), kBeginsS + n++ / 30.0); };
        QVERIFY(!take(home).isSeen);
        QVERIFY(take(home).isSeen);
        QVERIFY(!take(away).isSeen);
        QVERIFY(take(home).isSeen);
        QCOMPARE(filter.head().pose.positionMm.x, 0.0);
        QVERIFY(!take(away).isSeen);
        QVERIFY(!take(away).isSeen);
        QVERIFY(take(away).isSeen);
        QCOMPARE(filter.head().pose.positionMm.x, 250.0);
    }

    void aLostTagIsSaidToBeLost()
    {
        HeadFilter filter;
        const Pose home = lab::facing({0.0, 0.0, 600.0}, 0.0, 20.0, 0.0);
        filter.take(exactTag(home), 1.0);
        filter.take(exactTag(home), 1.1);
        QVERIFY(!filter.take(std::nullopt, 1.2).isSeen);
        QVERIFY(support::near(filter.head().seenS, 1.1));
        QCOMPARE(filter.head().pose.positionMm.z, 600.0);
        QVERIFY(!filter.take(exactTag(home), 3.0).isSeen);
        QVERIFY(filter.take(exactTag(home), 3.1).isSeen);
    }

    void predictsNoFartherThanThirtyMilliseconds()
    {
        Head head;
        head.seenS = 2.0;
        head.mmPerS = {100.0, 0.0, 0.0};
        QVERIFY(support::near(head.positionAtMm(2.02).x, 2.0));
        QVERIFY(support::near(head.positionAtMm(3.0).x, 3.0));
        QVERIFY(support::near(head.positionAtMm(1.0).x, 0.0));
    }

    void aTagThatIsLostIsFoundAnew()
    {
        HeadFilter filter;
        const PosedTag tag = exactTag(lab::facing({0.0, 0.0, 600.0}, 0.0, 20.0, 0.0));
        double timeS = kBeginsS;
        filter.take(tag, timeS);
        filter.take(tag, timeS += 1 / 30.0);
        const double seenS = filter.head().seenS;
        for (int n = 0; n < 30; ++n)
            filter.take(std::nullopt, timeS += 1 / 30.0);
        QVERIFY(!filter.head().isSeen);
        QCOMPARE(filter.head().seenS, seenS);
        QVERIFY(!filter.take(tag, timeS += 1 / 30.0).isSeen);
        QVERIFY(filter.take(tag, timeS += 1 / 30.0).isSeen);
    }

    void isAheadByThirtyMillisecondsAtMost()
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
