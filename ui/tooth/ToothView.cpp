// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tooth/ToothView.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <QCursor>
#include <QLocale>
#include <QPainter>
#include <QScreen>

#include "core/bur/Bur.h"
#include "core/teeth/ToothBuilder.h"
#include "ui/kit/OffBur.h"
#include "ui/render/SharedArch.h"
#include "ui/render/WholeSurface.h"
#include "ui/text/EveryLanguage.h"
#include "ui/tooth/ViewMarks.h"
#include "ui/tooth/Viewpoint.h"

namespace ui::tooth {
namespace {

constexpr float kTintShare = 0.85F;
constexpr int kFrameMs = 16;
constexpr int kLeastFrameMs = 4;
constexpr int kLightLagMs = 400;      ///< longest time for which the light far from a cut is not updated
constexpr double kBeforeMm = 0.6;     ///< a point is hidden by a surface farther in front of it than this
constexpr double kBeforePitMm = 1.5;  ///< the same for a named pit, which lies between the walls of a fissure
constexpr double kCutMm = 0.1;        ///< a named place that is cut this deep is no longer marked
constexpr double kNameBesidePx = 18.0;
constexpr double kNameAbovePx = 22.0;
constexpr double kHeightBesidePx = 60.0;  ///< height of the bur in pixels
constexpr int kForceToldMs = 1200;
constexpr double kNearStopMm = 0.1;  ///< distance to the stop below which the ring changes colour
constexpr double kStopRing = 1.35;   ///< radius of the ring, in radii of the bur
constexpr int kStopCorners = 48;
constexpr double kPlateBelowPx = 26.0;
constexpr double kLiftFollowS = 0.05;
constexpr double kTurnRadPerS = 55.0;  ///< of a running bur: as fast as an eye can follow; a real bur is a blur
constexpr int kTurnEveryMs = 33;       ///< while nothing else requests a picture

glm::dvec2 toGlm(QPointF point)
{
    return {point.x(), point.y()};
}

}  // namespace

ToothView::ToothView(core::session::UiChannels& links, QWidget* parent, Way way)
    : SceneWidget(
          [] {
              return tr(
                  "This computer offers no OpenGL 3.3, so the tooth cannot be shown. Install or update the graphics "
                  "driver (on Debian: libgl1-mesa-dri), then start Cusp again.");
          },
          way, parent),
      m_links(links), m_shown(&links)
{
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setTabletTracking(true);
    setAttribute(Qt::WA_AcceptTouchEvents);
    if (isUsable())
        setCursor(Qt::CrossCursor);
    setMinimumSize(220, 180);
    text::bindTranslation(this, [this] {
        setAccessibleName(tr("Tooth"));
        setAccessibleDescription(tr("Arrow keys move the bur, page down pushes, page up lifts."));
    });
    m_control.setBurRadius(core::bur::burs()[0].headRadiusMm);
    m_frame.setTimerType(Qt::PreciseTimer);
    connect(&m_frame, &QTimer::timeout, this, &ToothView::advanceFrame);
    m_sinceFrame.start();
    m_frame.start(kFrameMs);
}

ToothView::~ToothView()
{
    leave();
}

void ToothView::setTooth(const std::shared_ptr<const core::terrain::ToothAnatomy>& anatomy, std::uint64_t generation)
{
    m_servo = m_shown->servo.latest();
    m_control.setSurface(nullptr);
    m_tooth.emplace(anatomy);
    ++m_toothRevision;
    m_surface = render::wholeSurface(anatomy, operatingLight(m_leftHanded));
    m_surfaceIsNew = true;
    m_gizmoTurn.reset();
    m_changes = {};
    m_control.setSurface(m_surface.get());
    m_inbox.setGeneration(generation);
    showWhole(m_camera, *m_surface);
    m_mirror.reset();
    m_exercise = {};
    m_pins.clear();
    showNeighbours();
    placeMirror();
    takePatches();
    publishPointer();
    redraw();
}

void ToothView::setIdeal(const core::grading::IdealTop& ideal)
{
    m_surface->setIdeal(ideal);
    // The view of a posterior tooth or a training block begins above the cavity.
    const int fdi = m_surface->anatomy().fdi;
    if (ideal && (fdi == 0 || fdi % 10 > 3))
        m_camera.setStart(m_camera.startAzimuthDeg(), Camera::kAboveDeg);
    m_surfaceIsNew = true;
    redraw();
}

/// Shows adjacent teeth beside a generated, upright tooth. The neighbours of a scan are unknown.
void ToothView::showNeighbours()
{
    m_neighbours.clear();
    m_neighboursAreNew = true;
    const auto anatomy = m_surface ? m_surface->anatomyPointer() : nullptr;
    if (!m_settings.showsNeighbours || !anatomy || !core::teeth::standsInTheArch(*anatomy))
        return;
    render::withArch(this, [this, anatomy](const render::ArchPointer& arch) {
        if (!m_settings.showsNeighbours || !m_surface || m_surface->anatomyPointer() != anatomy)
            return;
        m_neighbours = arch->neighbours(anatomy->fdi);
        m_neighboursAreNew = true;
        redraw();
    });
}

void ToothView::setHeights(const std::vector<float>& top)
{
    m_tooth = core::terrain::restored(m_tooth->anatomy, top);
    ++m_toothRevision;
    m_surface->write(top);
    takeAllChanges();
}

void ToothView::setPushForce(double newtons)
{
    const double before = m_control.forceN();
    m_control.setForce(newtons);
    m_sinceForceSet.start();
    redraw();
    if (m_control.forceN() == before)
        return;
    publishPointer();
    emit handChanged();
}

void ToothView::setFeed(double mmPerS)
{
    m_control.setFeed(mmPerS);
    publishPointer();
    emit handChanged();
}

void ToothView::setDepthStop(bool on, double depthMm)
{
    m_control.setStopOn(on);
    m_control.setStopDepth(depthMm);
    publishPointer();
    redraw();
    emit handChanged();
}

void ToothView::moveStop(double stepMm)
{
    if (!m_control.isStopOn())
        return;
    setDepthStop(true, m_control.stopDepthMm() + stepMm);
    m_sinceStopSet.start();
}

/// Aims the bur at a resting pointer again after the view or the bur has changed.
void ToothView::aim()
{
    m_control.follow(m_servo);
    if (m_pointerAims && !m_pointerHasLeft && !m_mirrorHeld && m_turning == Qt::NoButton)
        m_control.moveTo(rayAt(m_pointer), m_servo.anchorMm);
}

void ToothView::setDrillOn(bool on)
{
    if (on == m_drillOn)
        return;
    m_drillOn = on;
    redraw();
}

void ToothView::setBurTint(const QColor& colour)
{
    m_burTint = colour;
}

void ToothView::setLeftHanded(bool leftHanded)
{
    m_leftHanded = leftHanded;
    placeMirror();
    if (m_surface) {
        m_surface->setLight(operatingLight(m_leftHanded));
        takeAllChanges();
    }
    redraw();
}

void ToothView::setSettings(const ViewSettings& settings)
{
    if (settings == m_settings)
        return;
    const bool beside = settings.showsNeighbours != m_settings.showsNeighbours;
    m_settings = settings;
    if (beside)
        showNeighbours();
    placeMirror();
    redraw();
}

/// Places the mirror at its initial position. Leaves a mirror that the user placed where it is while its glass is
/// visible.
void ToothView::placeMirror()
{
    if (!m_settings.showsMirror || !m_surface) {
        m_mirror.reset();
        return;
    }
    if (m_mirror && m_mirrorIsPlaced && glm::dot(m_mirror->normal, m_camera.eyeMm() - m_mirror->centreMm) > 0.0)
        return;
    m_mirror = mirrorBeside(m_camera, *m_surface, m_leftHanded, m_settings.showsNeighbours);
    m_mirrorIsPlaced = false;
}

void ToothView::resetCamera()
{
    m_camera.reset();
    m_handTurnDeg = 0.0;
    placeMirror();
    redraw();
}

void ToothView::setExercise(const ExerciseMarks& marks)
{
    if (marks == m_exercise)
        return;
    m_exercise = marks;
    redraw();
}

void ToothView::setPins(std::vector<glm::dvec3> placesMm)
{
    if (placesMm == m_pins)
        return;
    m_pins = std::move(placesMm);
    redraw();
}

void ToothView::turnRound()
{
    m_camera.turn(180.0, 0.0);
    placeMirror();
    redraw();
}

void ToothView::setCamera(double azimuthDeg, double elevationDeg, double distanceMm)
{
    m_camera.set(azimuthDeg, elevationDeg, distanceMm);
    redrawMoving();
}

void ToothView::lookAs(const Camera& camera)
{
    m_camera.lookAs(camera);
    redrawMoving();
}

void ToothView::lookFrom(const QString& viewpoint)
{
    if (m_surface && goTo(m_camera, viewpoint, m_surface->anatomy().fdi, m_surface->anatomy().lying))
        redrawMoving();
}

void ToothView::lookAt(const std::optional<core::session::Sight>& sight, glm::dvec3 placeMm)
{
    constexpr double kInFrontMm = 2.0;  // a surface this far in front of the place hides it
    if (sight)
        m_camera.lookFrom(*sight);
    const glm::dvec3 eye = m_camera.eyeMm();
    const auto seen = m_surface ? m_surface->meetTooth({eye, glm::normalize(placeMm - eye)}) : std::nullopt;
    const bool isHidden = seen && glm::distance(eye, *seen) < glm::distance(eye, placeMm) - kInFrontMm;
    if (!sight || isHidden)
        m_camera.lookDownAt(placeMm);
    redrawMoving();
}

ToothView::Uploads ToothView::uploads() const
{
    Uploads uploads = m_uploads;
    uploads.bytes = m_renderer ? m_renderer->uploadedBytes() : 0;
    return uploads;
}

QImage ToothView::picture()
{
    m_servo = m_shown->servo.latest();
    takePatches();
    if (m_surface && m_surface->isBehind())
        takeAllChanges();
    return grabPicture();
}

QImage ToothView::toothPicture()
{
    m_instrumentHidden = true;
    const ViewSettings own = m_settings;
    m_settings = {};
    m_settings.look.palette = own.look.palette;
    const auto mirror = std::exchange(m_mirror, std::nullopt);
    const ExerciseMarks exercise = std::exchange(m_exercise, {});
    QImage image = picture();
    m_settings = own;
    m_mirror = mirror;
    m_exercise = exercise;
    m_instrumentHidden = false;
    redraw();
    return image;
}

bool ToothView::prepareScene(QString& reason)
{
    m_renderer = std::make_unique<render::ToothRenderer>();
    m_presenter = std::make_unique<render::Presenter>();
    m_surfaceIsNew = true;
    m_neighboursAreNew = true;
    // Matches the refresh rate of the screen.
    m_frame.setInterval(std::clamp(static_cast<int>(1000.0 / screen()->refreshRate()), kLeastFrameMs, kFrameMs));
    return m_renderer->initialize(reason) && m_presenter->initialize(reason);
}

void ToothView::releaseScene()
{
    m_presenter.reset();
    m_renderer.reset();
}

void ToothView::resizeEvent(QResizeEvent* event)
{
    SceneWidget::resizeEvent(event);
    m_camera.setViewport({width(), height()});
    // A panel that opens beside the view moves the view under a resting pointer, without a mouse event.
    if (!m_pointerHasLeft) {
        m_pointer = mapFromGlobal(QPointF(QCursor::pos()));
        m_pointerHasLeft = !rect().contains(m_pointer.toPoint());
    }
}

void ToothView::drawScene(QSize sizePx, int samples)
{
    if (m_surface) {
        if (m_surfaceIsNew) {
            m_renderer->setSurface(*m_surface);
            ++m_uploads.wholes;
        } else {
            m_renderer->update(*m_surface, m_changes);
            m_uploads.changedBytes += m_changes.bytes();
        }
        m_surfaceIsNew = false;
        m_changes = {};
    }
    if (std::exchange(m_neighboursAreNew, false))
        m_renderer->setNeighbours(m_neighbours);
    m_servo = m_shown->servo.latest();
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    m_pose = poseAt(m_servo, m_clock.momentFor(std::chrono::nanoseconds(now).count()));
    m_paintedForceN = glm::length(m_servo.forceN);
    m_presenter->draw(*m_renderer, scene(sizePx), m_settings.presentation, m_camera.distanceMm(), samples);
}

bool ToothView::showsInstrument() const
{
    return m_surface != nullptr && m_servo.tick > 0 && !m_instrumentHidden;
}

render::Scene ToothView::scene(QSizeF sizePx) const
{
    render::Scene scene = sceneThrough(m_camera, glm::vec2(sizePx.width(), sizePx.height()), m_leftHanded);
    scene.instrumentShown = showsInstrument();
    scene.liftMm = m_liftMm;
    scene.burIndex = m_servo.burIndex;
    scene.tipMm = m_pose.anchorMm;
    if (m_surface)
        scene.surfaceBelowTipMm = m_surface->topMm(glm::dvec2(m_pose.anchorMm));
    scene.turnRad = m_turnRad;
    scene.drillOn = m_drillOn;
    if (m_burTint.isValid())
        scene.burTint = {m_burTint.redF(), m_burTint.greenF(), m_burTint.blueF(), kTintShare};
    scene.look = m_settings.look;
    scene.mirror = m_mirror;
    scene.mirrorHandleLeft = !m_leftHanded;
    scene.handAzimuthRad += glm::radians(m_handTurnDeg);
    scene.keepsStill = way() == Way::Image;
    if (m_settings.showsHand && scene.instrumentShown)
        scene.ghostMm = m_pose.deviceMm;
    return scene;
}

/// Paints the marks over the picture; twice if each eye has its own half of the picture.
void ToothView::paintMarks(QPainter& painter)
{
    painter.setRenderHint(QPainter::Antialiasing);
    const render::Presentation& how = m_settings.presentation;
    const bool beside = how.stereo == render::Stereo::SideBySide;
    const bool above = how.stereo == render::Stereo::TopBottom;
    const QSizeF size(width(), height());
    const bool isBlindfolded = !m_exercise.pads.empty();
    if (isBlindfolded)
        paintBlindfold(painter, QRectF(QPointF(), size));
    for (int eye = 0; eye < (beside || above ? 2 : 1); ++eye) {
        painter.resetTransform();
        if (how.flipLeftRight) {
            painter.translate(size.width(), 0.0);
            painter.scale(-1.0, 1.0);
        }
        if (how.flipUpDown) {
            painter.translate(0.0, size.height());
            painter.scale(1.0, -1.0);
        }
        painter.translate(beside ? 0.5 * eye * size.width() : 0.0, above ? 0.5 * eye * size.height() : 0.0);
        painter.scale(beside ? 0.5 : 1.0, above ? 0.5 : 1.0);
        if (isBlindfolded)
            drawPads(painter);
        else {
            drawPoints(painter);
            drawPins(painter);
        }
        drawForce(painter);
        drawStop(painter);
        if (m_surface && core::teeth::isGenerated(m_surface->anatomy()))
            drawGizmo(painter);
        if (!showsInstrument())
            continue;
        if (isBlindfolded)
            continue;
        const glm::dvec2 hand = m_camera.pixelOf(m_pose.deviceMm);
        const glm::dvec2 bur = m_camera.pixelOf(m_pose.anchorMm);
        paintArrowOut(painter, size, {bur.x, bur.y}, {hand.x, hand.y});
        if (m_settings.look.depthColours == render::DepthColours::Off)
            continue;
        paintDepthScale(painter, size, m_settings.look, how, QPointF(bur.x, bur.y));
        if (const auto under = m_pointerHasLeft ? std::nullopt : m_surface->meetTooth(rayAt(m_pointer)))
            paintPlate(painter, size, presented(m_pointer) - QPointF(0.0, kPlateBelowPx), kit::kOffBurPx,
                       depthWords(*m_surface, *under, m_settings.look.depthColours), m_leftHanded);
    }
}

void ToothView::drawPoints(QPainter& painter)
{
    if (!m_surface)
        return;
    for (const PointMark& mark : m_exercise.points) {
        const glm::dvec3 place(mark.placeMm, m_surface->topMm(mark.placeMm).value_or(0.0));
        if (!mark.name.isEmpty() && m_surface->belowUncutMm(place) > kCutMm)
            continue;
        const glm::dvec3 beside = place + glm::dvec3(m_camera.rightOnTooth() * mark.reachMm, 0.0);
        const glm::dvec2 at = m_camera.pixelOf(place);
        const auto seen = m_surface->meetTooth(m_camera.rayThrough(at));
        const bool isHidden = seen && glm::distance(*seen, place) > (mark.name.isEmpty() ? kBeforeMm : kBeforePitMm);
        paintPoint(painter, {at.x, at.y}, glm::distance(at, m_camera.pixelOf(beside)), mark.isTouched, isHidden);
        if (!mark.name.isEmpty())
            paintPlate(painter, QSizeF(width(), height()), {at.x, at.y - kNameAbovePx}, kNameBesidePx, mark.name,
                       false);
    }
}

void ToothView::drawPins(QPainter& painter)
{
    if (!m_surface)
        return;
    for (const glm::dvec3& place : m_pins) {
        const glm::dvec2 at = m_camera.pixelOf(place);
        const auto seen = m_surface->meetTooth(m_camera.rayThrough(at));
        paintPin(painter, {at.x, at.y}, seen && glm::distance(*seen, place) > kBeforeMm);
    }
}

/// Draws the positions of pads and bur, but not the bur's effect on them.
void ToothView::drawPads(QPainter& painter)
{
    const auto seen = [&](glm::dvec2 place) {
        const glm::dvec2 at = m_camera.pixelOf({place, 0.0});
        return QPointF(at.x, at.y);
    };
    for (const PadMark& pad : m_exercise.pads)
        paintPad(painter,
                 QPolygonF({seen(pad.fromMm), seen({pad.toMm.x, pad.fromMm.y}), seen(pad.toMm),
                            seen({pad.fromMm.x, pad.toMm.y})}),
                 pad.name);
    if (!showsInstrument())
        return;
    const QPointF bur = seen(glm::dvec2(m_pose.anchorMm));
    paintBurSpot(painter, bur, m_servo.touching);
    if (m_exercise.showsHeight)
        paintHeight(painter, QSizeF(width(), height()), m_pose.anchorMm.z);
}

/// Converts a position to coordinates of the picture before flips and before its division into halves.
QPointF ToothView::presented(QPointF position) const
{
    const render::Presentation& how = m_settings.presentation;
    if (how.flipLeftRight)
        position.setX(width() - position.x());
    if (how.flipUpDown)
        position.setY(height() - position.y());
    if (how.stereo == render::Stereo::SideBySide)
        position.setX(std::fmod(2.0 * position.x(), width()));
    if (how.stereo == render::Stereo::TopBottom)
        position.setY(std::fmod(2.0 * position.y(), height()));
    return position;
}

std::optional<QPointF> ToothView::burAt() const
{
    const render::Presentation& how = m_settings.presentation;
    if (!showsInstrument() || how.stereo != render::Stereo::Off)
        return std::nullopt;
    const glm::dvec2 at = m_camera.pixelOf(m_servo.anchorMm);
    return QPointF(how.flipLeftRight ? width() - at.x : at.x, how.flipUpDown ? height() - at.y : at.y);
}

/// Draws the directions of the tooth's sides in a corner of the view.
void ToothView::drawGizmo(QPainter& painter)
{
    const glm::dmat3 turn = glm::dmat3(m_camera.view()) * m_surface->anatomy().lying.cutFromOwn();
    if (m_gizmoTurn != turn || m_gizmo.devicePixelRatioF() != devicePixelRatioF()) {
        m_gizmoTurn = turn;
        m_gizmo = QPixmap(QSize(2 * kGizmoPx, 2 * kGizmoPx) * devicePixelRatioF());
        m_gizmo.setDevicePixelRatio(devicePixelRatioF());
        m_gizmo.fill(Qt::transparent);
        QPainter paint(&m_gizmo);
        render::paintGizmo(paint, QPointF(kGizmoPx, kGizmoPx), kGizmoPx, turn, gizmoLetters(m_surface->anatomy().fdi));
    }
    painter.drawPixmap(QPointF(kGizmoInPx, kGizmoInPx), m_gizmo);
}

/// Returns the axis end whose letter in the gizmo is at a position. Returns nothing for a stereo or mirrored picture.
std::optional<std::size_t> ToothView::gizmoEndAt(QPointF position) const
{
    const render::Presentation& how = m_settings.presentation;
    if (!m_gizmoTurn || !m_surface || how.stereo != render::Stereo::Off || how.flipLeftRight || how.flipUpDown)
        return std::nullopt;
    constexpr double kMiddlePx = kGizmoInPx + kGizmoPx;
    return render::gizmoEndAt(position, {kMiddlePx, kMiddlePx}, kGizmoPx, *m_gizmoTurn,
                              gizmoLetters(m_surface->anatomy().fdi));
}

/// Converts a movement likewise. It may cross from one half to the other.
QPointF ToothView::presentedWay(QPointF by) const
{
    const render::Presentation& how = m_settings.presentation;
    const double x = (how.flipLeftRight ? -1.0 : 1.0) * (how.stereo == render::Stereo::SideBySide ? 2.0 : 1.0);
    const double y = (how.flipUpDown ? -1.0 : 1.0) * (how.stereo == render::Stereo::TopBottom ? 2.0 : 1.0);
    return {x * by.x(), y * by.y()};
}

void ToothView::drawForce(QPainter& painter)
{
    const double wantedN = m_control.forceN();
    const double forceN = glm::length(m_servo.forceN);
    const bool pushing = m_published.pushing;
    if (!showsInstrument() || (!pushing && !m_servo.touching && !m_sinceForceSet.isValid()))
        return;
    // An arc beside the tip; its full length is the force that the user set.
    glm::dvec3 tipMm = m_pose.anchorMm;
    if (!m_exercise.pads.empty())
        tipMm.z = 0.0;
    const glm::dvec2 tip = m_camera.pixelOf(tipMm);
    constexpr double kRadiusPx = 44.0;
    constexpr double kHalfDeg = 42.0;
    const QRectF box(tip.x - kRadiusPx, tip.y - kRadiusPx, 2.0 * kRadiusPx, 2.0 * kRadiusPx);
    const double middleDeg = m_leftHanded ? 0.0 : 180.0;
    const double sign = m_leftHanded ? 1.0 : -1.0;  // filled from the bottom on either side
    const auto sixteenths = [](double degrees) { return static_cast<int>(std::lround(16.0 * degrees)); };
    const int start = sixteenths(middleDeg - sign * kHalfDeg);
    const auto arc = [&](QColor colour, double width, double part) {
        painter.setPen(QPen(colour, width, Qt::SolidLine, Qt::RoundCap));
        painter.drawArc(box, start, sixteenths(sign * part * 2.0 * kHalfDeg));
    };
    arc(QColor(16, 18, 20, 150), 9.0, 1.0);
    arc(QColor(255, 255, 255, 60), 4.0, 1.0);
    const double share = std::min(forceN / wantedN, 1.0);
    if (share > 0.02)
        arc(QColor(0x3C, 0xC8, 0xCA), 5.0, share);
    if (m_sinceForceSet.isValid()) {
        //: A force in newtons, beside the bur
        const QString text = tr("%1 N").arg(QLocale().toString(wantedN, 'f', 1));
        QFont large = font();
        large.setPixelSize(18);
        painter.setFont(large);
        const double width = QFontMetricsF(large).horizontalAdvance(text) + 16.0;
        const QRectF label(m_leftHanded ? tip.x + kit::kOffBurPx : tip.x - kit::kOffBurPx - width, tip.y - 14.0, width,
                           28.0);
        painter.setPen(Qt::NoPen);
        painter.setBrush(QColor(20, 22, 24, 190));
        painter.drawRoundedRect(label, 6.0, 6.0);
        painter.setPen(QColor(240, 240, 238));
        painter.drawText(label, Qt::AlignCenter, text);
    }
}

/// Draws a ring around the bur at the depth stop, with the depths of the tip and of the stop beside it.
void ToothView::drawStop(QPainter& painter)
{
    const bool isSeen = m_published.pushing || m_sinceStopSet.isValid();
    if (!showsInstrument() || !m_control.isStopOn() || !isSeen || !m_exercise.pads.empty())
        return;
    const std::optional<double> stopMm = m_control.stopMm();
    const double leftMm = stopMm ? m_pose.anchorMm.z - *stopMm : m_control.stopDepthMm();
    const QColor colour = leftMm < kNearStopMm ? QColor(0xFF, 0xC2, 0x4B) : QColor(0xF2, 0xF2, 0xEE);
    if (stopMm) {
        const double radiusMm = kStopRing * m_control.burRadiusMm();
        QPolygonF ring;
        for (int k = 0; k <= kStopCorners; ++k) {
            const double angle = 2.0 * std::numbers::pi * k / kStopCorners;
            const glm::dvec2 at = m_camera.pixelOf({m_pose.anchorMm.x + radiusMm * std::cos(angle),
                                                    m_pose.anchorMm.y + radiusMm * std::sin(angle), *stopMm});
            ring << QPointF(at.x, at.y);
        }
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(QColor(16, 18, 20, 150), 4.0));
        painter.drawPolyline(ring);
        painter.setPen(QPen(colour, 2.0));
        painter.drawPolyline(ring);
    }
    const auto figure = [](double mm, int places) { return QLocale().toString(mm, 'f', places); };
    const QString words =
        stopMm && m_published.pushing
            //: Depth of the tip of the bur, and of the stop below it, millimetres
            ? tr("%1 / %2 mm")
                  .arg(figure(m_control.stopDepthMm() - std::max(0.0, leftMm), 2), figure(m_control.stopDepthMm(), 1))
            //: The depth at which the bur will stop
            : tr("Stop %1 mm").arg(figure(m_control.stopDepthMm(), 1));
    const glm::dvec2 tip = m_camera.pixelOf(m_pose.anchorMm);
    paintPlate(painter, QSizeF(width(), height()), QPointF(tip.x, tip.y + kPlateBelowPx), kit::kOffBurPx, words,
               m_leftHanded);
}

render::Ray ToothView::rayAt(QPointF position) const
{
    return m_camera.rayThrough(toGlm(presented(position)));
}

void ToothView::advanceFrame()
{
    const double seconds = std::min(0.1, static_cast<double>(m_sinceFrame.nsecsElapsed()) * 1.0e-9);
    m_sinceFrame.start();
    const core::servo::ServoState before = m_servo;
    m_servo = m_shown->servo.latest();
    if (m_servo.burIndex < core::bur::burs().size())
        m_control.setBurRadius(core::bur::burs()[m_servo.burIndex].headRadiusMm);
    takePatches();
    if (m_surface && (m_surface->isSweeping() ||
                      (m_surface->isBehind() && (!m_sinceLight.isValid() || m_sinceLight.elapsed() >= kLightLagMs)))) {
        takeChanges(m_surface->sweepLight());
        m_sinceLight.start();
    }
    followHead(seconds);
    moveByKeys(seconds);
    moveByPad(seconds);
    aim();
    publishPointer();
    const double glidingS = m_settings.movesLittle ? kAtOnceS : seconds;
    if (m_camera.advance(glidingS)) {
        m_control.forgetRay();
        redrawMoving();
    }
    if (m_drillOn && !m_settings.movesLittle && showsInstrument()) {
        m_turnRad = std::fmod(m_turnRad + kTurnRadPerS * seconds, 2.0 * std::numbers::pi);
        // A software renderer would never have time for smooth edges. There a bur at rest is drawn as a blur, which a
        // real one is.
        if (way() == Way::Window && (!m_sinceTurn.isValid() || m_sinceTurn.elapsed() >= kTurnEveryMs)) {
            m_sinceTurn.start();
            redraw();
        }
    }
    const double lift = m_surface && m_servo.tick > 0 ? liftMm(*m_surface, m_servo.burIndex, m_servo.anchorMm) : 0.0;
    const double rest = (m_liftMm - lift) * std::exp(-glidingS / kLiftFollowS);
    if (const double next = std::abs(rest) < 0.01 ? lift : lift + rest; next != m_liftMm) {
        m_liftMm = next;
        redraw();
    }
    for (QElapsedTimer* since : {&m_sinceStopSet, &m_sinceForceSet})
        if (since->isValid() && since->elapsed() > kForceToldMs) {
            since->invalidate();
            redraw();
        }
    // Changes below 0.01 N and 2 micrometres are invisible.
    const bool moved = glm::distance(m_servo.anchorMm, m_pose.anchorMm) > 0.002;
    const bool pressed = std::abs(glm::length(m_servo.forceN) - m_paintedForceN) > 0.01;
    if (moved || pressed || m_servo.burIndex != before.burIndex || m_servo.touching != before.touching ||
        (m_servo.tick > 0) != (before.tick > 0)) {
        redraw();
    }
    emit frameAdvanced(m_servo);
}

void ToothView::setHeadLean(HeadLean lean)
{
    m_headLean = std::move(lean);
    if (!m_headLean)
        followHead(0.0);
}

void ToothView::followHead(double seconds)
{
    constexpr double kSeenDeg = 0.02;  ///< smaller changes are not drawn, so that a picture at rest has smooth edges
    constexpr double kSeenShare = 2e-4;
    const core::tracking::Lean lean = m_headLean ? m_headLean(seconds, m_servo.touching) : core::tracking::Lean{};
    const core::tracking::Lean& drawn = m_camera.lean();
    const bool isAlike = std::abs(lean.yawDeg - drawn.yawDeg) < kSeenDeg &&
                         std::abs(lean.pitchDeg - drawn.pitchDeg) < kSeenDeg &&
                         std::abs(lean.farther - drawn.farther) < kSeenShare &&
                         std::abs(lean.rightShare - drawn.rightShare) < kSeenShare &&
                         std::abs(lean.upShare - drawn.upShare) < kSeenShare;
    // The view must return exactly to where the mouse left it.
    const bool isBack = lean == core::tracking::Lean{} && !(drawn == lean);
    if (isAlike && !isBack)
        return;
    m_camera.lean(lean);
    m_control.forgetRay();
    redrawMoving();
}

void ToothView::showChannels(core::session::UiChannels& channels)
{
    m_shown = &channels;
    m_servo = m_shown->servo.latest();
}

void ToothView::takePatches()
{
    for (core::servo::TilePatch patch; m_shown->patches.tryPop(patch);)
        m_inbox.take(patch);
    if (m_inbox.complete().empty() || !m_surface)
        return;
    for (const core::servo::TilePatch& patch : m_inbox.complete()) {
        m_surface->write(patch);
        write(patch, *m_tooth);
    }
    ++m_toothRevision;
    m_inbox.complete().clear();
    takeChanges(m_surface->refresh(true));
}

void ToothView::takeAllChanges()
{
    takeChanges(m_surface->refresh());
    m_sinceLight.start();
}

void ToothView::takeChanges(const render::ToothSurface::Changes& changes)
{
    m_changes.add(changes);
    redraw();
}

void ToothView::publishPointer()
{
    updatePressed();
    const core::servo::PointerInput wish =
        m_control.input(m_servo.tick > 0 ? std::optional(m_servo.anchorMm) : std::nullopt);
    if (wish == m_published)
        return;
    if (wish.pushing != m_published.pushing)
        redraw();
    m_published = wish;
    m_links.pointer.publish(wish);
}

}  // namespace ui::tooth
