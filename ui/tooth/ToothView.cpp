// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tooth/ToothView.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <QKeyEvent>
#include <QLabel>
#include <QLocale>
#include <QMouseEvent>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLExtraFunctions>
#include <QOpenGLFramebufferObject>
#include <QPainter>
#include <QSurfaceFormat>
#include <QTabletEvent>
#include <QWheelEvent>

#include "core/drilling/Bur.h"

namespace ui::tooth {
namespace {

constexpr int kFrameMs = 16;
constexpr int kSamples = 4;
constexpr int kStillMs = 120;  ///< without a change before a software driver is asked for smooth edges
constexpr double kDegreesPerPixel = 0.35;
constexpr double kKeyTurnDeg = 5.0;
constexpr int kForceToldMs = 1200;
constexpr double kShankClearMm = 0.9;  ///< around the bur's axis, what the shank must clear
constexpr double kHandClearMm = 5.5;   ///< and the head of the handpiece with its neck
constexpr double kLiftFollowS = 0.05;

// Keys: one step at once, then a pace that grows while the key is held.
constexpr double kKeyStepMm = 0.1;
constexpr double kFineStepMm = 0.02;
constexpr double kSlowestMmPerS = 1.0;
constexpr double kFastestMmPerS = 7.0;
constexpr double kFineMmPerS = 0.4;
constexpr double kSpeedUpAfterS = 0.2;
constexpr double kSpeedUpForS = 0.8;

QSurfaceFormat wantedFormat()
{
    QSurfaceFormat format;
    format.setRenderableType(QSurfaceFormat::OpenGL);
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(24);
    format.setSamples(kSamples);
    return format;
}

/// What this computer draws with. Asked once: it cannot change while we run.
struct Driver
{
    bool hasOpenGl33 = false;
    bool isSoftware = false;  ///< every sample of every pixel costs processor time
};
const Driver& driver()
{
    static const Driver found = [] {
        Driver asked;
        QOpenGLContext context;
        context.setFormat(wantedFormat());
        if (!context.create())
            return asked;
        QOffscreenSurface surface;
        surface.setFormat(context.format());
        surface.create();
        if (!context.makeCurrent(&surface))
            return asked;
        asked.hasOpenGl33 = !context.isOpenGLES() && context.format().version() >= qMakePair(3, 3);
        const QByteArray name(reinterpret_cast<const char*>(context.functions()->glGetString(GL_RENDERER)));
        for (const char* software : {"llvmpipe", "softpipe", "swrast", "Software"})
            asked.isSoftware = asked.isSoftware || name.contains(software);
        context.doneCurrent();
        return asked;
    }();
    return found;
}

glm::dvec2 toGlm(QPointF point)
{
    return {point.x(), point.y()};
}

/// How many columns of an open lesion the camera sees.
int lesionColumnsSeen(const render::ToothSurface& surface, const Camera& camera)
{
    constexpr double kSameMm = 0.2;
    const core::terrain::ToothAnatomy& anatomy = surface.anatomy();
    const core::terrain::Grid& grid = anatomy.grid;
    int seen = 0;
    for (int j = 0; j < grid.side; ++j) {
        for (int i = 0; i < grid.side; ++i) {
            const std::size_t k = grid.index(i, j);
            const core::terrain::ColumnLayers& layers = anatomy.layers[k];
            if (layers.cariesFloor >= layers.cariesRoof || layers.cariesRoof < anatomy.top[k])
                continue;
            const glm::dvec3 point(grid.nodeMm(i, j), anatomy.top[k]);
            glm::dvec3 met(0.0);
            if (surface.meet(camera.rayThrough(camera.pixelOf(point)), met) && glm::length(met - point) < kSameMm)
                ++seen;
        }
    }
    return seen;
}

/// From where a tooth is looked at first: from behind if only there the lesion is seen, as on lower incisors.
double startAzimuthDeg(const render::ToothSurface& surface, Camera camera)
{
    constexpr double kFront = Camera::kStartAzimuthDeg;
    constexpr double kBehind = kFront + 180.0;
    camera.setStart(kFront);
    camera.reset();
    const int front = lesionColumnsSeen(surface, camera);
    camera.setStart(kBehind);
    return lesionColumnsSeen(surface, camera) > 3 * front ? kBehind : kFront;
}

}  // namespace

ToothView::ToothView(core::session::UiLinks& links, QWidget* parent) : QOpenGLWidget(parent), m_links(links)
{
    QSurfaceFormat format = wantedFormat();
    if (driver().isSoftware)
        format.setSamples(0);
    setFormat(format);
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setTabletTracking(true);
    setCursor(Qt::CrossCursor);
    setMinimumSize(240, 180);
    setAccessibleName(tr("Tooth"));
    setAccessibleDescription(tr("Arrow keys move the bur, page down pushes, page up lifts."));
    m_control.setBurRadius(core::drilling::burs()[0].headRadiusMm);
    m_frame.setTimerType(Qt::PreciseTimer);
    connect(&m_frame, &QTimer::timeout, this, &ToothView::advanceFrame);
    m_sinceFrame.start();
    m_frame.start(kFrameMs);
    if (!driver().hasOpenGl33)
        fail(QStringLiteral("no context of version 3.3 with a core profile could be made"));
}

ToothView::~ToothView()
{
    if (context() != nullptr)
        disconnect(context(), nullptr, this, nullptr);
    leaveContext();
    if (m_sentence && m_sentence->parent() == nullptr)
        delete m_sentence;
}

QWidget* ToothView::pane()
{
    return m_usable ? static_cast<QWidget*>(this) : m_sentence;
}

void ToothView::setTooth(std::shared_ptr<const core::terrain::ToothAnatomy> anatomy, std::uint64_t generation)
{
    m_servo = m_links.servo.latest();
    m_control.setSurface(nullptr);
    m_tooth.emplace(anatomy);
    ++m_toothRevision;
    m_surface = std::make_unique<render::ToothSurface>(std::move(anatomy), towardsLight());
    m_surfaceIsNew = true;
    m_changes = {};
    m_control.setSurface(m_surface.get());
    m_inbox.setGeneration(generation);
    // Slightly tighter than the ball: the tooth is the hero, and a crown does not fill its corners.
    m_camera.setSubject(m_surface->crownMiddleMm(), 0.93 * m_surface->crownRadiusMm());
    m_camera.setStart(startAzimuthDeg(*m_surface, m_camera));
    takePatches();
    publishPointer();
    update();
}

void ToothView::setHeights(const std::vector<float>& top)
{
    m_tooth = core::terrain::restored(m_tooth->anatomy, top);
    ++m_toothRevision;
    m_surface->write(top);
    takeChanges();
}

void ToothView::setPushForce(double newtons)
{
    const double before = m_control.forceN();
    m_control.setForce(newtons);
    m_sinceForceSet.start();
    m_forceTold = true;
    update();
    if (m_control.forceN() == before)
        return;
    publishPointer();
    emit pushForceChanged(m_control.forceN());
}

void ToothView::setDrillOn(bool on)
{
    m_drillOn = on;
    update();
}

void ToothView::setLeftHanded(bool leftHanded)
{
    m_leftHanded = leftHanded;
    if (m_surface) {
        m_surface->setLight(towardsLight());
        m_changes.shading = united(m_changes.shading, m_surface->refresh().shading);
    }
    update();
}

void ToothView::resetCamera()
{
    m_camera.reset();
    update();
}

void ToothView::setCamera(double azimuthDeg, double elevationDeg, double distanceMm)
{
    m_camera.set(azimuthDeg, elevationDeg, distanceMm);
    update();
}

QImage ToothView::picture()
{
    if (!m_usable)
        return m_sentence ? m_sentence->grab().toImage() : QImage();
    m_servo = m_links.servo.latest();
    takePatches();
    m_smoothWanted = true;
    return grabFramebuffer().convertToFormat(QImage::Format_RGB32);
}

QImage ToothView::toothPicture()
{
    m_instrumentHidden = true;
    QImage image = picture();
    m_instrumentHidden = false;
    update();
    return image;
}

void ToothView::initializeGL()
{
    connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &ToothView::leaveContext);
    m_renderer = std::make_unique<render::ToothRenderer>();
    m_surfaceIsNew = true;
    if (QString reason; m_usable && !m_renderer->initialize(reason))
        fail(reason);
}

void ToothView::resizeEvent(QResizeEvent* event)
{
    QOpenGLWidget::resizeEvent(event);
    m_camera.setViewport({width(), height()});
    if (m_sentence && m_sentence->parent() == this)
        m_sentence->setGeometry(rect());
}

void ToothView::paintGL()
{
    if (!m_usable || !m_renderer)
        return;
    if (m_surface) {
        if (m_surfaceIsNew)
            m_renderer->setSurface(*m_surface);
        else
            m_renderer->update(*m_surface, m_changes);
        m_surfaceIsNew = false;
        m_changes = {};
    }
    if (m_drillOn)
        m_turnRad += 0.9;
    drawScene();
    drawForce();
    m_smoothWanted = false;
    m_sincePaint.start();
}

/// A software driver draws moving pictures with hard edges, and smooth ones once nothing moves.
void ToothView::drawScene()
{
    if (!driver().isSoftware || !m_smoothWanted) {
        m_renderer->draw(scene());
        m_smooth = !driver().isSoftware;
        return;
    }
    const QSize size = this->size() * devicePixelRatioF();
    if (!m_smoothCanvas || m_smoothCanvas->size() != size) {
        QOpenGLFramebufferObjectFormat format;
        format.setSamples(kSamples);
        format.setAttachment(QOpenGLFramebufferObject::CombinedDepthStencil);
        m_smoothCanvas = std::make_unique<QOpenGLFramebufferObject>(size, format);
    }
    QOpenGLExtraFunctions* gl = context()->extraFunctions();
    m_smoothCanvas->bind();
    gl->glViewport(0, 0, size.width(), size.height());
    m_renderer->draw(scene());
    gl->glBindFramebuffer(GL_READ_FRAMEBUFFER, m_smoothCanvas->handle());
    gl->glBindFramebuffer(GL_DRAW_FRAMEBUFFER, defaultFramebufferObject());
    gl->glBlitFramebuffer(0, 0, size.width(), size.height(), 0, 0, size.width(), size.height(), GL_COLOR_BUFFER_BIT,
                          GL_NEAREST);
    gl->glBindFramebuffer(GL_FRAMEBUFFER, defaultFramebufferObject());
    m_smooth = true;
}

render::Scene ToothView::scene() const
{
    render::Scene scene;
    scene.eyeFromTooth = m_camera.view();
    scene.clipFromEye = m_camera.projection();
    scene.eyeMm = m_camera.eyeMm();
    scene.towardsLight = towardsLight();
    scene.sizePx = glm::vec2(width() * devicePixelRatioF(), height() * devicePixelRatioF());
    scene.instrumentShown = m_surface != nullptr && m_servo.tick > 0 && !m_instrumentHidden;
    scene.liftMm = m_liftMm;
    scene.burIndex = m_servo.burIndex;
    scene.tipMm = m_servo.anchorMm;
    scene.surfaceBelowTipMm = m_surface ? m_surface->heightMm(glm::dvec2(m_servo.anchorMm)) : 0.0;
    // The hand belongs to the one who looks: the handle stays at the same side when the view turns.
    const glm::dvec2 right = m_camera.rightOnTooth();
    const double towardsViewer = glm::radians(m_leftHanded ? 180.0 + 20.0 : -20.0);
    scene.handAzimuthRad = std::atan2(right.y, right.x) + towardsViewer;
    scene.turnRad = m_turnRad;
    scene.drillOn = m_drillOn;
    return scene;
}

/// How much higher than on a bur held in the air shank and handpiece must be drawn to clear the tooth.
double ToothView::wantedLiftMm() const
{
    if (!m_surface || m_servo.tick == 0 || m_servo.burIndex >= core::drilling::burs().size())
        return 0.0;
    const glm::dvec2 at(m_servo.anchorMm);
    const double tip = m_servo.anchorMm.z;
    const double shank = tip + core::drilling::burs()[m_servo.burIndex].headLengthMm + render::kNeckMm;
    const double chuck = tip + core::drilling::kChuckMm;
    const double lift = std::max(m_surface->highestWithinMm(at, kShankClearMm) - shank,
                                 m_surface->highestWithinMm(at, kHandClearMm) - chuck);
    return std::clamp(lift, 0.0, render::kMostLiftMm);
}

glm::vec3 ToothView::towardsLight() const
{
    // From behind, over the other shoulder than the handpiece: fissures throw their shadows towards the eye.
    const glm::vec3 light = glm::normalize(glm::vec3(-0.45F, 0.22F, 0.87F));
    return m_leftHanded ? glm::vec3(-light.x, light.y, light.z) : light;
}

void ToothView::drawForce()
{
    const double wantedN = m_control.forceN();
    const double forceN = glm::length(m_servo.forceN);
    const bool pushing = m_published.pushing;
    if (!scene().instrumentShown || (!pushing && !m_servo.touching && !m_forceTold))
        return;
    // An arc beside the tip: its whole length is the set force.
    const glm::dvec2 tip = m_camera.pixelOf(m_servo.anchorMm);
    constexpr double kRadiusPx = 44.0;
    constexpr double kHalfDeg = 42.0;
    const QRectF box(tip.x - kRadiusPx, tip.y - kRadiusPx, 2.0 * kRadiusPx, 2.0 * kRadiusPx);
    const double middleDeg = m_leftHanded ? 0.0 : 180.0;
    const double sign = m_leftHanded ? 1.0 : -1.0;  // filled from below on either side
    const auto sixteenths = [](double degrees) { return static_cast<int>(std::lround(16.0 * degrees)); };
    const int start = sixteenths(middleDeg - sign * kHalfDeg);
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const auto arc = [&](QColor colour, double width, double part) {
        painter.setPen(QPen(colour, width, Qt::SolidLine, Qt::RoundCap));
        painter.drawArc(box, start, sixteenths(sign * part * 2.0 * kHalfDeg));
    };
    arc(QColor(16, 18, 20, 150), 9.0, 1.0);
    arc(QColor(255, 255, 255, 60), 4.0, 1.0);
    const double share = std::min(forceN / wantedN, 1.0);
    if (share > 0.02)
        arc(QColor(0x3C, 0xC8, 0xCA), 5.0, share);
    if (m_forceTold) {
        //: A force in newtons, beside the bur
        const QString text = tr("%1 N").arg(QLocale().toString(wantedN, 'f', 1));
        QFont large = font();
        large.setPixelSize(18);
        painter.setFont(large);
        const double width = QFontMetricsF(large).horizontalAdvance(text) + 16.0;
        const QRectF label(m_leftHanded ? tip.x + kRadiusPx + 10.0 : tip.x - kRadiusPx - 10.0 - width, tip.y - 14.0,
                           width, 28.0);
        painter.setPen(Qt::NoPen);
        painter.setBrush(QColor(20, 22, 24, 190));
        painter.drawRoundedRect(label, 6.0, 6.0);
        painter.setPen(QColor(240, 240, 238));
        painter.drawText(label, Qt::AlignCenter, text);
    }
}

void ToothView::advanceFrame()
{
    const double seconds = std::min(0.1, static_cast<double>(m_sinceFrame.nsecsElapsed()) * 1.0e-9);
    m_sinceFrame.start();
    const core::session::ServoState before = m_servo;
    m_servo = m_links.servo.latest();
    if (m_servo.burIndex != before.burIndex && m_servo.burIndex < core::drilling::burs().size())
        m_control.setBurRadius(core::drilling::burs()[m_servo.burIndex].headRadiusMm);
    takePatches();
    moveByKeys(seconds);
    publishPointer();
    if (m_camera.advance(seconds))
        update();
    const double lift = wantedLiftMm();
    const double rest = (m_liftMm - lift) * std::exp(-seconds / kLiftFollowS);
    if (const double next = std::abs(rest) < 0.01 ? lift : lift + rest; next != m_liftMm) {
        m_liftMm = next;
        update();
    }
    if (m_forceTold && m_sinceForceSet.elapsed() > kForceToldMs) {
        m_forceTold = false;
        update();
    }
    // Below a hundredth of a newton and two micrometres nothing shows.
    const bool moved = glm::distance(m_servo.anchorMm, m_paintedAnchorMm) > 0.002;
    const bool pressed = std::abs(glm::length(m_servo.forceN) - m_paintedForceN) > 0.01;
    if (moved || pressed || m_servo.burIndex != before.burIndex || m_servo.touching != before.touching ||
        (m_servo.tick > 0) != (before.tick > 0)) {
        m_paintedAnchorMm = m_servo.anchorMm;
        m_paintedForceN = glm::length(m_servo.forceN);
        update();
    }
    if (m_usable && !m_smooth && m_sincePaint.isValid() && m_sincePaint.elapsed() > kStillMs) {
        m_smoothWanted = true;
        update();
    }
    emit frameAdvanced(m_servo);
}

void ToothView::takePatches()
{
    for (core::session::TilePatch patch; m_links.patches.tryPop(patch);)
        m_inbox.take(patch);
    if (m_inbox.complete().empty() || !m_surface)
        return;
    for (const core::session::TilePatch& patch : m_inbox.complete()) {
        m_surface->write(patch);
        write(patch, *m_tooth);
    }
    ++m_toothRevision;
    m_inbox.complete().clear();
    takeChanges();
}

void ToothView::takeChanges()
{
    const render::ToothSurface::Changes changes = m_surface->refresh();
    m_changes.heights = united(m_changes.heights, changes.heights);
    m_changes.shading = united(m_changes.shading, changes.shading);
    m_changes.outline = m_changes.outline || changes.outline;
    update();
}

void ToothView::publishPointer()
{
    const core::session::PointerInput wish =
        m_control.input(m_servo.tick > 0 ? std::optional(m_servo.anchorMm) : std::nullopt);
    const bool same = wish.targetMm == m_published.targetMm && wish.hoverMm == m_published.hoverMm &&
                      wish.pushing == m_published.pushing && wish.pushForceN == m_published.pushForceN;
    if (same)
        return;
    if (wish.pushing != m_published.pushing)
        update();
    m_published = wish;
    m_links.pointer.publish(wish);
}

render::Ray ToothView::rayAt(QPointF position) const
{
    return m_camera.rayThrough(toGlm(position));
}

void ToothView::turnCamera(double azimuthDeg, double elevationDeg)
{
    m_camera.turn(azimuthDeg, elevationDeg);
    update();
}

/// Mouse and pen. Seen from below, the bur is on the far side of the tooth.
void ToothView::pushAt(QPointF position)
{
    const render::Ray ray = rayAt(position);
    if (ray.direction.z >= 0.0) {
        emit pushRefused();
        return;
    }
    m_control.moveTo(ray, m_servo.anchorMm);
    m_control.push(true);
}

void ToothView::mousePressEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton) {
        pushAt(event->position());
        publishPointer();
    } else if (m_turning == Qt::NoButton &&
               (event->button() == Qt::RightButton || event->button() == Qt::MiddleButton)) {
        m_turning = event->button();
        m_turnedAt = event->position();
    } else {
        QOpenGLWidget::mousePressEvent(event);
    }
}

void ToothView::mouseMoveEvent(QMouseEvent* event)
{
    if (m_turning != Qt::NoButton) {
        const QPointF by = event->position() - m_turnedAt;
        m_turnedAt = event->position();
        turnCamera(-kDegreesPerPixel * by.x(), kDegreesPerPixel * by.y());
        return;
    }
    m_control.moveTo(rayAt(event->position()), m_servo.anchorMm);
    publishPointer();
}

void ToothView::mouseReleaseEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton) {
        m_control.push(false);
        publishPointer();
    }
    if (event->button() == m_turning)
        m_turning = Qt::NoButton;
}

void ToothView::mouseDoubleClickEvent(QMouseEvent* event)
{
    // Two quick pecks of the bur on the tooth are no double click.
    if (event->button() == Qt::LeftButton && m_control.meetsTooth(rayAt(event->position())))
        mousePressEvent(event);
    else
        resetCamera();
}

void ToothView::wheelEvent(QWheelEvent* event)
{
    const double notches = event->angleDelta().y() / 120.0;
    if (event->modifiers().testFlag(Qt::ControlModifier)) {
        setPushForce(m_control.forceN() + PointerControl::kStepN * notches);
    } else {
        glm::dvec3 under(0.0);
        const bool onTooth =
            m_surface && m_surface->meet(rayAt(event->position()), under) && m_surface->isTooth(glm::dvec2(under));
        m_camera.zoom(notches, onTooth ? std::optional(under) : std::nullopt);
        update();
    }
    event->accept();
}

void ToothView::tabletEvent(QTabletEvent* event)
{
    if (event->type() == QEvent::TabletPress && event->button() == Qt::LeftButton) {
        pushAt(event->position());
    } else if (event->type() == QEvent::TabletRelease && event->button() == Qt::LeftButton) {
        m_control.push(false);
    } else if (event->type() == QEvent::TabletMove && m_turning == Qt::NoButton && event->buttons() <= Qt::LeftButton) {
        m_control.moveTo(rayAt(event->position()), m_servo.anchorMm);
    } else {
        // Not accepted: Qt makes a mouse event of it, as for the buttons on the pen.
        event->ignore();
        return;
    }
    if (event->buttons().testFlag(Qt::LeftButton))
        m_control.setPressure(std::clamp(event->pressure(), 0.05, 1.0));
    publishPointer();
    event->accept();
}

void ToothView::keyPressEvent(QKeyEvent* event)
{
    const bool control = event->modifiers().testFlag(Qt::ControlModifier);
    m_fine = event->modifiers().testFlag(Qt::ShiftModifier);
    const int key = event->key();
    switch (key) {
    case Qt::Key_Left:
    case Qt::Key_Right:
    case Qt::Key_Up:
    case Qt::Key_Down:
        if (control) {
            turnCamera(key == Qt::Key_Left    ? -kKeyTurnDeg
                       : key == Qt::Key_Right ? kKeyTurnDeg
                                              : 0.0,
                       key == Qt::Key_Up     ? kKeyTurnDeg
                       : key == Qt::Key_Down ? -kKeyTurnDeg
                                             : 0.0);
        } else if (!event->isAutoRepeat()) {
            if (m_arrows.empty())
                m_arrowsHeldS = 0.0;
            m_arrows.insert(key);
            stepByKey(key, m_fine ? kFineStepMm : kKeyStepMm);
            publishPointer();
        }
        break;
    case Qt::Key_PageDown:
        if (!event->isAutoRepeat()) {
            if (m_camera.elevationDeg() > 0.0)
                m_control.push(true);
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
    case Qt::Key_Plus:
    case Qt::Key_Equal:
        m_camera.zoom(1.0);
        update();
        break;
    case Qt::Key_Minus:
        m_camera.zoom(-1.0);
        update();
        break;
    case Qt::Key_Home:
        resetCamera();
        break;
    default:
        QOpenGLWidget::keyPressEvent(event);
    }
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
            QOpenGLWidget::keyReleaseEvent(event);
    }
    publishPointer();
}

void ToothView::focusOutEvent(QFocusEvent* event)
{
    release();
    QOpenGLWidget::focusOutEvent(event);
}

/// Nothing stays pressed when the keys go elsewhere.
void ToothView::release()
{
    m_arrows.clear();
    m_turning = Qt::NoButton;
    m_control.push(false);
    m_control.lift(false);
    publishPointer();
}

void ToothView::stepByKey(int key, double lengthMm)
{
    const glm::dvec2 right = m_camera.rightOnTooth() * lengthMm;
    const glm::dvec2 away = m_camera.awayOnTooth() * lengthMm;
    m_control.moveBy(key == Qt::Key_Left ? -right : key == Qt::Key_Right ? right : key == Qt::Key_Up ? away : -away);
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

void ToothView::fail(const QString& detail)
{
    m_usable = false;
    qWarning("The tooth view cannot be used: %s.", qPrintable(detail));
    const QString sentence = tr("This computer offers no OpenGL 3.3, so the tooth cannot be shown. Install or update "
                                "the graphics driver (on Debian: libgl1-mesa-dri), then start Cusp again.");
    // Found while drawing, the view is in a window already and the sentence lies over it.
    m_sentence = new QLabel(sentence, context() != nullptr ? this : nullptr);
    m_sentence->setWordWrap(true);
    m_sentence->setAlignment(Qt::AlignCenter);
    m_sentence->setMargin(24);
    m_sentence->setAutoFillBackground(true);
    m_sentence->setMinimumSize(minimumSize());
    if (context() != nullptr) {
        m_sentence->setGeometry(rect());
        m_sentence->show();
    }
    setCursor(Qt::ArrowCursor);
}

void ToothView::leaveContext()
{
    if (!m_renderer)
        return;
    makeCurrent();
    m_smoothCanvas.reset();
    m_renderer.reset();
    doneCurrent();
}

}  // namespace ui::tooth
