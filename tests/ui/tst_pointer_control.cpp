// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <glm/geometric.hpp>

#include <QTest>

#include "core/servo/ServoState.h"
#include "tests/support/Suite.h"
#include "tests/support/SyntheticMolar.h"
#include "tests/support/Tables.h"
#include "ui/tooth/Camera.h"
#include "ui/tooth/PointerControl.h"

using core::servo::PointerInput;
using ui::render::Ray;
using ui::render::ToothSurface;
using ui::tooth::Camera;
using ui::tooth::PointerControl;

class TestPointerControl : public QObject
{
    Q_OBJECT

private slots:
    void init()
    {
        m_camera = {};
        m_camera.setSubject({0.0, 0.0, -3.0}, 7.0);
        m_camera.setViewport({1000.0, 800.0});
        m_control = {};
        m_control.setSurface(&m_surface);
        m_control.setBurRadius(0.5);
    }

    void hoversAboveEverythingUnderTheBur()
    {
        for (double x = 100.0; x < 900.0; x += 37.0) {
            point({x, 420.0});
            const PointerInput wish = m_control.input();
            for (double angle = 0.0; angle < 6.28; angle += 0.3) {
                const glm::dvec2 rim = wish.targetMm + 0.45 * glm::dvec2(std::cos(angle), std::sin(angle));
                QVERIFY(wish.hoverMm > m_surface.heightMm(rim) + 0.5);
            }
            QVERIFY(!wish.pushing);
        }
    }

    void neverLeapsWhenTheCursorSweepsAcrossTheTooth_data()
    {
        support::columns<double, bool>("elevation", "vertical");
        QTest::newRow("from above, across") << 88.0 << false;
        QTest::newRow("from above, up and down") << 88.0 << true;
        QTest::newRow("three quarters, across") << 48.0 << false;
        QTest::newRow("three quarters, up and down") << 48.0 << true;
    }

    void neverLeapsWhenTheCursorSweepsAcrossTheTooth()
    {
        QFETCH(double, elevation);
        QFETCH(bool, vertical);
        m_camera.set(10.0, elevation, m_camera.fittingMm());
        // A cusp hides a length equal to the shadow that it would throw from the eye. Any other step is that of a
        // pixel.
        const double relief = m_surface.highestMm().z - m_surface.restingHeightMm();
        for (int line = 0; line < 20; ++line) {
            glm::dvec2 last{0.0};
            for (int k = 0; k < 600; ++k) {
                const double along = 100.0 + k;
                const double across = 150.0 + 25.0 * line;
                const Ray ray = m_camera.rayThrough(vertical ? glm::dvec2(across, along) : glm::dvec2(along, across));
                m_control.moveTo(ray, {});
                const glm::dvec2 target = m_control.input().targetMm;
                const double hiddenMm = relief * glm::length(glm::dvec2(ray.direction)) / -ray.direction.z;
                if (k > 0)
                    QVERIFY2(glm::distance(target, last) < 0.1 + hiddenMm,
                             qPrintable(QString("%1 mm for one pixel").arg(glm::distance(target, last))));
                last = target;
            }
        }
    }

    void pressingAimsWhereTheRayMeetsTheTooth()
    {
        point({480.0, 390.0});
        const glm::dvec2 before = m_control.input().targetMm;
        m_control.push(true);
        point({480.0, 390.0}, {before, -1.0});
        const glm::dvec2 target = m_control.input().targetMm;
        QVERIFY(glm::distance(m_camera.pixelOf({target, m_surface.heightMm(target)}), {480.0, 390.0}) < 1.0);
        QVERIFY(m_control.input().pushing);
        m_control.push(false);
        QVERIFY(!m_control.input().pushing);
    }

    void theHoveringTipIsOnTheRay()
    {
        for (const double elevation : {88.0, 48.0, 25.0}) {
            m_camera.set(10.0, elevation, m_camera.fittingMm());
            for (double x = 150.0; x < 850.0; x += 23.0) {
                const glm::dvec2 pixel(x, 380.0);
                point(pixel);
                const PointerInput wish = m_control.input();
                QVERIFY(glm::distance(m_camera.pixelOf({wish.targetMm, wish.hoverMm}), pixel) < 1.0);
            }
        }
    }

    void theBurComesDownOnlyWhereThePointerIs()
    {
        point({500.0, 400.0});
        m_control.push(true);
        point({500.0, 400.0}, {3.0, 3.0, 2.0});
        QVERIFY(!m_control.input(glm::dvec3(3.0, 3.0, 2.0)).pushing);
        const glm::dvec2 target = m_control.input().targetMm;
        QVERIFY(m_control.input(glm::dvec3(target, 2.0)).pushing);
    }

    void whatRestsMovesNothingAndAStrokeBringsTheBurBack()
    {
        point({500.0, 400.0});
        m_control.push(true);
        point({500.0, 400.0});
        const glm::dvec2 start = m_control.input().targetMm;
        touch({start, -2.0}, 0.0);
        // While the bur goes down, the ray meets its height at another place.
        point({500.0, 400.0}, {start, -3.5});
        QCOMPARE(fromTarget(start), 0.0);
        glm::dvec2 last = start;
        for (int k = 1; k <= 200; ++k) {
            point({500.0 + k, 400.0}, {last, -3.5});
            const double step = fromTarget(last);
            QVERIFY2(step < 0.1, qPrintable(QString::number(step)));
            last = m_control.input().targetMm;
        }
        QVERIFY(glm::distance(m_camera.pixelOf({last, -3.5}), {700.0, 400.0}) < 3.0);
    }

    void theDepthStopIsAPlaneOfTheCavity()
    {
        m_control.setStopOn(true);
        m_control.setStopDepth(1.5);
        m_control.push(true);
        QVERIFY(!m_control.stopMm());
        const double surface = m_surface.heightMm({0.0, 0.0});
        touch({0.0, 0.0, surface + 0.1}, 0.0);
        QVERIFY(isAt(surface - 1.5));
        QCOMPARE(m_control.input().stopMm, *m_control.stopMm());
        QVERIFY(std::abs(*m_control.depthMm(surface - 0.6) - 0.6) < 0.02);
        m_control.setStopDepth(1.6);
        QVERIFY(isAt(surface - 1.6));
        // The next press is within the cavity, where the surface was lower.
        m_control.push(false);
        m_control.push(true);
        touch({0.5, 0.0, surface - 1.0}, 0.7);
        QVERIFY(isAt(surface - 1.6));
        // The next press is beside it.
        m_control.push(false);
        m_control.push(true);
        touch({2.0, 0.0, m_surface.heightMm({2.0, 0.0})}, 0.0);
        QVERIFY(isAt(m_surface.heightMm({2.0, 0.0}) - 1.6));
        m_control.setStopOn(false);
        QVERIFY(!m_control.stopMm() && std::isinf(m_control.input().stopMm));
        for (const double asked : {-1.0, 100.0}) {
            m_control.setStopDepth(asked);
            m_control.setFeed(asked);
            QVERIFY(m_control.stopDepthMm() >= PointerControl::kShallowestMm &&
                    m_control.stopDepthMm() <= PointerControl::kDeepestMm);
            QVERIFY(m_control.feedMmPerS() >= PointerControl::kSlowestMmPerS &&
                    m_control.feedMmPerS() <= PointerControl::kFastestMmPerS);
        }
    }

    void liftsOverACuspBeforeGoingBehindIt()
    {
        // Moves from the fossa over the mesiobuccal cusp to its far side.
        const glm::dvec2 fossa(-0.9, -0.3);
        m_camera.set(0.0, 88.0, m_camera.fittingMm());
        point(m_camera.pixelOf({-3.9, -4.0, -2.5}));
        const PointerInput far = m_control.input();
        const double cusp = m_surface.heightMm({-2.6, -2.6});
        QVERIFY(far.hoverMm < cusp);
        const double low = m_surface.heightMm(fossa) + 0.05;
        const PointerInput lifting = m_control.input(glm::dvec3(fossa, low));
        QCOMPARE(lifting.targetMm.x, fossa.x);
        QVERIFY(lifting.hoverMm > cusp);
        const PointerInput going = m_control.input(glm::dvec3(fossa, lifting.hoverMm));
        QCOMPARE(going.targetMm.x, far.targetMm.x);
        QVERIFY(going.hoverMm > cusp);
        const PointerInput there = m_control.input(glm::dvec3(far.targetMm, lifting.hoverMm));
        QCOMPARE(there.hoverMm, far.hoverMm);
        // While the bur presses on the tooth, it is not lifted over a cusp.
        m_control.push(true);
        touch({fossa, low}, 0.0);
        QCOMPARE(m_control.input(glm::dvec3(fossa, low)).targetMm.x, far.targetMm.x);
    }

    void liftingWinsOverPushing()
    {
        m_control.push(true);
        m_control.lift(true);
        QVERIFY(!m_control.input().pushing);
        QCOMPARE(m_control.input().hoverMm, m_surface.highestMm().z + PointerControl::kLiftMm);
        m_control.lift(false);
        QVERIFY(m_control.input().pushing);
    }

    void forceStaysWithinItsBounds()
    {
        QCOMPARE(m_control.forceN(), PointerControl::kFirstN);
        m_control.setForce(100.0);
        QCOMPARE(m_control.input().pushForceN, PointerControl::kStrongestN);
        m_control.setForce(-1.0);
        QCOMPARE(m_control.input().pushForceN, PointerControl::kWeakestN);
        m_control.setForce(1.0);
        m_control.push(true);
        m_control.setPressure(0.25);
        QCOMPARE(m_control.input().pushForceN, 0.25);
        m_control.push(false);
        QCOMPARE(m_control.input().pushForceN, 1.0);
    }

    void targetStaysNearTheTooth()
    {
        for (int k = 0; k < 1000; ++k)
            m_control.moveBy({1.0, -1.0});
        const PointerInput wish = m_control.input();
        QVERIFY(wish.targetMm.x < 12.0 && wish.targetMm.y > -12.0);
        QCOMPARE(wish.hoverMm, m_surface.restingHeightMm() + PointerControl::kClearanceMm);
        // A ray that points upwards meets nothing, and the bur does not move.
        m_control.moveTo(Ray{{0.0, 0.0, -20.0}, {0.0, 0.0, 1.0}}, {});
        QCOMPARE(m_control.input().targetMm.x, wish.targetMm.x);
    }

private:
    /// Moves the mouse to a pixel.
    void point(glm::dvec2 pixel, glm::dvec3 burMm = {}) { m_control.moveTo(m_camera.rayThrough(pixel), burMm); }

    /// Reports that the bur touches the tooth with its tip this far below the original surface.
    void touch(glm::dvec3 burMm, double depthMm)
    {
        core::servo::ServoState servo;
        servo.anchorMm = burMm;
        servo.depthMm = depthMm;
        servo.hasDepth = true;
        servo.touching = true;
        m_control.follow(servo);
    }

    /// Returns whether the depth stop is at this height.
    [[nodiscard]] bool isAt(double heightMm) const { return std::abs(*m_control.stopMm() - heightMm) < 0.02; }

    [[nodiscard]] double fromTarget(glm::dvec2 placeMm) const
    {
        return glm::distance(m_control.input().targetMm, placeMm);
    }

    const ToothSurface m_surface{support::syntheticMolar(), glm::vec3(0.0F, 0.0F, 1.0F)};
    Camera m_camera;
    PointerControl m_control;
};

CUSP_TEST(TestPointerControl)
#include "tst_pointer_control.moc"
