// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

#include <QTest>

#include "core/teeth/Laid.h"
#include "core/teeth/ToothTable.h"
#include "tests/support/Checks.h"
#include "tests/support/Suite.h"
#include "tests/support/Tables.h"
#include "ui/tooth/Camera.h"
#include "ui/tooth/Viewpoint.h"

using support::near;
using ui::tooth::Camera;

namespace {

constexpr glm::dvec3 kMiddle(0.5, -0.25, -3.0);

Camera molarCamera()
{
    Camera camera;
    camera.setSubject(kMiddle, 7.0);
    camera.setViewport({1280.0, 800.0});
    return camera;
}

}  // namespace

class TestCamera : public QObject
{
    Q_OBJECT

private slots:
    void looksAlongYWithXToTheRight()
    {
        Camera camera = molarCamera();
        camera.set(0.0, 40.0, 40.0);
        QVERIFY(glm::distance(camera.rightOnTooth(), glm::dvec2(1.0, 0.0)) < 1e-12);
        QVERIFY(glm::distance(camera.awayOnTooth(), glm::dvec2(0.0, 1.0)) < 1e-12);
        const glm::dvec2 middle = camera.pixelOf(kMiddle);
        QVERIFY(glm::distance(middle, glm::dvec2(640.0, 400.0)) < 1e-6);
        QVERIFY(camera.pixelOf({1.5, -0.25, -3.0}).x > middle.x);
        QVERIFY(camera.pixelOf({0.5, 0.75, -3.0}).y < middle.y);
        QVERIFY(camera.pixelOf({0.5, -0.25, -2.0}).y < middle.y);
    }

    void rayGoesThroughThePixelItCameFrom()
    {
        Camera camera = molarCamera();
        for (const double azimuth : {-170.0, -35.0, 0.0, 80.0}) {
            for (const double elevation : {15.0, 50.0, 88.0}) {
                camera.set(azimuth, elevation, 33.0);
                for (const glm::dvec2 pixel :
                     {glm::dvec2(3.0, 5.0), glm::dvec2(640.0, 400.0), glm::dvec2(1200.0, 700.0)}) {
                    const ui::render::Ray ray = camera.rayThrough(pixel);
                    QVERIFY(std::abs(glm::length(ray.direction) - 1.0) < 1e-12);
                    QVERIFY(glm::distance(camera.pixelOf(ray.originMm + 30.0 * ray.direction), pixel) < 1e-6);
                }
            }
        }
    }

    void wholeSubjectFits_data()
    {
        support::columns<double, double>("width", "height");
        QTest::newRow("wide") << 1920.0 << 1080.0;
        QTest::newRow("tall") << 500.0 << 900.0;
        QTest::newRow("square") << 700.0 << 700.0;
    }

    void wholeSubjectFits()
    {
        QFETCH(double, width);
        QFETCH(double, height);
        Camera camera = molarCamera();
        camera.setViewport({width, height});
        double widest = 0.0;
        for (int k = 0; k < 5000; ++k) {
            const double turn = 0.37 * k;
            const double z = -1.0 + 2.0 * k / 4999.0;
            const double across = std::sqrt(1.0 - z * z);
            const glm::dvec3 point = kMiddle + 7.0 * glm::dvec3(across * std::cos(turn), across * std::sin(turn), z);
            const glm::dvec2 pixel = camera.pixelOf(point);
            QVERIFY2(pixel.x > -1.0 && pixel.x < width + 1.0 && pixel.y > -1.0 && pixel.y < height + 1.0,
                     "point outside");
            widest = std::max({widest, std::abs(pixel.x / width - 0.5), std::abs(pixel.y / height - 0.5)});
        }
        QVERIFY2(widest > 0.49, "the subject could be shown larger");
    }

    void elevationAndDistanceAreBounded()
    {
        Camera camera = molarCamera();
        camera.turn(0.0, 500.0);
        QCOMPARE(camera.elevationDeg(), Camera::kHighestDeg);
        camera.turn(0.0, -500.0);
        QCOMPARE(camera.elevationDeg(), Camera::kLowestDeg);
        camera.turn(720.0 + 30.0 - camera.azimuthDeg(), 0.0);
        QVERIFY(near(camera.azimuthDeg(), 30.0));
        camera.zoom(1000.0);
        camera.advance(10.0);
        const double closest = camera.distanceMm();
        camera.zoom(1.0);
        camera.advance(10.0);
        QCOMPARE(camera.distanceMm(), closest);
        QVERIFY(closest > 3.0);
        camera.set(0.0, 45.0, 1.0e9);
        QVERIFY(camera.distanceMm() < 5.0 * camera.fittingMm());
    }

    void zoomIsReachedSmoothly()
    {
        Camera camera = molarCamera();
        const double before = camera.distanceMm();
        camera.zoom(3.0);
        QCOMPARE(camera.distanceMm(), before);
        double last = before;
        int frames = 0;
        while (camera.advance(0.016)) {
            QVERIFY(camera.distanceMm() < last);
            last = camera.distanceMm();
            ++frames;
        }
        QVERIFY(frames > 5);
        QVERIFY(frames < 60);
        QVERIFY(last < 0.72 * before);
        QVERIFY(!camera.advance(0.016));
    }

    void zoomKeepsWhatIsUnderThePointer()
    {
        Camera camera = molarCamera();
        const glm::dvec2 middle = camera.pixelOf(kMiddle);
        const glm::dvec3 cusp(3.0, 2.0, -0.5);
        const glm::dvec2 before = camera.pixelOf(cusp);
        camera.zoom(6.0, cusp);
        while (camera.advance(0.016))
            QVERIFY(glm::distance(camera.pixelOf(cusp), before) < 1e-6);
        QVERIFY(glm::distance(camera.pixelOf(cusp), before) < 1e-6);
        // Zooming out again, at any position of the pointer, brings the whole crown back to the middle.
        camera.zoom(-9.0, glm::dvec3(-3.0, 1.0, -2.0));
        camera.advance(10.0);
        QVERIFY(glm::distance(camera.pixelOf(kMiddle), middle) < 1e-6);
        camera.zoom(4.0);
        camera.advance(10.0);
        QVERIFY2(glm::distance(camera.pixelOf(kMiddle), middle) < 1e-6, "by the keys: straight ahead");
    }

    void fittedDistanceFollowsTheWindowUntilSomeoneZooms()
    {
        Camera camera = molarCamera();
        camera.setViewport({400.0, 800.0});
        QCOMPARE(camera.distanceMm(), camera.fittingMm());
        camera.zoom(1.0);
        camera.advance(10.0);
        const double chosen = camera.distanceMm();
        camera.setViewport({1280.0, 800.0});
        QCOMPARE(camera.distanceMm(), chosen);
    }

    void leansWithTheHead_data()
    {
        QTest::addColumn<double>("elevationDeg");
        for (const double elevation : {0.0, 40.0, 85.0})
            QTest::addRow("%.0f degrees", elevation) << elevation;
    }
    /// The head rotates the view about the axes of the screen, from any viewpoint.
    void leansWithTheHead()
    {
        QFETCH(double, elevationDeg);
        Camera camera = molarCamera();
        camera.set(10.0, elevationDeg, 40.0);
        const glm::dvec3 straight = (camera.eyeMm() - kMiddle) / 40.0;
        const glm::dvec3 right(camera.rightOnTooth(), 0.0);
        camera.lean({15.0, 0.0, 1.25});
        glm::dvec3 eye = (camera.eyeMm() - kMiddle) / 50.0;
        QVERIFY(near(glm::dot(eye, straight), std::cos(glm::radians(15.0)), 1e-9));
        QVERIFY(near(glm::dot(eye, right), std::sin(glm::radians(15.0)), 1e-9));
        camera.lean({0.0, 5.0, 1.0});
        eye = (camera.eyeMm() - kMiddle) / 40.0;
        QVERIFY(near(glm::dot(eye, glm::cross(straight, right)), std::sin(glm::radians(5.0)), 1e-9));
        QVERIFY(near(camera.elevationDeg(), std::min(elevationDeg + 5.0, 180.0 - elevationDeg - 5.0), 1e-6));
        // The ray of a pixel still passes through that pixel.
        camera.lean({15.0, 5.0, 1.25});
        const ui::render::Ray ray = camera.rayThrough({300.0, 200.0});
        QVERIFY(glm::distance(camera.pixelOf(ray.originMm + 30.0 * ray.direction), glm::dvec2(300.0, 200.0)) < 1e-6);
        // The subject stays in the middle, and the picture does not rotate in its plane.
        QVERIFY(glm::distance(camera.pixelOf(kMiddle), glm::dvec2(640.0, 400.0)) < 1e-6);
        camera.lean({15.0, 0.0, 1.0});
        const glm::dvec3 above = kMiddle + 0.5 * glm::cross(straight, right);
        QVERIFY(near(camera.pixelOf(above).x, 640.0, 1e-6));
        // The mouse turns the camera without the lean.
        camera.turn(-20.0, 0.0);
        camera.lean({});
        QVERIFY(near(camera.azimuthDeg(), -10.0, 1e-9));
        QVERIFY(near(camera.elevationDeg(), elevationDeg, 1e-9));
        QVERIFY(near(camera.distanceMm(), 40.0, 1e-9));
    }

    /// The head moves in front of the screen as in front of a window: points in the plane of the screen stay in place.
    void theScreenCanBeAWindow()
    {
        Camera camera = molarCamera();
        camera.set(10.0, 40.0, 40.0);
        const glm::dvec2 pixel(900.0, 250.0);
        const ui::render::Ray straight = camera.rayThrough(pixel);
        const glm::dvec3 forward = glm::normalize(kMiddle - camera.eyeMm());
        const glm::dvec3 onGlass =
            straight.originMm + straight.direction * (40.0 / glm::dot(straight.direction, forward));
        core::tracking::Lean lean;
        lean.rightShare = 0.3;
        lean.upShare = -0.1;
        camera.lean(lean);
        QVERIFY(glm::distance(camera.pixelOf(onGlass), pixel) < 1e-6);
        const ui::render::Ray ray = camera.rayThrough(pixel);
        QVERIFY(glm::distance(camera.pixelOf(ray.originMm + 33.0 * ray.direction), pixel) < 1e-6);
        // Points behind the screen move in the direction of the head.
        QVERIFY(camera.pixelOf(onGlass + 5.0 * forward).x > pixel.x);
        QVERIFY(camera.pixelOf(onGlass + 5.0 * forward).y > pixel.y);
    }

    /// The names of viewpoints refer to the tooth, whichever side of it is up.
    void viewpointsFollowATooth()
    {
        for (const char* side : {"buccal", "lingual", "mesial", "distal"})
            for (const int fdi : {21, 33}) {
                const auto lying = core::teeth::findLying(side, 90.0, fdi).value();
                const double buccal = core::teeth::buccalSign(fdi);
                for (const auto& [name, own] :
                     {std::pair("mesial", glm::dvec3(-1.0, 0.0, 0.0)), std::pair("distal", glm::dvec3(1.0, 0.0, 0.0)),
                      std::pair("buccal", glm::dvec3(0.0, buccal, 0.0)),
                      std::pair("lingual", glm::dvec3(0.0, -buccal, 0.0)),
                      std::pair("occlusal", glm::dvec3(0.0, 0.0, 1.0)),
                      std::pair("below", glm::dvec3(0.0, 0.0, -1.0))}) {
                    Camera camera = molarCamera();
                    QVERIFY(ui::tooth::goTo(camera, QString::fromLatin1(name), fdi, lying));
                    const glm::dvec3 towardsEye = glm::normalize(camera.eyeMm() - kMiddle);
                    QVERIFY(glm::dot(towardsEye, lying.cutFromOwn() * own) > std::cos(13.0 * support::kDegree));
                }
                Camera camera = molarCamera();
                QVERIFY(ui::tooth::goTo(camera, QStringLiteral("above"), fdi, lying));
                QVERIFY(camera.elevationDeg() > 85.0);
            }
    }

    void whatIsBehindTheEyeLiesOutsideOnItsSide()
    {
        const Camera camera = molarCamera();
        const glm::dmat4 toothFromEye = glm::inverse(camera.view());
        for (const glm::dvec2 aside : {glm::dvec2(2.0, 0.0), glm::dvec2(-2.0, 0.0), glm::dvec2(0.0, 2.0)}) {
            const glm::dvec3 behind(toothFromEye * glm::dvec4(aside, 3.0, 1.0));
            const glm::dvec2 pixel = camera.pixelOf(behind);
            QVERIFY(aside.x <= 0.0 || pixel.x > 2000.0);
            QVERIFY(aside.x >= 0.0 || pixel.x < -2000.0);
            QVERIFY(aside.y <= 0.0 || pixel.y < -2000.0);
        }
    }
};

CUSP_TEST(TestCamera)
#include "tst_camera.moc"
