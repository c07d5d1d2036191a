// SPDX-License-Identifier: GPL-3.0-or-later
#include <QFile>
#include <QFileInfo>
#include <QTest>
#include <algorithm>
#include <array>

#include <glm/geometric.hpp>

#include "core/tracking/PictureSource.h"
#include "core/tracking/TagTracker.h"
#include "tests/support/Suite.h"
#include "tests/support/Tables.h"
#include "tests/support/ToothMaps.h"
#include "tests/support/Trials.h"
#include "tests/tracking/TagSpread.h"

using namespace core::tracking;

namespace {

/// Moves a tag along its line of sight until its edges have a mean length.
void placeByEdge(lab::PrintedTag& tag, const CameraModel& camera, double edgePx)
{
    for (int n = 0; n < 8; ++n)
        tag.pose.positionMm *= lab::edgePxOf(tag, camera) / edgePx;
}

bool isWhollyIn(const lab::PrintedTag& tag, const CameraModel& camera, double marginPx)
{
    const auto corners = lab::cornersOf(tag, camera);
    return std::all_of(corners.begin(), corners.end(), [&](const glm::dvec2& corner) {
        return corner.x > marginPx && corner.y > marginPx && corner.x < camera.width - marginPx &&
               corner.y < camera.height - marginPx;
    });
}

struct Expected
{
    int id = 0;
    std::array<glm::dvec2, 4> corners{};
};

/// Returns the tags of the family 36h11 in a photograph, as found by AprilTag's own program.
std::vector<Expected> expectedOf(const QString& table, const QString& photograph)
{
    QFile file(table);
    std::vector<Expected> tags;
    if (!file.open(QIODevice::ReadOnly))
        return tags;
    for (const QByteArray& line : file.readAll().split('\n')) {
        const QList<QByteArray> fields = line.trimmed().split(',');
        if (fields.size() < 17 || fields[0] != photograph.toUtf8() || fields[1] != "tag36h11")
            continue;
        Expected tag;
        tag.id = fields[4].toInt();
        for (int n = 0; n < 4; ++n)
            tag.corners.at(static_cast<std::size_t>(n)) = {fields[9 + 2 * n].toDouble(), fields[10 + 2 * n].toDouble()};
        tags.push_back(tag);
    }
    return tags;
}

double farthestCorner(const SeenTag& tag, const std::array<glm::dvec2, 4>& corners)
{
    double farthest = 0.0;
    for (std::size_t n = 0; n < corners.size(); ++n)
        farthest = std::max(farthest, glm::distance(tag.cornersPx.at(n), corners.at(n)));
    return farthest;
}

}  // namespace

class TestTagSearch : public QObject
{
    Q_OBJECT
private slots:
    /// A tag is found within three pictures. If it is tilted by up to 50 degrees its edges are short, and it is found
    /// within nine, of which one is searched at full resolution.
    void smallTagsAreFound_data()
    {
        support::rows<double, double>("edgePx", {24.0, 30.0, 40.0, 52.0}, "mostTiltDeg", {0.0, 30.0, 50.0});
    }

    void smallTagsAreFound()
    {
        QFETCH(double, edgePx);
        QFETCH(double, mostTiltDeg);
        const int mostPictures = mostTiltDeg > 30.0 ? 9 : 3;
        core::Rng rng(3);
        for (int n = 0; n < support::trials(12, 200); ++n) {
            lab::TagScene scene;
            scene.camera = support::usualCamera();
            const double tilt = rng.uniform(0.0, mostTiltDeg);
            scene.tag = support::tagSomewhere(rng, 1000.0, tilt);
            placeByEdge(*scene.tag, scene.camera, edgePx);
            scene.clutter = static_cast<std::uint64_t>(n);
            TagTracker tracker({});
            int pictures = 0;
            bool isFound = false;
            while (!isFound && pictures < mostPictures) {
                scene.grain = static_cast<std::uint64_t>(100 * n + ++pictures);
                isFound = !tracker.look(lab::render(scene).view()).value().tags.empty();
            }
            QVERIFY2(isFound, qPrintable(QString("scene %1, tilted by %2").arg(n).arg(tilt)));
        }
    }

    /// Wherever a search region begins and ends, the corners are those of the whole picture.
    void regionsDoNotMoveCorners_data() { support::rows<int>("decimation", {1, 2, 3, 4}); }

    void regionsDoNotMoveCorners()
    {
        QFETCH(int, decimation);
        TagDetector detector(0);
        core::Rng rng(8);
        glm::dvec2 mean(0.0);
        double outwards = 0.0;
        double regions = 0.0;
        const int scenes = support::trials(8, 60);
        for (int n = 0; n < scenes; ++n) {
            lab::TagScene scene;
            scene.camera = support::usualCamera();
            scene.tag = support::tagSomewhere(rng, rng.uniform(300.0, 550.0), 20.0);
            scene.clutter = scene.grain = static_cast<std::uint64_t>(n + 1);
            const Picture picture = lab::render(scene);
            const auto truth = lab::cornersOf(*scene.tag, scene.camera);
            const glm::dvec2 centre = 0.25 * (truth[0] + truth[1] + truth[2] + truth[3]);
            const int half = static_cast<int>(1.5 * lab::edgePxOf(*scene.tag, scene.camera));
            for (int shift = 0; shift < 8; ++shift) {
                const TagDetector::Region region{static_cast<int>(centre.x) - half + shift,
                                                 static_cast<int>(centre.y) - half + 3 * shift, 2 * half, 2 * half};
                const auto tags = detector.find(picture.view(), region, {decimation, true});
                QCOMPARE(tags.size(), std::size_t{1});
                QVERIFY(support::between(farthestCorner(tags.front(), truth), 0.0, 0.5));
                ++regions;
                for (std::size_t k = 0; k < truth.size(); ++k) {
                    const glm::dvec2 apart = tags.front().cornersPx.at(k) - truth.at(k);
                    mean += 0.25 * apart;
                    outwards += 0.25 * glm::dot(apart, glm::normalize(truth.at(k) - centre));
                }
            }
        }
        QVERIFY(support::near(mean.x / regions, 0.0, 0.03));
        QVERIFY(support::near(mean.y / regions, 0.0, 0.03));
        QVERIFY(support::near(outwards / regions, 0.0, 0.03));
    }

    /// A tag moves out of the picture to the left and returns.
    void aTagAtTheBorderIsLostAndFoundAgain()
    {
        lab::TagScene scene;
        scene.camera = support::usualCamera();
        TagTracker tracker({});
        int whole = 0;
        int cut = 0;
        int missed = 0;
        for (int n = 0; n <= 40; ++n) {
            const double share = -0.46 - 0.2 * std::sin(n * support::kPi / 40.0);
            scene.tag = support::tagBefore(500.0, {share, 0.05}, 20.0, 90.0, 5.0);
            scene.grain = static_cast<std::uint64_t>(n);
            const auto frame = tracker.look(lab::render(scene).view()).value();
            if (!isWhollyIn(*scene.tag, scene.camera, 0.0)) {
                ++cut;
                missed = 0;
                QVERIFY2(frame.tags.empty(), qPrintable(QString("picture %1").arg(n)));
            } else if (isWhollyIn(*scene.tag, scene.camera, 20.0)) {
                ++whole;
                missed = frame.tags.empty() ? missed + 1 : 0;
                QVERIFY2(missed < 3, qPrintable(QString("picture %1").arg(n)));
            }
            for (const PosedTag& tag : frame.tags)
                QVERIFY(glm::distance(tag.pose.positionMm, scene.tag->pose.positionMm) < 3.0);
        }
        QVERIFY(cut > 5 && whole > 5);
        QCOMPARE(missed, 0);
    }

    void aMovingTagIsFollowed_data()
    {
        support::columns<double, double>("mmPerS", "mostMm");
        QTest::newRow("at rest") << 0.0 << 2.0;
        QTest::newRow("six pixels of blur") << 200.0 << 2.0;
        QTest::newRow("twelve pixels of blur") << 400.0 << 10.0;
    }

    /// 30 pictures a second with an exposure of a 60th of a second. Blur affects the depth more than the position in
    /// the picture.
    void aMovingTagIsFollowed()
    {
        QFETCH(double, mmPerS);
        QFETCH(double, mostMm);
        lab::TagScene scene;
        scene.camera = support::usualCamera();
        TagTracker tracker({});
        for (int n = 0; n < 15; ++n) {
            const double xMm = mmPerS * (n - 7) / 30.0;
            scene.tag = support::tagBefore(600.0, {xMm / 600.0, 0.02}, 20.0, 90.0, 3.0);
            scene.motionPx = {mmPerS / 60.0 / 600.0 * scene.camera.focalPx.x, 0.0};
            scene.grain = static_cast<std::uint64_t>(n);
            const auto frame = tracker.look(lab::render(scene).view()).value();
            QCOMPARE(frame.tags.size(), std::size_t{1});
            QCOMPARE(frame.isWhole, n == 0);
            const glm::dvec3 apart = frame.tags.front().pose.positionMm - scene.tag->pose.positionMm;
            QVERIFY(support::between(glm::length(apart), 0.0, mostMm));
            QVERIFY(support::between(std::hypot(apart.x, apart.y), 0.0, 1.0));
        }
    }

    void otherNumbersAreNotTheHead()
    {
        lab::TagScene scene;
        scene.camera = support::usualCamera();
        scene.tag = support::tagBefore(500.0, {0.0, 0.0}, 20.0, 45.0, 0.0);
        for (const int id : {1, 100, kTagCount - 1}) {
            scene.tag->id = id;
            const Picture picture = lab::render(scene);
            QVERIFY(TagTracker({}).look(picture.view()).value().tags.empty());
            TrackerSettings all;
            all.id.reset();
            const auto frame = TagTracker(all).look(picture.view()).value();
            QCOMPARE(frame.tags.size(), std::size_t{1});
            QCOMPARE(frame.tags.front().tag.id, id);
        }
    }

    void photographsGiveTheExpectedTags()
    {
        const QString table = QString::fromStdString(support::sharedData("apriltag/expected_detections.csv"));
        if (table.isEmpty())
            QSKIP("the photographs are not there");
        auto folder = openFolder(QFileInfo(table).path().toStdString());
        QVERIFY(support::succeeds(folder));
        TagDetector detector({});
        Picture picture;
        int checked = 0;
        while ((*folder)->next(picture).value()) {
            auto seen = detector.find(picture.view(), {1, true});
            const QString name = QFileInfo(QString::fromStdString(picture.name)).fileName();
            for (const Expected& expected : expectedOf(table, name)) {
                const auto match = std::find_if(seen.begin(), seen.end(), [&](const SeenTag& tag) {
                    return tag.id == expected.id && farthestCorner(tag, expected.corners) < 0.5;
                });
                QVERIFY2(match != seen.end(), qPrintable(QString("%1: %2").arg(name).arg(expected.id)));
                seen.erase(match);
                ++checked;
            }
            QVERIFY2(seen.empty(), qPrintable(name + " has a tag that is not expected"));
        }
        QCOMPARE(checked, 35);
    }
};

CUSP_TEST(TestTagSearch)
#include "tst_tag_search.moc"
