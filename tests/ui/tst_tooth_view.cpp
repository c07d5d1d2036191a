// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <memory>

#include <glm/geometric.hpp>

#include <QElapsedTimer>
#include <QMouseEvent>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>

#include "tests/support/SyntheticMolar.h"
#include "tests/ui/Pictures.h"
#include "ui/tooth/ToothView.h"

using core::session::PointerInput;
using core::session::ServoState;
using core::session::UiLinks;
using core::terrain::ToothAnatomy;
using ui::tooth::Camera;
using ui::tooth::PointerControl;
using ui::tooth::ToothView;

class TestToothView : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase();
    void init();
    void cleanupTestCase();
    void showsTheToothItIsGiven();
    void appliesAGroupOfPatchesOnlyWhole();
    void ignoresPatchesOfAnotherTooth();
    void showsTheBurWhereTheServoHoldsIt();
    void withLessMotionTheHandpieceIsLiftedAtOnce();
    void reportsEveryFrameWithTheNewestState();
    void paintsOnlyWhenSomethingShows();
    void mouseMovesTheBurAndItsButtonPushes();
    void pecksAreNoDoubleClick();
    void rightDragTurnsTheViewAndLeavesTheBur();
    void wheelZoomsAndWithControlSetsTheForce();
    void doubleClickResetsTheView();
    void arrowsMoveTheBurInScreenDirections();
    void heldArrowGathersSpeedAndShiftIsFine();
    void pageKeysPushAndLift();
    void losingTheFocusLetsGo();
    void aClickFromBelowDoesNotDrill();
    void theToothAloneIsDrawnWithoutTheInstrument();
    void theOtherHandKeepsTheToothAsItIsSeen();
    void theMirrorIsTheUsersToPlace();
    void aBurThatRunsIsSeenToTurn();
    void isAnEmptyRoomWithoutATooth();
    void theToothIsTurnedUnderTheHandpiece();
    void marksLieOnThePictureHoweverItIsTurnedOver();

private:
    [[nodiscard]] PointerInput pointer() { return m_links->pointer.latest(); }
    [[nodiscard]] QPoint pixelOf(glm::dvec3 pointMm) const
    {
        const glm::dvec2 pixel = m_view->camera().pixelOf(pointMm);
        return {qRound(pixel.x), qRound(pixel.y)};
    }
    void move(QPoint to, Qt::MouseButtons buttons = Qt::NoButton);
    QImage picture();
    void publish(glm::dvec3 anchorMm);
    /// Pictures shown until none has come for a while; -1: they do not end.
    static int picturesUntilRest(ToothView& view);

    std::uint64_t m_generation = 0;
    std::shared_ptr<const ToothAnatomy> m_tooth;
    std::unique_ptr<UiLinks> m_links;
    std::unique_ptr<ToothView> m_view;
};

void TestToothView::initTestCase()
{
    m_tooth = support::syntheticMolar();
    m_links = std::make_unique<UiLinks>();
    m_view = std::make_unique<ToothView>(*m_links);
    QVERIFY(m_view->isUsable());
    m_view->resize(640, 480);
    m_view->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_view.get()));
    m_view->activateWindow();
}

/// The view as it begins, with a whole tooth.
void TestToothView::init()
{
    m_links->servo.publish({});
    m_view->release();
    m_view->setSettings({});
    m_view->setLeftHanded(false);
    m_view->setDrillOn(false);
    if (m_view->pushForce() != PointerControl::kFirstN)
        m_view->setPushForce(PointerControl::kFirstN);
    m_view->setTooth(m_tooth, m_generation += 10);
    QTest::keyClick(m_view.get(), Qt::Key_Home);
    m_view->setFocus();
    move(m_view->rect().center());
}

void TestToothView::cleanupTestCase()
{
    m_view.reset();
    m_links.reset();
}

void TestToothView::publish(glm::dvec3 anchorMm)
{
    ServoState state;
    state.tick = 1;
    state.anchorMm = anchorMm;
    m_links->servo.publish(state);
}

int TestToothView::picturesUntilRest(ToothView& view)
{
    // A software driver paints once more with smooth edges, 120 ms after the last change.
    constexpr int kRestMs = 250;
    QSignalSpy shown(&view, &ToothView::shown);
    QSignalSpy frames(&view, &ToothView::frameAdvanced);
    QElapsedTimer since;
    since.start();
    const QObject context;
    connect(&view, &ToothView::shown, &context, [&] {
        frames.clear();
        since.start();
    });
    const bool rests = QTest::qWaitFor([&] { return frames.count() >= 10 && since.hasExpired(kRestMs); }, 20000);
    return rests ? static_cast<int>(shown.count()) : -1;
}

void TestToothView::move(QPoint to, Qt::MouseButtons buttons)
{
    QMouseEvent event(QEvent::MouseMove, QPointF(to), m_view->mapToGlobal(QPointF(to)), Qt::NoButton, buttons,
                      Qt::NoModifier);
    QCoreApplication::sendEvent(m_view.get(), &event);
}

QImage TestToothView::picture()
{
    const QImage image = m_view->picture();
    pictures::keep(image, QStringLiteral("view_") + QTest::currentTestFunction());
    return image;
}

void TestToothView::showsTheToothItIsGiven()
{
    const QImage image = picture();
    QCOMPARE(image.size(), m_view->size() * m_view->devicePixelRatioF());
    const QPoint cusp = pixelOf({-2.6, -2.6, -0.8});
    QVERIFY(pictures::mean(image, pictures::around(cusp.x(), cusp.y(), 4)).brightness() > 140.0);
    QVERIFY(pictures::mean(image, QRect(0, 0, 30, 30)).brightness() < 70.0);
}

void TestToothView::appliesAGroupOfPatchesOnlyWhole()
{
    const QImage before = picture();
    const glm::dvec2 place = pictures::tileMiddle(m_tooth->grid, {1.8, 1.0});
    QVERIFY(m_links->patches.tryPush(pictures::cutTile(*m_tooth, place, -4.0F, m_generation, false)));
    QCOMPARE(pictures::difference(before, picture(), 2).pixels, 0);
    QVERIFY(m_links->patches.tryPush(pictures::cutTile(*m_tooth, {-1.6, 0.4}, -4.0F, m_generation, true)));
    const QImage after = picture();
    QVERIFY(pictures::difference(before, after, 12).pixels > 400);
    const QPoint pixel = pixelOf({place, -4.0});
    QVERIFY(pictures::difference(before.copy(pictures::around(pixel.x(), pixel.y(), 5)),
                                 after.copy(pictures::around(pixel.x(), pixel.y(), 5)), 12)
                .pixels > 0);
}

void TestToothView::ignoresPatchesOfAnotherTooth()
{
    const QImage before = picture();
    for (const std::uint64_t other : {m_generation - 1, m_generation + 1})
        QVERIFY(m_links->patches.tryPush(pictures::cutTile(*m_tooth, {1.8, 1.0}, -4.0F, other)));
    QCOMPARE(pictures::difference(before, picture(), 2).pixels, 0);
    // The tooth that the session already cuts comes to the view with its cuts.
    m_view->setTooth(m_tooth, m_generation + 1);
    QVERIFY(pictures::difference(before, picture(), 12).pixels > 300);
}

void TestToothView::showsTheBurWhereTheServoHoldsIt()
{
    const QImage before = picture();
    ServoState state;
    state.tick = 1;
    state.anchorMm = {-2.6, -2.6, 0.2};
    state.deviceMm = {-2.6, -2.6, -5.0};  // the hand is deep inside: it must not matter
    m_links->servo.publish(state);
    const QImage after = picture();
    const QPoint neck = pixelOf({-2.6, -2.6, 1.2});
    QVERIFY(pictures::differs(before.pixel(neck), after.pixel(neck), 15));
    publish({3.0, 2.0, 1.0});
    const QImage moved = picture();
    QVERIFY(!pictures::differs(before.pixel(neck), moved.pixel(neck), 15));
    const QPoint there = pixelOf({3.0, 2.0, 2.0});
    QVERIFY(pictures::differs(before.pixel(there), moved.pixel(there), 15));
}

void TestToothView::withLessMotionTheHandpieceIsLiftedAtOnce()
{
    // Deep in the tooth, where the shank is drawn longer; another bur at the same place wants another length.
    const auto stillMoves = [&](std::uint8_t bur) {
        ServoState state;
        state.tick = 1;
        state.anchorMm = {-2.6, -2.6, -7.0};
        state.burIndex = bur;
        m_links->servo.publish(state);
        QImage first;
        const auto once = connect(m_view.get(), &ToothView::frameAdvanced, this, [&] {
            if (first.isNull())
                first = m_view->picture();
        });
        const bool came = QTest::qWaitFor([&] { return !first.isNull(); }, 5000) && picturesUntilRest(*m_view) >= 0;
        disconnect(once);
        return came ? pictures::difference(first, picture(), 8).pixels : -1;
    };
    QVERIFY(stillMoves(3) >= 0);
    const int gliding = stillMoves(0);
    QVERIFY2(gliding > 100, qPrintable(QString::number(gliding)));
    ui::tooth::ViewSettings calm;
    calm.movesLittle = true;
    m_view->setSettings(calm);
    QVERIFY(picturesUntilRest(*m_view) >= 0);
    QCOMPARE(stillMoves(3), 0);
    QCOMPARE(stillMoves(0), 0);
}

void TestToothView::reportsEveryFrameWithTheNewestState()
{
    QSignalSpy frames(m_view.get(), &ToothView::frameAdvanced);
    std::uint64_t tick = 0;
    const QObject context;
    connect(m_view.get(), &ToothView::frameAdvanced, &context, [&tick](const ServoState& state) { tick = state.tick; });
    ServoState state;
    state.tick = 17;
    m_links->servo.publish(state);
    state.tick = 18;
    m_links->servo.publish(state);
    QTRY_COMPARE(tick, std::uint64_t{18});
    QTRY_VERIFY(frames.count() >= 3);
}

void TestToothView::paintsOnlyWhenSomethingShows()
{
    ServoState state;
    state.tick = 1;
    m_links->servo.publish(state);
    QVERIFY(picturesUntilRest(*m_view) > 0);
    state.tick = 500;  // time goes on, nothing moves
    m_links->servo.publish(state);
    QCOMPARE(picturesUntilRest(*m_view), 0);
    state.anchorMm.x += 0.5;
    m_links->servo.publish(state);
    QVERIFY(picturesUntilRest(*m_view) > 0);
}

void TestToothView::mouseMovesTheBurAndItsButtonPushes()
{
    m_view->setCamera(0.0, 88.0, m_view->camera().fittingMm());
    const glm::dvec2 wanted(-1.5, 2.0);
    const QPoint at = pixelOf({wanted, -2.0});
    move(at);
    QVERIFY(glm::distance(pointer().targetMm, wanted) < 0.15);
    QVERIFY(!pointer().pushing);
    QVERIFY(pointer().hoverMm > -3.3);
    QTest::mousePress(m_view.get(), Qt::LeftButton, {}, at);
    QVERIFY(pointer().pushing);
    QCOMPARE(pointer().pushForceN, PointerControl::kFirstN);
    QTest::mouseRelease(m_view.get(), Qt::LeftButton, {}, at);
    QVERIFY(!pointer().pushing);
}

void TestToothView::pecksAreNoDoubleClick()
{
    m_view->setCamera(40.0, 60.0, m_view->camera().fittingMm());
    const QPoint at = pixelOf({0.0, 1.0, -2.5});
    QTest::mouseClick(m_view.get(), Qt::LeftButton, {}, at);
    QTest::mouseDClick(m_view.get(), Qt::LeftButton, {}, at);
    QCOMPARE(m_view->camera().azimuthDeg(), 40.0);
    QVERIFY(pointer().pushing);
    QTest::mouseRelease(m_view.get(), Qt::LeftButton, {}, at);
    QVERIFY(!pointer().pushing);
}

void TestToothView::rightDragTurnsTheViewAndLeavesTheBur()
{
    move({300, 240});
    const PointerInput before = pointer();
    for (const Qt::MouseButton button : {Qt::RightButton, Qt::MiddleButton}) {
        const double azimuth = m_view->camera().azimuthDeg();
        const double elevation = m_view->camera().elevationDeg();
        QTest::mousePress(m_view.get(), button, {}, {300, 240});
        move({340, 260}, button);
        QTest::mouseRelease(m_view.get(), button, {}, {340, 260});
        QVERIFY(m_view->camera().azimuthDeg() < azimuth - 5.0);
        QVERIFY(m_view->camera().elevationDeg() > elevation + 3.0);
    }
    QCOMPARE(pointer().targetMm.x, before.targetMm.x);
    QVERIFY(!pointer().pushing);
}

void TestToothView::wheelZoomsAndWithControlSetsTheForce()
{
    const auto wheel = [&](int notches, Qt::KeyboardModifiers keys) {
        QWheelEvent event({300, 200}, m_view->mapToGlobal(QPointF(300, 200)), {}, {0, 120 * notches}, Qt::NoButton,
                          keys, Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(m_view.get(), &event);
    };
    const double far = m_view->camera().distanceMm();
    wheel(2, Qt::NoModifier);
    QTRY_VERIFY(m_view->camera().distanceMm() < 0.9 * far);
    QSignalSpy changed(m_view.get(), &ToothView::pushForceChanged);
    wheel(3, Qt::ControlModifier);
    QVERIFY(std::abs(m_view->pushForce() - PointerControl::kFirstN - 0.3) < 1e-9);
    QVERIFY(std::abs(pointer().pushForceN - PointerControl::kFirstN - 0.3) < 1e-9);
    QCOMPARE(changed.count(), 1);
    wheel(-100, Qt::ControlModifier);
    QCOMPARE(m_view->pushForce(), PointerControl::kWeakestN);
    wheel(-1, Qt::ControlModifier);
    QCOMPARE(changed.count(), 2);
    QTest::keyClick(m_view.get(), Qt::Key_Period);
    QVERIFY(std::abs(m_view->pushForce() - 0.3) < 1e-9);
}

void TestToothView::doubleClickResetsTheView()
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

void TestToothView::arrowsMoveTheBurInScreenDirections()
{
    m_view->setCamera(90.0, 50.0, 40.0);  // the eye is at +x: right on the screen is +y
    const glm::dvec2 start = pointer().targetMm;
    QTest::keyClick(m_view.get(), Qt::Key_Right);
    QVERIFY(glm::distance(pointer().targetMm, start + glm::dvec2(0.0, 0.1)) < 1e-9);
    QTest::keyClick(m_view.get(), Qt::Key_Up);
    QVERIFY(glm::distance(pointer().targetMm, start + glm::dvec2(-0.1, 0.1)) < 1e-9);
    QTest::keyClick(m_view.get(), Qt::Key_Left, Qt::ShiftModifier);
    QVERIFY(glm::distance(pointer().targetMm, start + glm::dvec2(-0.1, 0.08)) < 1e-9);
    QTest::keyClick(m_view.get(), Qt::Key_Down);
    QVERIFY(glm::distance(pointer().targetMm, start + glm::dvec2(0.0, 0.08)) < 1e-9);
}

void TestToothView::heldArrowGathersSpeedAndShiftIsFine()
{
    const auto travelled = [&](Qt::KeyboardModifiers keys, double untilMm) {
        const glm::dvec2 start = pointer().targetMm;
        QElapsedTimer clock;
        clock.start();
        QTest::keyPress(m_view.get(), Qt::Key_Left, keys);
        const bool arrived = QTest::qWaitFor([&] { return glm::distance(pointer().targetMm, start) > untilMm; }, 20000);
        QTest::keyRelease(m_view.get(), Qt::Key_Left, keys);
        return arrived ? static_cast<double>(clock.elapsed()) / untilMm : 0.0;  // milliseconds for a millimetre
    };
    const double fine = travelled(Qt::ShiftModifier, 0.3);
    const double quick = travelled(Qt::NoModifier, 2.0);
    QVERIFY(quick > 0.0);
    QVERIFY(fine > 2.0 * quick);
    const glm::dvec2 rest = pointer().targetMm;
    QSignalSpy frames(m_view.get(), &ToothView::frameAdvanced);
    QTRY_VERIFY(frames.count() > 3);
    QCOMPARE(pointer().targetMm.x, rest.x);
}

void TestToothView::pageKeysPushAndLift()
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

void TestToothView::losingTheFocusLetsGo()
{
    QTest::keyPress(m_view.get(), Qt::Key_PageDown);
    QTest::keyPress(m_view.get(), Qt::Key_Right);
    QVERIFY(pointer().pushing);
    QFocusEvent out(QEvent::FocusOut);
    QCoreApplication::sendEvent(m_view.get(), &out);
    QVERIFY(!pointer().pushing);
    const glm::dvec2 rest = pointer().targetMm;
    QSignalSpy frames(m_view.get(), &ToothView::frameAdvanced);
    QTRY_VERIFY(frames.count() > 10);
    QCOMPARE(pointer().targetMm.x, rest.x);
}

void TestToothView::aClickFromBelowDoesNotDrill()
{
    m_view->setCamera(0.0, -45.0, m_view->camera().fittingMm());
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
    m_view->setCamera(0.0, 45.0, m_view->camera().fittingMm());
    QTest::mousePress(m_view.get(), Qt::LeftButton, {}, middle);
    QVERIFY(pointer().pushing);
    QCOMPARE(refused.size(), 2);
}

void TestToothView::theToothAloneIsDrawnWithoutTheInstrument()
{
    const QImage alone = picture();
    publish({0.0, 0.0, -1.0});
    QVERIFY(pictures::difference(alone, picture(), 20).pixels > 300);
    QCOMPARE(pictures::difference(alone, m_view->toothPicture(), 2).pixels, 0);
    QVERIFY(pictures::difference(alone, picture(), 20).pixels > 300);
}

void TestToothView::theOtherHandKeepsTheToothAsItIsSeen()
{
    m_view->setCamera(0.0, 60.0, m_view->camera().fittingMm());
    publish({0.0, 0.0, -1.0});
    const QPoint place = pixelOf({0.0, 0.0, -1.0});
    // What the handpiece hides, right and left of the bur.
    const auto hidden = [&] {
        const QImage alone = m_view->toothPicture();
        const QImage whole = picture();
        const int left = place.x() - 30;
        return std::pair(
            pictures::difference(alone.copy(0, 0, left, 480), whole.copy(0, 0, left, 480), 20).pixels,
            pictures::difference(alone.copy(place.x() + 30, 0, left, 480), whole.copy(place.x() + 30, 0, left, 480), 20)
                .pixels);
    };
    const auto [rightHandLeft, rightHandRight] = hidden();
    QVERIFY2(rightHandRight > 2000 && rightHandLeft < rightHandRight / 2,
             qPrintable(QString("%1 %2").arg(rightHandLeft).arg(rightHandRight)));
    m_view->setLeftHanded(true);
    QCOMPARE(pixelOf({0.0, 0.0, -1.0}), place);
    const auto [leftHandLeft, leftHandRight] = hidden();
    QVERIFY2(leftHandLeft > 2000 && leftHandRight < leftHandLeft / 2,
             qPrintable(QString("%1 %2").arg(leftHandLeft).arg(leftHandRight)));
    const glm::dvec2 start = pointer().targetMm;
    QTest::keyClick(m_view.get(), Qt::Key_Right);
    QVERIFY(pointer().targetMm.x > start.x);
}

void TestToothView::theMirrorIsTheUsersToPlace()
{
    ui::tooth::ViewSettings settings;
    settings.showsMirror = true;
    m_view->setSettings(settings);
    QVERIFY(m_view->mirror());
    const glm::dvec3 first = m_view->mirror()->centreMm;
    const auto onGlass = [this] { return pixelOf(m_view->mirror()->centreMm); };
    const auto away = [&] { return glm::distance(m_view->camera().eyeMm(), m_view->mirror()->centreMm); };
    // Its middle may be outside the view: what is held is a place on the glass that is not.
    QPoint grip = onGlass();
    grip.setX(std::clamp(grip.x(), 8, 631));
    grip.setY(std::clamp(grip.y(), 8, 471));
    QTest::mousePress(m_view.get(), Qt::LeftButton, {}, grip);
    QVERIFY(!pointer().pushing);
    move(grip + QPoint(10, 6), Qt::LeftButton);
    QTest::mouseRelease(m_view.get(), Qt::LeftButton, {}, grip + QPoint(10, 6));
    const glm::dvec3 placed = m_view->mirror()->centreMm;
    QVERIFY(glm::distance(placed, first) > 0.1);
    // Taking hold twice is no double click that throws the view back, and another hand leaves it where it is.
    m_view->setCamera(m_view->camera().azimuthDeg() + 7.0, m_view->camera().elevationDeg(),
                      m_view->camera().distanceMm());
    grip = onGlass();
    grip.setX(std::clamp(grip.x(), 8, 631));
    grip.setY(std::clamp(grip.y(), 8, 471));
    const double azimuth = m_view->camera().azimuthDeg();
    QTest::mouseDClick(m_view.get(), Qt::LeftButton, {}, grip);
    QTest::mouseRelease(m_view.get(), Qt::LeftButton, {}, grip);
    QCOMPARE(m_view->camera().azimuthDeg(), azimuth);
    m_view->setLeftHanded(true);
    m_view->resetCamera();
    QCOMPARE(glm::distance(m_view->mirror()->centreMm, placed), 0.0);
    // To and fro, moved and tilted by keys.
    const double before = away();
    QTest::keyClick(m_view.get(), Qt::Key_PageUp, Qt::AltModifier);
    QVERIFY(std::abs(away() - (before - 1.0)) < 1e-6);
    QTest::keyClick(m_view.get(), Qt::Key_PageDown, Qt::AltModifier);
    QVERIFY(std::abs(away() - before) < 1e-6);
    const glm::dvec3 normal = m_view->mirror()->normal;
    QTest::keyClick(m_view.get(), Qt::Key_Left, Qt::AltModifier);
    QVERIFY(glm::distance(m_view->mirror()->centreMm, placed) > 0.05);
    QCOMPARE(glm::distance(m_view->mirror()->normal, normal), 0.0);
    QTest::keyClick(m_view.get(), Qt::Key_Up, Qt::AltModifier | Qt::ShiftModifier);
    QVERIFY(glm::distance(m_view->mirror()->normal, normal) > 0.01);
    // From behind, its back would be seen: it is taken in hand anew.
    m_view->turnRound();
    const auto& mirror = *m_view->mirror();
    QVERIFY(glm::dot(mirror.normal, m_view->camera().eyeMm() - mirror.centreMm) > 0.0);
    // Put away and taken again it is where it is held first.
    m_view->setLeftHanded(false);
    m_view->turnRound();
    m_view->resetCamera();
    m_view->setSettings({});
    QVERIFY(!m_view->mirror());
    m_view->setSettings(settings);
    QVERIFY(glm::distance(m_view->mirror()->centreMm, first) < 1e-6);
}

void TestToothView::aBurThatRunsIsSeenToTurn()
{
    ServoState state;
    state.tick = 1;
    state.anchorMm = {0.0, 0.0, 1.0};
    for (const ToothView::Way way : {ToothView::Way::Window, ToothView::Way::Image}) {
        UiLinks links;
        ToothView view(links, nullptr, way);
        view.resize(320, 240);
        view.setTooth(m_tooth, 1);
        view.show();
        QVERIFY(QTest::qWaitForWindowExposed(&view));
        links.servo.publish(state);
        QVERIFY(picturesUntilRest(view) > 0);
        // For a graphics card nothing else need move. A software driver rests, with smooth edges.
        view.setDrillOn(true);
        if (way == ToothView::Way::Window) {
            QSignalSpy shown(&view, &ToothView::shown);
            QTRY_VERIFY(shown.count() > 4);
        } else {
            QVERIFY(picturesUntilRest(view) >= 0);
        }
        ui::tooth::ViewSettings settings;
        settings.movesLittle = true;
        view.setSettings(settings);
        QVERIFY(picturesUntilRest(view) >= 0);
    }
}

void TestToothView::isAnEmptyRoomWithoutATooth()
{
    // The empty room, and every event is survived.
    UiLinks links;
    ToothView view(links);
    view.resize(320, 240);
    view.show();
    QVERIFY(QTest::qWaitForWindowExposed(&view));
    QTest::mouseClick(&view, Qt::LeftButton, {}, {160, 120});
    QTest::keyClick(&view, Qt::Key_Left);
    QVERIFY(links.patches.tryPush(pictures::cutTile(*m_tooth, {0.0, 0.0}, -4.0F)));
    QVERIFY(pictures::mean(view.picture(), view.rect()).brightness() < 90.0);
}

void TestToothView::theToothIsTurnedUnderTheHandpiece()
{
    publish({0.5, 0.5, 1.0});
    m_view->setCamera(0.0, 30.0, 2.0 * m_view->camera().fittingMm());
    const QImage before = picture();
    const glm::dmat4 eye = m_view->camera().view();
    for (int k = 0; k < 12; ++k)
        QTest::keyClick(m_view.get(), Qt::Key_Right, Qt::ControlModifier | Qt::ShiftModifier);
    const QImage turned = picture();
    QVERIFY(m_view->camera().view() == eye);
    const int moved = pictures::difference(before, turned, 20).pixels;
    QVERIFY2(moved > 3000, qPrintable(QString::number(moved)));
    // With the mouse as far the other way: what it began with.
    const QPoint from(m_view->width() / 2, m_view->height() - 30);
    const int way = qRound(-60.0 / 0.35);
    QTest::mousePress(m_view.get(), Qt::RightButton, Qt::ShiftModifier, from);
    QMouseEvent move(QEvent::MouseMove, QPointF(from + QPoint(way, 0)),
                     m_view->mapToGlobal(QPointF(from + QPoint(way, 0))), Qt::NoButton, Qt::RightButton,
                     Qt::ShiftModifier);
    QApplication::sendEvent(m_view.get(), &move);
    QTest::mouseRelease(m_view.get(), Qt::RightButton, Qt::ShiftModifier, from + QPoint(way, 0));
    QVERIFY(m_view->camera().view() == eye);
    QVERIFY(pictures::difference(before, picture(), 20).pixels < 800);
    QTest::keyClick(m_view.get(), Qt::Key_Left, Qt::ControlModifier | Qt::ShiftModifier);
    QTest::keyClick(m_view.get(), Qt::Key_Home);
    m_view->setCamera(0.0, 30.0, 2.0 * m_view->camera().fittingMm());
    QVERIFY(pictures::difference(before, picture(), 20).pixels < 100);
}

/// Mark and tooth are one picture: a mark is where the picture turned over has it.
void TestToothView::marksLieOnThePictureHoweverItIsTurnedOver()
{
    ui::tooth::ExerciseMarks marks;
    marks.points = {{{2.6, 1.4}, 0.6, true}};
    m_view->setExercise(marks);
    const QImage plain = picture();
    ui::tooth::ViewSettings settings;
    settings.presentation.flipLeftRight = true;
    settings.presentation.flipUpDown = true;
    m_view->setSettings(settings);
    const QImage turned = picture().mirrored(true, true);
    // What a touched point is filled with.
    const auto middleOfMark = [](const QImage& image) {
        QPointF sum;
        int count = 0;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x)
                if (const QRgb p = image.pixel(x, y); qGreen(p) - qRed(p) > 90 && qBlue(p) - qRed(p) > 90) {
                    sum += QPointF(x, y);
                    ++count;
                }
        return count > 40 ? sum / count : QPointF(-1000.0, -1000.0);
    };
    const QPointF wanted = middleOfMark(plain);
    QVERIFY(QRectF(plain.rect()).contains(wanted));
    QVERIFY((middleOfMark(turned) - wanted).manhattanLength() < 3.0);
}

QTEST_MAIN(TestToothView)
#include "tst_tooth_view.moc"
