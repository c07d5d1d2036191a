// SPDX-License-Identifier: GPL-3.0-or-later
// Input of the tooth view: mouse, fingers, pen, wheel, keys and gamepad.
#include "ui/tooth/ToothView.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <QKeyEvent>
#include <QMouseEvent>
#include <QTabletEvent>
#include <QTouchEvent>
#include <QWheelEvent>

#include "ui/tooth/Viewpoint.h"

namespace ui::tooth {
namespace {

constexpr double kDegreesPerPixel = 0.35;
constexpr double kKeyTurnDeg = 5.0;
constexpr double kTiltPerPixel = 0.006;    ///< rotation of the mirror's normal, rad
constexpr double kMirrorStepMm = 1.0;      ///< move for one notch of the wheel
constexpr double kMirrorStepPx = 12.0;     ///< move for one key press
constexpr double kNearestMirrorMm = 12.0;  ///< least distance between mirror and eye

// Arrow keys move the bur one step at once, then at a speed that grows while the key is held.
constexpr double kKeyStepMm = 0.1;
constexpr double kFineStepMm = 0.02;
constexpr double kSlowestMmPerS = 1.0;
constexpr double kFastestMmPerS = 7.0;
constexpr double kFineMmPerS = 0.4;
constexpr double kSpeedUpAfterS = 0.2;
constexpr double kSpeedUpForS = 0.8;

// Rates of a gamepad's stick at full deflection.
constexpr double kPadMmPerS = 6.0;
constexpr double kPadDegPerS = 100.0;
constexpr double kLeastPressure = 0.05;

bool isArrow(int key)
{
    return key == Qt::Key_Left || key == Qt::Key_Right || key == Qt::Key_Up || key == Qt::Key_Down;
}

/// Returns the direction of an arrow key on the screen: x to the right, y downwards.
QPointF wayOf(int key)
{
    return {key == Qt::Key_Right  ? 1.0
            : key == Qt::Key_Left ? -1.0
                                  : 0.0,
            key == Qt::Key_Down ? 1.0
            : key == Qt::Key_Up ? -1.0
                                : 0.0};
}

}  // namespace

void ToothView::setButtonDown(bool down)
{
    m_buttonIsDown = down;
    updatePressed();
}

void ToothView::updatePressed()
{
    const bool isPressed = m_buttonIsDown || m_control.isPushing();
    if (std::exchange(m_isPressed, isPressed) != isPressed)
        emit pressedChanged(isPressed);
}

void ToothView::turnCamera(double azimuthDeg, double elevationDeg)
{
    m_camera.turn(azimuthDeg, elevationDeg);
    m_control.forgetRay();
    redrawMoving();
}

void ToothView::turnHandpiece(double degrees)
{
    m_handTurnDeg = std::remainder(m_handTurnDeg + degrees, 360.0);
    redraw();
}

/// Returns whether the mirror's glass is visible at a position, with no tooth in front of it.
bool ToothView::isOnMirror(QPointF position) const
{
    if (!m_mirror)
        return false;
    const render::Ray ray = rayAt(position);
    const double falls = glm::dot(ray.direction, m_mirror->normal);
    if (falls > -1.0e-3)
        return false;
    const double along = glm::dot(m_mirror->centreMm - ray.originMm, m_mirror->normal) / falls;
    const glm::dvec3 hit = ray.originMm + ray.direction * along;
    const auto met = m_surface ? m_surface->meetTooth(ray) : std::nullopt;
    const bool behindTooth = met && glm::dot(*met - ray.originMm, ray.direction) < along;
    return !behindTooth && glm::distance(hit, m_mirror->centreMm) < render::DentalMirror::kRadiusMm;
}

/// Moves the mirror by a number of pixels at its distance from the eye. If `tilts` is set, turns it instead: sideways
/// about the picture's vertical axis, up and down about the horizontal one.
void ToothView::dragMirror(QPointF by, bool tilts)
{
    m_mirrorIsPlaced = true;
    const glm::dmat4 toothFromEye = glm::inverse(m_camera.view());
    const glm::dvec3 right(toothFromEye[0]);
    const glm::dvec3 up(toothFromEye[1]);
    if (tilts) {
        const glm::dvec3 turned = m_mirror->normal + (right * by.x() - up * by.y()) * kTiltPerPixel;
        // The back of the mirror shows nothing.
        if (glm::dot(turned, m_camera.eyeMm() - m_mirror->centreMm) > 0.0)
            m_mirror->normal = glm::normalize(turned);
    } else {
        const double mmPerPixel =
            glm::distance(m_camera.eyeMm(), m_mirror->centreMm) * 2.0 / (m_camera.projection()[1][1] * height());
        m_mirror->centreMm += (right * by.x() - up * by.y()) * mmPerPixel;
    }
    redraw();
}

/// Moves the mirror away from the eye, or towards it if `millimetres` is negative.
void ToothView::pushMirror(double millimetres)
{
    const glm::dvec3 away = m_mirror->centreMm - m_camera.eyeMm();
    const double far = glm::length(away);
    const double wanted = std::clamp(far + millimetres, kNearestMirrorMm, 2.0 * m_camera.distanceMm());
    m_mirror->centreMm = m_camera.eyeMm() + away * (wanted / far);
    m_mirrorIsPlaced = true;
    redraw();
}

void ToothView::push(PointerKind kind)
{
    m_pushedWith = kind;
    m_control.push(true);
}

/// Presses the bur at a position. Emits pushRefused() if the eye is below the tooth, because the bur is then on its far
/// side.
void ToothView::pushAt(QPointF position, PointerKind kind)
{
    pointAt(position);
    const render::Ray ray = rayAt(position);
    if (ray.direction.z >= 0.0) {
        emit pushRefused();
        return;
    }
    push(kind);
    m_control.moveTo(ray, m_servo.anchorMm);
}

void ToothView::mousePressEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton)
        setButtonDown(true);
    if (const auto end = gizmoEndAt(event->position()); end && event->button() == Qt::LeftButton) {
        lookFromEnd(m_camera, *end, m_surface->anatomy().lying);
        redrawMoving();
    } else if (event->button() == Qt::LeftButton && isOnMirror(event->position())) {
        m_mirrorHeld = true;
        m_turnedAt = event->position();
    } else if (event->button() == Qt::LeftButton) {
        pushAt(event->position(), PointerKind::Mouse);
        publishPointer();
    } else if (m_turning == Qt::NoButton &&
               (event->button() == Qt::RightButton || event->button() == Qt::MiddleButton)) {
        m_turning = event->button();
        m_turnedAt = event->position();
    } else {
        SceneWidget::mousePressEvent(event);
    }
}

bool ToothView::event(QEvent* event)
{
    switch (event->type()) {
    case QEvent::TouchBegin:
    case QEvent::TouchUpdate:
    case QEvent::TouchEnd:
    case QEvent::TouchCancel:
        // Qt turns touch events that are not accepted into mouse events, and a finger that turns the view would drill.
        touch(*static_cast<QTouchEvent*>(event));
        event->accept();
        return true;
    default:
        return SceneWidget::event(event);
    }
}

void ToothView::touch(const QTouchEvent& event)
{
    if (event.type() == QEvent::TouchEnd || event.type() == QEvent::TouchCancel) {
        m_gesture.end();
        return;
    }
    QList<QPointF> fingers;
    for (const QEventPoint& point : event.points())
        if (point.state() != QEventPoint::Released)
            fingers << point.position();
    const TouchGesture::Step step = m_gesture.move(fingers);
    if (!step.turnPx.isNull()) {
        const QPointF by = presentedWay(step.turnPx);
        turnCamera(-kDegreesPerPixel * by.x(), kDegreesPerPixel * by.y());
    }
    if (step.zoom != 1.0) {
        m_camera.zoomBy(step.zoom, m_surface ? m_surface->meetTooth(rayAt(step.middlePx)) : std::nullopt);
        m_control.forgetRay();
        redraw();
    }
}

/// Sets the position of the pointer. Redraws if depths are shown, because the depth under the pointer is displayed.
void ToothView::pointAt(QPointF position)
{
    m_pointer = position;
    m_pointerHasLeft = false;
    m_pointerAims = true;
    if (m_settings.look.depthColours != render::DepthColours::Off)
        redraw();
}

/// Stops displaying the depth under the pointer.
void ToothView::leaveEvent(QEvent* event)
{
    m_pointerHasLeft = true;
    if (m_settings.look.depthColours != render::DepthColours::Off)
        redraw();
    SceneWidget::leaveEvent(event);
}

void ToothView::mouseMoveEvent(QMouseEvent* event)
{
    pointAt(event->position());
    // The button may have been released over another window.
    if (!event->buttons().testFlag(Qt::LeftButton))
        setButtonDown(false);
    if (m_mirrorHeld && m_mirror) {
        dragMirror(presentedWay(event->position() - m_turnedAt), event->modifiers().testFlag(Qt::ShiftModifier));
        m_turnedAt = event->position();
        return;
    }
    if (m_turning != Qt::NoButton) {
        const QPointF by = presentedWay(event->position() - m_turnedAt);
        m_turnedAt = event->position();
        if (event->modifiers().testFlag(Qt::ShiftModifier))
            turnHandpiece(kDegreesPerPixel * by.x());
        else
            turnCamera(-kDegreesPerPixel * by.x(), kDegreesPerPixel * by.y());
        return;
    }
    m_control.moveTo(rayAt(event->position()), m_servo.anchorMm);
    publishPointer();
}

void ToothView::mouseReleaseEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton) {
        m_mirrorHeld = false;
        m_buttonIsDown = false;
        m_control.push(false);
        publishPointer();
    }
    if (event->button() == m_turning)
        m_turning = Qt::NoButton;
}

void ToothView::mouseDoubleClickEvent(QMouseEvent* event)
{
    // Two quick presses of the bur on the tooth are not a double click; nor are two quick presses on the mirror.
    if (event->button() == Qt::LeftButton &&
        (isOnMirror(event->position()) || m_control.meetsTooth(rayAt(event->position()))))
        mousePressEvent(event);
    else
        resetCamera();
}

void ToothView::wheelEvent(QWheelEvent* event)
{
    const double notches = event->angleDelta().y() / 120.0;
    if (event->modifiers().testFlag(Qt::ControlModifier)) {
        setPushForce(m_control.forceN() + PointerControl::kStepN * notches);
    } else if (m_control.isPushing() || event->modifiers().testFlag(Qt::ShiftModifier)) {
        // Turning the wheel towards the user lowers the stop.
        moveStop(PointerControl::kStepMm * -notches);
    } else if (isOnMirror(event->position())) {
        pushMirror(-kMirrorStepMm * notches);
    } else {
        m_camera.zoom(notches, m_surface ? m_surface->meetTooth(rayAt(event->position())) : std::nullopt);
        m_control.forgetRay();
        redraw();
    }
    event->accept();
}

void ToothView::tabletEvent(QTabletEvent* event)
{
    const bool isTip = event->button() == Qt::LeftButton;
    if (event->type() == QEvent::TabletPress && isTip)
        m_penIsMouse = isOnMirror(event->position()) || gizmoEndAt(event->position()).has_value();
    const bool isMouse = m_penIsMouse;
    if (event->type() == QEvent::TabletRelease && isTip)
        m_penIsMouse = false;
    if (event->type() == QEvent::TabletPress && isTip && !isMouse) {
        m_buttonIsDown = true;
        pushAt(event->position(), PointerKind::Pen);
    } else if (event->type() == QEvent::TabletRelease && isTip && !isMouse) {
        m_buttonIsDown = false;
        m_control.push(false);
    } else if (event->type() == QEvent::TabletMove && m_turning == Qt::NoButton && event->buttons() <= Qt::LeftButton &&
               !isMouse) {
        pointAt(event->position());
        m_control.moveTo(rayAt(event->position()), m_servo.anchorMm);
    } else {
        // Not accepted, so that Qt makes a mouse event of it, as it does for the buttons on the pen.
        event->ignore();
        return;
    }
    if (event->buttons().testFlag(Qt::LeftButton))
        m_control.setPressure(m_pen.shareAt(event->pressure()));
    publishPointer();
    event->accept();
}

void ToothView::keyPressEvent(QKeyEvent* event)
{
    m_fine = event->modifiers().testFlag(Qt::ShiftModifier);
    const int key = event->key();
    const bool isPage = key == Qt::Key_PageDown || key == Qt::Key_PageUp;
    if (event->modifiers().testFlag(Qt::AltModifier) && (isArrow(key) || isPage)) {
        moveMirrorByKey(key);
        return;
    }
    if (isArrow(key)) {
        pressArrow(*event);
        return;
    }
    switch (key) {
    case Qt::Key_PageDown:
        if (!event->isAutoRepeat()) {
            if (m_camera.elevationDeg() > 0.0)
                push(PointerKind::Keyboard);
            else
                emit pushRefused();
        }
        publishPointer();
        break;
    case Qt::Key_PageUp:
        m_control.lift(true);
        publishPointer();
        break;
    case Qt::Key_Comma:
        setPushForce(m_control.forceN() - PointerControl::kStepN);
        break;
    case Qt::Key_Period:
        setPushForce(m_control.forceN() + PointerControl::kStepN);
        break;
    case Qt::Key_Insert:
        moveStop(-PointerControl::kStepMm);
        break;
    case Qt::Key_Delete:
        moveStop(PointerControl::kStepMm);
        break;
    case Qt::Key_Plus:
    case Qt::Key_Equal:
        m_camera.zoom(1.0);
        redraw();
        break;
    case Qt::Key_Minus:
        m_camera.zoom(-1.0);
        redraw();
        break;
    case Qt::Key_Home:
        resetCamera();
        break;
    default:
        SceneWidget::keyPressEvent(event);
    }
}

/// Moves the bur. With Ctrl turns the view, with Ctrl and Shift the handpiece.
void ToothView::pressArrow(const QKeyEvent& event)
{
    const QPointF way = wayOf(event.key());
    if (event.modifiers().testFlag(Qt::ControlModifier)) {
        if (!m_fine)
            turnCamera(kKeyTurnDeg * way.x(), -kKeyTurnDeg * way.y());
        else if (way.x() != 0.0)
            turnHandpiece(kKeyTurnDeg * way.x());
    } else if (!event.isAutoRepeat()) {
        if (m_arrows.empty())
            m_arrowsHeldS = 0.0;
        m_arrows.insert(event.key());
        stepByKey(event.key(), m_fine ? kFineStepMm : kKeyStepMm);
        publishPointer();
    }
}

/// Moves the mirror towards the eye or away with the page keys. Moves it sideways, or with Shift tilts it, with the
/// arrow keys.
void ToothView::moveMirrorByKey(int key)
{
    if (!m_mirror)
        return;
    if (isArrow(key))
        dragMirror(wayOf(key) * kMirrorStepPx, m_fine);
    else
        pushMirror(key == Qt::Key_PageDown ? kMirrorStepMm : -kMirrorStepMm);
}

void ToothView::keyReleaseEvent(QKeyEvent* event)
{
    m_fine = event->modifiers().testFlag(Qt::ShiftModifier);
    if (event->isAutoRepeat())
        return;
    switch (event->key()) {
    case Qt::Key_PageDown:
        m_control.push(false);
        break;
    case Qt::Key_PageUp:
        m_control.lift(false);
        break;
    default:
        if (m_arrows.erase(event->key()) == 0)
            SceneWidget::keyReleaseEvent(event);
    }
    publishPointer();
}

void ToothView::focusOutEvent(QFocusEvent* event)
{
    release();
    SceneWidget::focusOutEvent(event);
}

void ToothView::hideEvent(QHideEvent* event)
{
    m_buttonIsDown = false;
    release();
    SceneWidget::hideEvent(event);
}

void ToothView::release()
{
    m_arrows.clear();
    m_mirrorHeld = false;
    m_turning = Qt::NoButton;
    m_padPushes = false;
    m_control.push(false);
    m_control.lift(false);
    publishPointer();
}

void ToothView::stepByKey(int key, double lengthMm)
{
    const glm::dvec2 right = m_camera.rightOnTooth() * lengthMm;
    const glm::dvec2 away = m_camera.awayOnTooth() * lengthMm;
    m_pointerAims = false;
    m_control.moveBy(key == Qt::Key_Left ? -right : key == Qt::Key_Right ? right : key == Qt::Key_Up ? away : -away);
}

void ToothView::moveByPad(double seconds)
{
    if (m_pad.move != glm::dvec2(0.0) && isVisible()) {
        m_pointerAims = false;
        m_control.moveBy((m_camera.rightOnTooth() * m_pad.move.x + m_camera.awayOnTooth() * m_pad.move.y) *
                         (kPadMmPerS * seconds));
    }
    if (m_pad.turn != glm::dvec2(0.0))
        turnCamera(-kPadDegPerS * seconds * m_pad.turn.x, kPadDegPerS * seconds * m_pad.turn.y);
    const bool isDown = m_pad.press > 0.0 && isVisible();
    if (isDown && !m_padIsDown) {
        m_padPushes = m_camera.elevationDeg() > 0.0;
        if (m_padPushes) {
            m_pointerAims = false;
            push(PointerKind::Gamepad);
        } else {
            emit pushRefused();
        }
    }
    if (!isDown && std::exchange(m_padPushes, false))
        m_control.push(false);
    if (m_padPushes)
        m_control.setPressure(std::clamp(m_pad.press, kLeastPressure, 1.0));
    m_padIsDown = isDown;
}

void ToothView::moveByKeys(double seconds)
{
    if (m_arrows.empty())
        return;
    m_arrowsHeldS += seconds;
    const double eager = std::clamp((m_arrowsHeldS - kSpeedUpAfterS) / kSpeedUpForS, 0.0, 1.0);
    const double pace = m_fine ? kFineMmPerS : kSlowestMmPerS + (kFastestMmPerS - kSlowestMmPerS) * eager * eager;
    for (const int key : m_arrows)
        if (m_arrowsHeldS > kSpeedUpAfterS)
            stepByKey(key, pace * seconds);
}

}  // namespace ui::tooth
