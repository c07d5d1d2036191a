// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include <glm/geometric.hpp>

#include "core/tracking/TagTracker.h"
#include "tests/support/Suite.h"
#include "tests/support/Trials.h"
#include "tests/tracking/TagSpread.h"

using namespace core::tracking;
using support::percentile;

namespace {

constexpr double kSmallestPx = 60.0;

struct PoseErrors
{
    int lost = 0;
    std::vector<double> positionMm;
    std::vector<double> lateralMm;
    std::vector<double> depthMm;
    std::vector<double> angleDeg;
};

/// Returns the errors of tags that are each in one picture, which is searched as a whole.
PoseErrors errorsOf(const CameraModel& camera, int count)
{
    TrackerSettings settings;
    settings.calibration = camera;
    PoseErrors errors;
    core::Rng rng(11);
    for (int n = 0; n < count;) {
        lab::TagScene scene;
        scene.camera = camera;
        const double tilt = rng.uniform(20.0, 50.0);
        scene.tag = support::tagSomewhere(rng, rng.uniform(300.0, 900.0), tilt);
        const double seenTilt = lab::tiltDeg(scene.tag->pose);
        if (lab::edgePxOf(*scene.tag, camera) < kSmallestPx || seenTilt < 20.0 || seenTilt > 50.0)
            continue;
        scene.clutter = scene.grain = static_cast<std::uint64_t>(++n);
        const auto frame = TagTracker(settings).look(lab::render(scene).view());
        if (!frame || frame->tags.size() != 1) {
            ++errors.lost;
            continue;
        }
        const Pose& pose = frame->tags.front().pose;
        const glm::dvec3 apart = pose.positionMm - scene.tag->pose.positionMm;
        errors.positionMm.push_back(glm::length(apart));
        errors.lateralMm.push_back(std::hypot(apart.x, apart.y));
        errors.depthMm.push_back(std::abs(apart.z));
        errors.angleDeg.push_back(angleBetweenDeg(pose.rotation, scene.tag->pose.rotation));
    }
    return errors;
}

}  // namespace

class TestTagPose : public QObject
{
    Q_OBJECT
private slots:
    void tiltedTagsAreFoundAndPlaced_data()
    {
        QTest::addColumn<double>("k1");
        QTest::newRow("no distortion") << 0.0;
        QTest::newRow("a lens that bends outwards") << -0.15;
    }

    void tiltedTagsAreFoundAndPlaced()
    {
        QFETCH(double, k1);
        CameraModel camera = support::usualCamera();
        camera.distortion[0] = k1;
        const PoseErrors errors = errorsOf(camera, support::trials(60, 600));
        QCOMPARE(errors.lost, 0);
        QVERIFY(support::between(percentile(errors.positionMm, 0.95), 0.0, 2.0));
        QVERIFY(support::between(percentile(errors.angleDeg, 0.95), 0.0, 1.0));
        QVERIFY(support::between(percentile(errors.lateralMm, 0.5), 0.0, 0.1));
        QVERIFY(support::between(percentile(errors.depthMm, 0.5), 0.0, 0.5));
        QVERIFY(support::between(percentile(errors.angleDeg, 0.5), 0.0, 0.3));
    }

    /// One of the two poses found is the true one, and their positions are close.
    void theTruePoseIsOneOfTwo()
    {
        core::Rng rng(5);
        for (int n = 0; n < support::trials(20, 200); ++n) {
            lab::TagScene scene;
            scene.camera = support::usualCamera();
            const double tilt = rng.uniform(0.0, 15.0);
            scene.tag = support::tagSomewhere(rng, rng.uniform(300.0, 600.0), tilt);
            scene.grain = static_cast<std::uint64_t>(n);
            const auto frame = TagTracker({}).look(lab::render(scene).view()).value();
            QCOMPARE(frame.tags.size(), std::size_t{1});
            const PosedTag& tag = frame.tags.front();
            QVERIFY(tag.reprojectionPx <= tag.otherPx);
            const auto angle = [&](const Pose& pose) {
                return angleBetweenDeg(pose.rotation, scene.tag->pose.rotation);
            };
            QVERIFY(support::between(std::min(angle(tag.pose), angle(tag.other)), 0.0, 5.0));
            QVERIFY(glm::distance(tag.pose.positionMm, tag.other.positionMm) < 5.0);
        }
    }

    void anExactSquareGivesItsPose()
    {
        CameraModel camera = support::usualCamera();
        camera.distortion = {-0.1, 0.02, 0.001, -0.002, 0.0};
        const lab::PrintedTag tag = support::tagBefore(500.0, {0.2, -0.1}, 30.0, 70.0, 15.0);
        SeenTag seen;
        seen.cornersPx = lab::cornersOf(tag, camera);
        const auto posed = poseOf(seen, camera, tag.edgeMm);
        QVERIFY(posed.has_value());
        QVERIFY(glm::distance(posed->pose.positionMm, tag.pose.positionMm) < 1.0e-3);
        QVERIFY(angleBetweenDeg(posed->pose.rotation, tag.pose.rotation) < 1.0e-3);
        QVERIFY(posed->reprojectionPx < 1.0e-4);
    }
};

CUSP_TEST(TestTagPose)
#include "tst_tag_pose.moc"
