// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <memory>

#include <glm/geometric.hpp>

#include <QElapsedTimer>
#include <QMouseEvent>
#include <QPointingDevice>
#include <QSignalSpy>
#include <QTabletEvent>
#include <QTest>
#include <QWheelEvent>

#include "core/servo/ServoState.h"
#include "core/session/SessionChannels.h"
#include "tests/support/Checks.h"
#include "tests/support/SyntheticMolar.h"
#include "tests/ui/Pictures.h"
#include "ui/tooth/ToothView.h"

using core::servo::PointerInput;
using core::servo::ServoState;
using core::session::UiChannels;
using core::terrain::ToothAnatomy;
using support::near;
using ui::tooth::Camera;
using ui::tooth::PointerControl;
using ui::tooth::PointerKind;
using ui::tooth::ToothView;

class TestToothView : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase()
    {
        m_tooth = support::syntheticMolar();
        m_links = std::make_unique<UiChannels>();
        m_view = std::make_unique<ToothView>(*m_links);
        QVERIFY(m_view->isUsable());
        m_view->resize(640, 480);
        m_view->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_view.get()));
        m_view->activateWindow();
    }

    /// Resets the view to its initial state with a whole tooth.
    void init()
    {
        m_links->servo.publish({});
        m_view->release();
        m_view->setSettings({});
        m_view->setLeftHanded(false);
        m_view->setDrillOn(false);
        // The view shows a new force beside the bur for some time.
        if (m_view->hand().forceN() != PointerControl::kFirstN)
            m_view->setPushForce(PointerControl::kFirstN);
        m_view->setTooth(m_tooth, m_generation += 10);
        click(Qt::Key_Home);
        m_view->setFocus();
        move(m_view->rect().center());
    }

    void cleanupTestCase()
    {
        m_view.reset();
        m_links.reset();
    }

    void appliesAGroupOfPatchesOnlyWhole()
    {
        const QImage before = picture();
        const glm::dvec2 place = pictures::tileMiddle(m_tooth->grid, {1.8, 1.0});
        QVERIFY(m_links->patches.tryPush(pictures::cutTile(*m_tooth, place, -4.0F, m_generation, false)));
        QCOMPARE(pictures::difference(before, picture(), 2).pixels, 0);
        QVERIFY(m_links->patches.tryPush(pictures::cutTile(*m_tooth, {-1.6, 0.4}, -4.0F, m_generation, true)));
        const QImage after = picture();
        QVERIFY(pictures::difference(before, after, 12).pixels > 400);
        const QPoint pixel = pixelOf({place, -4.0});
        const QRect first = pictures::around(pixel.x(), pixel.y(), 5);
        QVERIFY(pictures::difference(before.copy(first), after.copy(first), 12).pixels > 0);
    }

    /// The blood is drawn as the patches arrive, not only in a picture of the whole tooth.
    void anOpenedPulpBleedsAtOnce()
    {
        look(0.0, 89.0);
        std::size_t highest = 0;
        for (std::size_t k = 0; k < m_tooth->layers.size(); ++k)
            if (hasPulp(*m_tooth, k) &&
                (highest == 0 || m_tooth->layers[k].pulpRoof > m_tooth->layers[highest].pulpRoof))
                highest = k;
        const int side = m_tooth->grid.side;
        const glm::dvec2 place =
            m_tooth->grid.nodeMm(static_cast<int>(highest) % side, static_cast<int>(highest) / side);
        const float roofMm = m_tooth->layers[highest].pulpRoof;
        const auto redPixels = [&](float floorMm) {
            static_cast<void>(m_links->patches.tryPush(pictures::cutTile(*m_tooth, place, floorMm, m_generation)));
            const QImage image = picture();
            int red = 0;
            for (int y = 0; y < image.height(); ++y)
                for (int x = 0; x < image.width(); ++x) {
                    const QColor colour = image.pixelColor(x, y);
                    red += colour.red() > 40 && colour.red() > 3 * colour.green() ? 1 : 0;
                }
            return red;
        };
        QCOMPARE(redPixels(roofMm + 0.05F), 0);
        QVERIFY(redPixels(roofMm - 0.001F) > 20);
    }

    void aGamepadMovesTurnsAndPresses()
    {
        const auto input = [this] { return m_links->pointer.latest(); };
        const glm::dvec2 before = input().targetMm;
        const double azimuthDeg = m_view->camera().azimuthDeg();
        m_view->setPad({.move = {1.0, 0.0}});
        QTRY_VERIFY(glm::distance(input().targetMm, before) > 0.5);
        m_view->setPad({.turn = {1.0, 0.0}});
        QTRY_VERIFY(std::abs(m_view->camera().azimuthDeg() - azimuthDeg) > 5.0);
        m_view->setPad({.press = 0.5});
        QTRY_VERIFY(input().pushing);
        QTRY_VERIFY(std::abs(input().pushForceN - 0.5 * PointerControl::kFirstN) < 1e-9);
        QVERIFY(m_view->isPressed());
        m_view->setPad({.press = 1.0});
        QTRY_VERIFY(std::abs(input().pushForceN - PointerControl::kFirstN) < 1e-9);
        m_view->setPad({});
        QTRY_VERIFY(!input().pushing);
        // After the view was left, it must be pressed again; a trigger that is still held has no effect.
        m_view->setPad({.press = 1.0});
        QTRY_VERIFY(input().pushing);
        m_view->release();
        QTRY_VERIFY(!input().pushing);
        m_view->setPad({});
        QVERIFY(QSignalSpy(m_view.get(), &ToothView::frameAdvanced).wait());
        // Seen from below, the trigger does not push.
        QSignalSpy refused(m_view.get(), &ToothView::pushRefused);
        m_view->setCamera(0.0, -40.0, 30.0);
        QTRY_VERIFY(m_view->camera().elevationDeg() < 0.0);
        m_view->setPad({.press = 1.0});
        QTRY_COMPARE(refused.count(), 1);
        QVERIFY(!input().pushing);
        m_view->setPad({});
    }

    void ignoresPatchesOfAnotherTooth()
    {
        const QImage before = picture();
        for (const std::uint64_t other : {m_generation - 1, m_generation + 1})
            QVERIFY(m_links->patches.tryPush(pictures::cutTile(*m_tooth, {1.8, 1.0}, -4.0F, other)));
        QCOMPARE(pictures::difference(before, picture(), 2).pixels, 0);
        // The tooth comes to the view with the cuts that the session already has.
        m_view->setTooth(m_tooth, m_generation + 1);
        QVERIFY(pictures::difference(before, picture(), 12).pixels > 300);
    }

    void showsTheBurWhereTheServoHoldsIt()
    {
        const QImage before = picture();
        ServoState state = burAt({kCusp, 0.2});
        state.deviceMm = {kCusp, -5.0};  // the hand is deep inside, which must have no effect
        m_links->servo.publish(state);
        const QPoint neck = pixelOf({kCusp, 1.2});
        QVERIFY(pictures::differs(before.pixel(neck), picture().pixel(neck), 15));
        m_links->servo.publish(burAt({3.0, 2.0, 1.0}));
        const QImage moved = picture();
        QVERIFY(!pictures::differs(before.pixel(neck), moved.pixel(neck), 15));
        const QPoint there = pixelOf({3.0, 2.0, 2.0});
        QVERIFY(pictures::differs(before.pixel(there), moved.pixel(there), 15));
    }

    /// Deep in the tooth the shank is drawn longer. Another bur at the same place needs another length.
    void withLessMotionTheHandpieceIsLiftedAtOnce()
    {
        // Returns the first picture of a bur.
        const auto firstOf = [&](std::uint8_t bur) {
            ServoState state = burAt({kCusp, -7.0});
            state.burIndex = bur;
            m_links->servo.publish(state);
            return framesPass(1) ? m_view->picture() : QImage();
        };
        const QImage gliding = firstOf(0);
        QTRY_VERIFY(pictures::difference(gliding, m_view->picture(), 8).pixels > 100);
        ui::tooth::ViewSettings calm;
        calm.movesLittle = true;
        m_view->setSettings(calm);
        for (const std::uint8_t bur : {std::uint8_t{3}, std::uint8_t{0}}) {
            const QImage lifted = firstOf(bur);
            QVERIFY(framesPass(10));
            QCOMPARE(pictures::difference(lifted, picture(), 8).pixels, 0);
        }
    }

    void reportsEveryFrameWithTheNewestState()
    {
        QSignalSpy frames(m_view.get(), &ToothView::frameAdvanced);
        ServoState state;
        for (const std::uint64_t tick : {17U, 18U}) {
            state.tick = tick;
            m_links->servo.publish(state);
        }
        QTRY_VERIFY(frames.count() >= 3);
        QCOMPARE(frames.back().front().value<ServoState>().tick, std::uint64_t{18});
    }

    void paintsOnlyWhenSomethingShows()
    {
        ServoState state = burAt({});
        m_links->servo.publish(state);
        QVERIFY(picturesUntilRest(*m_view) > 0);
        state.tick = 500;  // time passes, but nothing moves
        m_links->servo.publish(state);
        QCOMPARE(picturesUntilRest(*m_view), 0);
        state.anchorMm.x += 0.5;
        m_links->servo.publish(state);
        QVERIFY(picturesUntilRest(*m_view) > 0);
    }

    void mouseMovesTheBurAndItsButtonPushes()
    {
        look(0.0, 88.0);
        const glm::dvec2 wanted(-1.5, 2.0);
        const QPoint at = pixelOf({wanted, -2.0});
        move(at);
        QVERIFY(near(pixelOf({pointer().targetMm, pointer().hoverMm}).x(), at.x(), 2.0));
        QVERIFY(near(pixelOf({pointer().targetMm, pointer().hoverMm}).y(), at.y(), 2.0));
        QVERIFY(!pointer().pushing);
        QVERIFY(pointer().hoverMm > -3.3);
        QTest::mousePress(m_view.get(), Qt::LeftButton, {}, at);
        QVERIFY(pointer().pushing);
        QCOMPARE(pointer().pushForceN, PointerControl::kFirstN);
        QTest::mouseRelease(m_view.get(), Qt::LeftButton, {}, at);
        QVERIFY(!pointer().pushing);
    }

    void aPenPushesWithItsPressure()
    {
        look(0.0, 88.0);
        const QPoint at = pixelOf({-1.5, 2.0, -2.0});
        const QPointingDevice pen(QStringLiteral("pen"), 1, QInputDevice::DeviceType::Stylus,
                                  QPointingDevice::PointerType::Pen, QInputDevice::Capability::Pressure, 1, 1);
        const auto send = [&](QEvent::Type type, double pressure, Qt::MouseButton button) {
            const bool isDown = type != QEvent::TabletRelease && pressure > 0.0;
            QTabletEvent event(type, &pen, at, m_view->mapToGlobal(at), pressure, 0.0F, 0.0F, 0.0F, 0.0, 0.0F,
                               Qt::NoModifier, button, isDown ? Qt::LeftButton : Qt::NoButton);
            QCoreApplication::sendEvent(m_view.get(), &event);
            return event.isAccepted();
        };
        QVERIFY(send(QEvent::TabletMove, 0.0, Qt::NoButton));
        // A hovering pen moves the bur without pressing.
        QVERIFY(near(pixelOf({pointer().targetMm, pointer().hoverMm}).x(), at.x(), 2.0));
        QVERIFY(!pointer().pushing);
        m_links->servo.publish(burAt({pointer().targetMm, pointer().hoverMm}));
        QVERIFY(send(QEvent::TabletPress, 0.5, Qt::LeftButton));
        QTRY_VERIFY(pointer().pushing);
        QVERIFY(near(pointer().pushForceN, 0.5 * PointerControl::kFirstN));
        m_view->setPen({2.0});
        const auto linear = qScopeGuard([this] { m_view->setPen({}); });
        QVERIFY(send(QEvent::TabletMove, 0.5, Qt::NoButton));
        QVERIFY(near(pointer().pushForceN, 0.25 * PointerControl::kFirstN));
        QVERIFY(send(QEvent::TabletMove, 1.0, Qt::NoButton));
        QVERIFY(near(pointer().pushForceN, PointerControl::kFirstN));
        QVERIFY(send(QEvent::TabletRelease, 0.0, Qt::LeftButton));
        QVERIFY(!pointer().pushing);
        QVERIFY(m_view->pushedWith() == PointerKind::Pen);
    }

    void oneFingerTurnsAndTwoZoom()
    {
        look(0.0, 60.0);
        std::unique_ptr<QPointingDevice> screen(QTest::createTouchDevice());
        const QPoint at = m_view->rect().center();
        const double azimuthDeg = m_view->camera().azimuthDeg();
        QTest::touchEvent(m_view.get(), screen.get()).press(0, at);
        QTest::touchEvent(m_view.get(), screen.get()).move(0, at + QPoint(60, 0));
        QVERIFY(m_view->camera().azimuthDeg() != azimuthDeg);
        QVERIFY(!pointer().pushing);
        const double turnedDeg = m_view->camera().azimuthDeg();
        const double distanceMm = m_view->camera().distanceMm();
        QTest::touchEvent(m_view.get(), screen.get()).move(0, at + QPoint(60, 0)).press(1, at - QPoint(60, 0));
        QTest::touchEvent(m_view.get(), screen.get()).move(0, at + QPoint(120, 0)).move(1, at - QPoint(120, 0));
        QTRY_VERIFY(m_view->camera().distanceMm() < 0.8 * distanceMm);
        QTest::touchEvent(m_view.get(), screen.get()).release(0, at).release(1, at);
        QCOMPARE(m_view->camera().azimuthDeg(), turnedDeg);
        QVERIFY(!pointer().pushing);
    }

    /// The input device of an attempt is stored with it.
    void theViewKnowsWhatPushes()
    {
        look(0.0, 88.0);
        const QPoint at = pixelOf({-1.5, 2.0, -2.0});
        QTest::keyPress(m_view.get(), Qt::Key_PageDown);
        QVERIFY(m_view->pushedWith() == PointerKind::Keyboard);
        QTest::keyRelease(m_view.get(), Qt::Key_PageDown);
        move(at);
        QVERIFY(m_view->pushedWith() == PointerKind::Keyboard);
        QTest::mousePress(m_view.get(), Qt::LeftButton, {}, at);
        QVERIFY(m_view->pushedWith() == PointerKind::Mouse);
        QTest::mouseRelease(m_view.get(), Qt::LeftButton, {}, at);
    }

    void theBurStaysUnderAPointerThatRests()
    {
        // The simulated bur is where the view requests it, as a free hand would be within a tick.
        look(20.0, 48.0);
        const QPoint at = pixelOf({0.0, 1.0, -2.5});
        move(at);
        const auto offPx = [&] {
            ServoState state = burAt({pointer().targetMm, pointer().hoverMm});
            m_links->servo.publish(state);
            return QLineF(pixelOf(state.anchorMm), at).length();
        };
        QVERIFY(offPx() < 2.0);
        look(60.0, 80.0);
        QTRY_VERIFY(offPx() < 2.0);
        QTest::keyClick(m_view.get(), Qt::Key_Plus);
        QTRY_VERIFY(m_view->camera().distanceMm() < 50.0 && offPx() < 2.0);
        ServoState state = burAt({});
        state.burIndex = 0;
        m_links->servo.publish(state);
        QTRY_VERIFY(offPx() < 2.0);
    }

    void aPressBeforeTheBurHasArrivedWaitsForIt()
    {
        look(0.0, 80.0);
        const QPoint at = pixelOf({2.0, 2.0, -2.0});
        m_links->servo.publish(burAt({-3.0, -2.0, 3.0}));
        QSignalSpy frames(m_view.get(), &ToothView::frameAdvanced);
        QVERIFY(frames.wait());
        QTest::mousePress(m_view.get(), Qt::LeftButton, {}, at);
        QVERIFY(!pointer().pushing);
        m_links->servo.publish(burAt({pointer().targetMm, 3.0}));
        QTRY_VERIFY(pointer().pushing);
        QTest::mouseRelease(m_view.get(), Qt::LeftButton, {}, at);
    }

    void theWheelMovesTheDepthStopWhilePressed()
    {
        look(0.0, 80.0);
        const QPoint at = pixelOf({0.0, 1.0, -2.5});
        m_view->setDepthStop(true, 1.5);
        const double distance = m_view->camera().distanceMm();
        QTest::mousePress(m_view.get(), Qt::LeftButton, {}, at);
        wheel(-1, Qt::NoModifier);
        QVERIFY(near(m_view->hand().stopDepthMm(), 1.6));
        QTest::mouseRelease(m_view.get(), Qt::LeftButton, {}, at);
        wheel(1, Qt::ShiftModifier);
        QVERIFY(near(m_view->hand().stopDepthMm(), 1.5));
        QTest::keyClick(m_view.get(), Qt::Key_Delete);
        QVERIFY(near(m_view->hand().stopDepthMm(), 1.6));
        QCOMPARE(m_view->camera().distanceMm(), distance);
        m_view->setDepthStop(false, 1.5);
        QTest::keyClick(m_view.get(), Qt::Key_Delete);
        QVERIFY(near(m_view->hand().stopDepthMm(), 1.5));
    }

    void pecksAreNoDoubleClick()
    {
        look(40.0, 60.0);
        const QPoint at = pixelOf({0.0, 1.0, -2.5});
        QTest::mouseClick(m_view.get(), Qt::LeftButton, {}, at);
        QTest::mouseDClick(m_view.get(), Qt::LeftButton, {}, at);
        QCOMPARE(m_view->camera().azimuthDeg(), 40.0);
        QVERIFY(pointer().pushing);
        QTest::mouseRelease(m_view.get(), Qt::LeftButton, {}, at);
        QVERIFY(!pointer().pushing);
    }

    void rightDragTurnsTheViewAndLeavesTheBur()
    {
        move({300, 240});
        const PointerInput before = pointer();
        for (const Qt::MouseButton button : {Qt::RightButton, Qt::MiddleButton}) {
            const double azimuth = m_view->camera().azimuthDeg();
            const double elevation = m_view->camera().elevationDeg();
            drag(button, {300, 240}, {340, 260});
            QVERIFY(m_view->camera().azimuthDeg() < azimuth - 5.0);
            QVERIFY(m_view->camera().elevationDeg() > elevation + 3.0);
        }
        QCOMPARE(pointer().targetMm.x, before.targetMm.x);
        QVERIFY(!pointer().pushing);
    }

    void wheelZoomsAndWithControlSetsTheForce()
    {
        const double far = m_view->camera().distanceMm();
        wheel(2, Qt::NoModifier);
        QTRY_VERIFY(m_view->camera().distanceMm() < 0.9 * far);
        QSignalSpy changed(m_view.get(), &ToothView::handChanged);
        wheel(3, Qt::ControlModifier);
        QVERIFY(near(m_view->hand().forceN(), PointerControl::kFirstN + 0.3));
        QVERIFY(near(pointer().pushForceN, PointerControl::kFirstN + 0.3));
        QCOMPARE(changed.count(), 1);
        wheel(-100, Qt::ControlModifier);
        QCOMPARE(m_view->hand().forceN(), PointerControl::kWeakestN);
        wheel(-1, Qt::ControlModifier);
        QCOMPARE(changed.count(), 2);
        click(Qt::Key_Period);
        QVERIFY(near(m_view->hand().forceN(), 0.3));
    }

    void doubleClickResetsTheView()
    {
        m_view->setCamera(120.0, 20.0, 25.0);
        QTest::mouseDClick(m_view.get(), Qt::RightButton, {}, {320, 240});
        QCOMPARE(m_view->camera().azimuthDeg(), Camera::kStartAzimuthDeg);
        QCOMPARE(m_view->camera().elevationDeg(), Camera::kStartElevationDeg);
        m_view->setCamera(120.0, 20.0, 60.0);
        QTest::mouseDClick(m_view.get(), Qt::LeftButton, {}, {8, 8});  // beside the tooth
        QCOMPARE(m_view->camera().azimuthDeg(), Camera::kStartAzimuthDeg);
        QTest::mouseRelease(m_view.get(), Qt::LeftButton, {}, {8, 8});
        QVERIFY(!pointer().pushing);
    }

    void arrowsMoveTheBurInScreenDirections()
    {
        m_view->setCamera(90.0, 50.0, 40.0);  // the eye is at +x: right on the screen is +y
        const glm::dvec2 start = pointer().targetMm;
        const auto moves = [&](Qt::Key key, Qt::KeyboardModifiers with, glm::dvec2 fromStart) {
            click(key, with);
            return near(glm::distance(pointer().targetMm, start + fromStart), 0.0);
        };
        QVERIFY(moves(Qt::Key_Right, {}, {0.0, 0.1}));
        QVERIFY(moves(Qt::Key_Up, {}, {-0.1, 0.1}));
        QVERIFY(moves(Qt::Key_Left, Qt::ShiftModifier, {-0.1, 0.08}));
        QVERIFY(moves(Qt::Key_Down, {}, {0.0, 0.08}));
    }

    void heldArrowGathersSpeedAndShiftIsFine()
    {
        const auto msPerMm = [&](Qt::KeyboardModifiers keys, double untilMm) {
            const glm::dvec2 start = pointer().targetMm;
            QElapsedTimer clock;
            clock.start();
            QTest::keyPress(m_view.get(), Qt::Key_Left, keys);
            const bool arrived =
                QTest::qWaitFor([&] { return glm::distance(pointer().targetMm, start) > untilMm; }, 20000);
            QTest::keyRelease(m_view.get(), Qt::Key_Left, keys);
            return arrived ? static_cast<double>(clock.elapsed()) / untilMm : 0.0;
        };
        const double fine = msPerMm(Qt::ShiftModifier, 0.15);
        const double quick = msPerMm(Qt::NoModifier, 1.2);
        QVERIFY(quick > 0.0);
        QVERIFY(fine > 2.0 * quick);
        QVERIFY(burRests(4));
    }

    void pageKeysPushAndLift()
    {
        QTest::keyPress(m_view.get(), Qt::Key_PageDown);
        QVERIFY(pointer().pushing);
        QTest::keyRelease(m_view.get(), Qt::Key_PageDown);
        QVERIFY(!pointer().pushing);
        const double hover = pointer().hoverMm;
        QTest::keyPress(m_view.get(), Qt::Key_PageUp);
        QVERIFY(pointer().hoverMm > hover + 2.0);
        QTest::keyRelease(m_view.get(), Qt::Key_PageUp);
        QCOMPARE(pointer().hoverMm, hover);
    }

    void losingTheFocusLetsGo()
    {
        QTest::keyPress(m_view.get(), Qt::Key_PageDown);
        QTest::keyPress(m_view.get(), Qt::Key_Right);
        QVERIFY(pointer().pushing);
        QFocusEvent out(QEvent::FocusOut);
        QCoreApplication::sendEvent(m_view.get(), &out);
        QVERIFY(!pointer().pushing);
        // Beyond the 0.2 s after which a held arrow begins to move the bur.
        QVERIFY(burRests(15));
    }

    void aClickFromBelowDoesNotDrill()
    {
        look(0.0, -45.0);
        const QPoint middle = m_view->rect().center();
        QSignalSpy refused(m_view.get(), &ToothView::pushRefused);
        QTest::mousePress(m_view.get(), Qt::LeftButton, {}, middle);
        QVERIFY(!pointer().pushing);
        QCOMPARE(refused.size(), 1);
        QTest::mouseRelease(m_view.get(), Qt::LeftButton, {}, middle);
        QTest::keyPress(m_view.get(), Qt::Key_PageDown);
        QVERIFY(!pointer().pushing);
        QCOMPARE(refused.size(), 2);
        QTest::keyRelease(m_view.get(), Qt::Key_PageDown);
        look(0.0, 45.0);
        QTest::mousePress(m_view.get(), Qt::LeftButton, {}, middle);
        QVERIFY(pointer().pushing);
        QCOMPARE(refused.size(), 2);
    }

    void theToothAloneIsDrawnWithoutTheInstrument()
    {
        const QImage alone = picture();
        m_links->servo.publish(burAt({0.0, 0.0, -1.0}));
        QVERIFY(pictures::difference(alone, picture(), 20).pixels > 300);
        QCOMPARE(pictures::difference(alone, m_view->toothPicture(), 2).pixels, 0);
        QVERIFY(pictures::difference(alone, picture(), 20).pixels > 300);
    }

    void theOtherHandKeepsTheToothAsItIsSeen()
    {
        look(0.0, 60.0);
        const glm::dvec3 tip(0.0, 0.0, -1.0);
        m_links->servo.publish(burAt(tip));
        const QPoint place = pixelOf(tip);
        // The handpiece hides more on one side of the bur than on the other.
        const auto hidesMore = [&](int from, int than) {
            const QImage alone = m_view->toothPicture();
            const QImage whole = picture();
            const auto hidden = [&](int left) {
                const QRect side(left, 0, place.x() - 30, 480);
                return pictures::difference(alone.copy(side), whole.copy(side), 20).pixels;
            };
            return hidden(from) > 2000 && hidden(than) < hidden(from) / 2;
        };
        QVERIFY(hidesMore(place.x() + 30, 0));
        m_view->setLeftHanded(true);
        QCOMPARE(pixelOf(tip), place);
        QVERIFY(hidesMore(0, place.x() + 30));
        const glm::dvec2 start = pointer().targetMm;
        click(Qt::Key_Right);
        QVERIFY(pointer().targetMm.x > start.x);
    }

    void theMirrorIsTheUsersToPlace()
    {
        ui::tooth::ViewSettings settings;
        settings.showsMirror = true;
        m_view->setSettings(settings);
        QVERIFY(m_view->mirror());
        const glm::dvec3 first = m_view->mirror()->centreMm;
        const auto moved = [&](glm::dvec3 from) { return glm::distance(m_view->mirror()->centreMm, from); };
        // The middle of the mirror may be outside the view.
        const auto grip = [this] {
            const QPoint middle = pixelOf(m_view->mirror()->centreMm);
            return QPoint(std::clamp(middle.x(), 8, 631), std::clamp(middle.y(), 8, 471));
        };
        QTest::mousePress(m_view.get(), Qt::LeftButton, {}, grip());
        QVERIFY(!pointer().pushing);
        const QPoint to = grip() + QPoint(10, 6);
        move(to, Qt::LeftButton);
        QTest::mouseRelease(m_view.get(), Qt::LeftButton, {}, to);
        const glm::dvec3 placed = m_view->mirror()->centreMm;
        QVERIFY(moved(first) > 0.1);
        // Two grabs in quick succession are not a double click that resets the view, and changing the hand does not
        // move the mirror.
        const double azimuth = m_view->camera().azimuthDeg() + 7.0;
        m_view->setCamera(azimuth, m_view->camera().elevationDeg(), m_view->camera().distanceMm());
        const QPoint held = grip();
        QTest::mouseDClick(m_view.get(), Qt::LeftButton, {}, held);
        QTest::mouseRelease(m_view.get(), Qt::LeftButton, {}, held);
        QCOMPARE(m_view->camera().azimuthDeg(), azimuth);
        m_view->setLeftHanded(true);
        m_view->resetCamera();
        QCOMPARE(moved(placed), 0.0);
        // Moves and tilts the mirror by keys.
        const auto away = [&] { return moved(m_view->camera().eyeMm()); };
        const double before = away();
        click(Qt::Key_PageUp, Qt::AltModifier);
        QVERIFY(near(away(), before - 1.0, 1e-6));
        click(Qt::Key_PageDown, Qt::AltModifier);
        QVERIFY(near(away(), before, 1e-6));
        const glm::dvec3 normal = m_view->mirror()->normal;
        const auto tilted = [&] { return glm::distance(m_view->mirror()->normal, normal); };
        click(Qt::Key_Left, Qt::AltModifier);
        QVERIFY(moved(placed) > 0.05);
        QCOMPARE(tilted(), 0.0);
        click(Qt::Key_Up, Qt::AltModifier | Qt::ShiftModifier);
        QVERIFY(tilted() > 0.01);
        // From behind, the camera would see the back of the mirror, so the mirror is held from the other side.
        m_view->turnRound();
        const auto& mirror = *m_view->mirror();
        QVERIFY(glm::dot(mirror.normal, m_view->camera().eyeMm() - mirror.centreMm) > 0.0);
        // When put away and shown again, the mirror is at its initial place.
        m_view->setLeftHanded(false);
        m_view->turnRound();
        m_view->resetCamera();
        m_view->setSettings({});
        QVERIFY(!m_view->mirror());
        m_view->setSettings(settings);
        QVERIFY(moved(first) < 1e-6);
    }

    /// On a graphics card, a running bur turns even if nothing else moves. A software renderer shows a still picture
    /// with smooth edges.
    void aBurThatRunsIsSeenToTurn()
    {
        for (const ToothView::Way way : {ToothView::Way::Window, ToothView::Way::Image}) {
            UiChannels links;
            ToothView view(links, nullptr, way);
            view.resize(320, 240);
            view.setTooth(m_tooth, 1);
            view.show();
            QVERIFY(QTest::qWaitForWindowExposed(&view));
            links.servo.publish(burAt({0.0, 0.0, 1.0}));
            view.setDrillOn(true);
            if (way == ToothView::Way::Window) {
                QSignalSpy shown(&view, &ToothView::shown);
                QTRY_VERIFY(shown.count() > 12);
                ui::tooth::ViewSettings calm;
                calm.movesLittle = true;
                view.setSettings(calm);
            }
            QVERIFY(picturesUntilRest(view) >= 0);
        }
    }

    /// No event crashes the view.
    void isAnEmptyRoomWithoutATooth()
    {
        UiChannels links;
        ToothView view(links);
        view.resize(320, 240);
        view.show();
        QVERIFY(QTest::qWaitForWindowExposed(&view));
        QTest::mouseClick(&view, Qt::LeftButton, {}, {160, 120});
        QTest::keyClick(&view, Qt::Key_Left);
        QVERIFY(links.patches.tryPush(pictures::cutTile(*m_tooth, {0.0, 0.0}, -4.0F)));
        QVERIFY(pictures::mean(view.picture(), view.rect()).brightness() < 90.0);
    }

    void theToothIsTurnedUnderTheHandpiece()
    {
        m_links->servo.publish(burAt({0.5, 0.5, 1.0}));
        look(0.0, 30.0, 2.0);
        const QImage before = picture();
        const auto differing = [&] { return pictures::difference(before, picture(), 20).pixels; };
        const glm::dmat4 eye = m_view->camera().view();
        for (int k = 0; k < 12; ++k)
            click(Qt::Key_Right, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(m_view->camera().view() == eye);
        QVERIFY(differing() > 3000);
        // With the same mouse motion in the opposite direction the view is as at first.
        const QPoint from(m_view->width() / 2, m_view->height() - 30);
        drag(Qt::RightButton, from, from + QPoint(qRound(-60.0 / 0.35), 0), Qt::ShiftModifier);
        QVERIFY(m_view->camera().view() == eye);
        QVERIFY(differing() < 800);
        click(Qt::Key_Left, Qt::ControlModifier | Qt::ShiftModifier);
        click(Qt::Key_Home);
        look(0.0, 30.0, 2.0);
        QVERIFY(differing() < 100);
    }

    /// Marks and tooth are flipped together: a mark is where the flipped picture shows its place.
    void marksLieOnThePictureHoweverItIsTurnedOver()
    {
        ui::tooth::ExerciseMarks marks;
        marks.points = {{{2.6, 1.4}, 0.6, true}};
        const auto middleOfMark = [&](bool flips) {
            ui::tooth::ViewSettings settings;
            settings.presentation.flipLeftRight = settings.presentation.flipUpDown = flips;
            m_view->setSettings(settings);
            m_view->setExercise({});
            const QImage without = picture();
            m_view->setExercise(marks);
            const QImage with = picture();
            return pictures::difference(without.mirrored(flips, flips), with.mirrored(flips, flips)).box.center();
        };
        const QPoint plain = middleOfMark(false);
        QVERIFY((plain - pixelOf({2.6, 1.4, -1.5})).manhattanLength() < 30);
        QVERIFY((middleOfMark(true) - plain).manhattanLength() < 3);
    }

private:
    static constexpr glm::dvec2 kCusp{-2.6, -2.6};

    /// Turns the wheel over the middle of the view.
    void wheel(int notches, Qt::KeyboardModifiers keys)
    {
        QWheelEvent event({300, 200}, m_view->mapToGlobal(QPointF(300, 200)), {}, {0, 120 * notches}, Qt::NoButton,
                          keys, Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(m_view.get(), &event);
    }

    [[nodiscard]] PointerInput pointer() { return m_links->pointer.latest(); }

    [[nodiscard]] QPoint pixelOf(glm::dvec3 pointMm) const
    {
        const glm::dvec2 pixel = m_view->camera().pixelOf(pointMm);
        return {qRound(pixel.x), qRound(pixel.y)};
    }

    void look(double azimuthDeg, double elevationDeg, double distances = 1.0)
    {
        m_view->setCamera(azimuthDeg, elevationDeg, distances * m_view->camera().fittingMm());
    }

    void click(Qt::Key key, Qt::KeyboardModifiers with = {}) { QTest::keyClick(m_view.get(), key, with); }

    void move(QPoint to, Qt::MouseButtons buttons = Qt::NoButton, Qt::KeyboardModifiers with = {})
    {
        QMouseEvent event(QEvent::MouseMove, QPointF(to), m_view->mapToGlobal(QPointF(to)), Qt::NoButton, buttons,
                          with);
        QCoreApplication::sendEvent(m_view.get(), &event);
    }

    void drag(Qt::MouseButton button, QPoint from, QPoint to, Qt::KeyboardModifiers with = {})
    {
        QTest::mousePress(m_view.get(), button, with, from);
        move(to, button, with);
        QTest::mouseRelease(m_view.get(), button, with, to);
    }

    QImage picture()
    {
        const QImage image = m_view->picture();
        pictures::keep(image, QStringLiteral("view_") + QTest::currentTestFunction());
        return image;
    }

    [[nodiscard]] static ServoState burAt(glm::dvec3 anchorMm)
    {
        ServoState state;
        state.tick = 1;
        state.anchorMm = anchorMm;
        return state;
    }

    [[nodiscard]] bool framesPass(int count)
    {
        QSignalSpy frames(m_view.get(), &ToothView::frameAdvanced);
        return QTest::qWaitFor([&] { return frames.count() >= count; });
    }

    /// Returns whether the bur does not move during some frames.
    [[nodiscard]] bool burRests(int frames)
    {
        const glm::dvec2 rest = pointer().targetMm;
        return framesPass(frames) && pointer().targetMm == rest;
    }

    /// Returns the number of pictures until no new one is painted for a while; -1 if they do not end.
    static int picturesUntilRest(ToothView& view)
    {
        // A software driver paints once more with smooth edges, 120 ms after the last change.
        constexpr int kRestMs = 250;
        int pictures = 0;
        int quietFrames = 0;
        QElapsedTimer since;
        since.start();
        const QObject context;
        connect(&view, &ToothView::shown, &context, [&] {
            ++pictures;
            quietFrames = 0;
            since.start();
        });
        // No frame passes while a picture is being painted, however long that takes.
        connect(&view, &ToothView::frameAdvanced, &context, [&] { quietFrames += since.hasExpired(kRestMs) ? 1 : 0; });
        return QTest::qWaitFor([&] { return quietFrames >= 3; }, 20000) ? pictures : -1;
    }

    std::uint64_t m_generation = 0;
    std::shared_ptr<const ToothAnatomy> m_tooth;
    std::unique_ptr<UiChannels> m_links;
    std::unique_ptr<ToothView> m_view;
};

QTEST_MAIN(TestToothView)
#include "tst_tooth_view.moc"
