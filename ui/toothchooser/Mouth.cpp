// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/toothchooser/Mouth.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/mat3x3.hpp>

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include "ui/kit/Theme.h"
#include "ui/render/Driver.h"
#include "ui/render/Gizmo.h"
#include "ui/text/EveryLanguage.h"
#include "ui/text/Texts.h"
#include "ui/tooth/ViewMarks.h"

namespace ui::toothchooser {
namespace {

constexpr double kDegreesPerPixel = 0.35;
constexpr double kKeyTurnDeg = 5.0;
constexpr int kFrameMs = 16;
constexpr int kGizmoPx = 46;

bool isChoosable(int fdi)
{
    return fdi != 0 && core::teeth::leftFellow(fdi) == fdi;
}

}  // namespace

Mouth::Mouth(QWidget* parent)
    : SceneWidget([] { return tr("This computer cannot draw the whole mouth. Use the flat arches instead."); },
                  bestWay(), parent)
{
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setMinimumSize(260, 240);
    text::bindTranslation(this, [this] {
        setAccessibleName(tr("Whole mouth"));
        setSelected(m_selected);
    });
    m_zooming.setInterval(kFrameMs);
    connect(&m_zooming, &QTimer::timeout, this, [this] {
        const double seconds = std::min(0.1, static_cast<double>(m_sinceZoom.nsecsElapsed()) * 1.0e-9);
        m_sinceZoom.start();
        if (!m_camera.advance(seconds))
            m_zooming.stop();
        redraw();
    });
}

Mouth::~Mouth()
{
    leave();
}

bool Mouth::isPossible()
{
    return render::driver().hasOpenGl33;
}

void Mouth::showEvent(QShowEvent* event)
{
    SceneWidget::showEvent(event);
    if (!m_arch)
        render::withArch(this, [this](const render::ArchPointer& arch) { take(arch); });
}

void Mouth::take(const render::ArchPointer& arch)
{
    m_arch = arch;
    m_pieces = arch->mouth(tooth::kMouthOpenRad);
    m_camera.setStart(tooth::kMouthAzimuthDeg);
    m_camera.set(tooth::kMouthAzimuthDeg, tooth::kMouthElevationDeg, m_camera.distanceMm());
    m_piecesAreNew = true;
    showJaws();
    emit ready();
}

/// Hides the jaw that covers the other one, and aims the camera at the rest.
void Mouth::showJaws()
{
    const double elevation = m_camera.elevationDeg();
    const tooth::Jaws jaws = tooth::jawsSeen(elevation);
    redraw();
    if (jaws == m_jawsShown)
        return;
    m_jawsShown = jaws;
    m_shown = tooth::piecesOf(m_pieces, jaws);
    const double closeness = m_camera.distanceMm() / m_camera.fittingMm();
    const double azimuth = m_camera.azimuthDeg();
    tooth::showPieces(m_camera, m_shown);
    m_camera.set(azimuth, elevation, (m_fitted ? 1.0 : closeness) * m_camera.fittingMm());
}

void Mouth::setSelected(int fdi)
{
    m_selected = isChoosable(fdi) ? fdi : 0;
    setAccessibleDescription(m_selected == 0 ? tr("Arrow keys move along the arch, Enter selects the tooth.")
                                             : tr("%1, %2").arg(m_selected).arg(text::toothName(m_selected)));
    redraw();
}

void Mouth::select(int fdi)
{
    setSelected(fdi);
    emit selectionChanged(m_selected);
}

/// Selects a tooth by keyboard. If its jaw is hidden, turns the view so that the jaw is visible.
void Mouth::walkTo(int fdi)
{
    if (m_arch && core::teeth::jawOf(fdi) == core::teeth::Jaw::Upper && !tooth::jawsSeen(m_camera.elevationDeg()).upper)
        turn(0.0, -tooth::kMouthElevationDeg - m_camera.elevationDeg());
    if (m_arch && core::teeth::jawOf(fdi) == core::teeth::Jaw::Lower && !tooth::jawsSeen(m_camera.elevationDeg()).lower)
        turn(0.0, tooth::kMouthElevationDeg - m_camera.elevationDeg());
    select(fdi);
}

void Mouth::hover(int fdi)
{
    if (fdi == m_hovered)
        return;
    m_hovered = fdi;
    setCursor(isChoosable(fdi) ? Qt::PointingHandCursor : Qt::ArrowCursor);
    redraw();
}

bool Mouth::prepareScene(QString& reason)
{
    m_renderer = std::make_unique<render::ArchRenderer>();
    m_piecesAreNew = true;
    return m_renderer->initialize(reason);
}

void Mouth::releaseScene()
{
    m_renderer.reset();
}

void Mouth::resizeEvent(QResizeEvent* event)
{
    SceneWidget::resizeEvent(event);
    m_camera.setViewport({width(), height()});
    if (m_fitted)
        m_camera.set(m_camera.azimuthDeg(), m_camera.elevationDeg(), m_camera.fittingMm());
}

render::ArchScene Mouth::scene() const
{
    render::ArchScene scene = tooth::mouthThrough(m_camera);
    scene.hoveredFdi = m_hovered;
    scene.chosenFdi = m_selected;
    return scene;
}

void Mouth::drawScene(QSize sizePx, int /*samples*/)
{
    if (m_arch && std::exchange(m_piecesAreNew, false))
        m_renderer->setPieces(m_pieces);
    if (m_arch)
        m_renderer->setPieces(m_shown);
    m_renderer->drawRoom({static_cast<float>(sizePx.width()), static_cast<float>(sizePx.height())}, {0.0F, 0.0F});
    if (m_arch)
        m_renderer->draw(scene());
}

void Mouth::paintMarks(QPainter& painter)
{
    painter.setRenderHint(QPainter::Antialiasing);
    const QPalette room = kit::roomPalette();
    const auto write = [&](const QRectF& where, int flags, const QString& words, const QFont& font,
                           QPalette::ColorRole role) {
        painter.setFont(font);
        painter.setPen(room.color(role));
        painter.drawText(where, flags, words);
    };
    const QRectF all = QRectF(rect()).adjusted(kit::kSpace4, kit::kSpace4, -kit::kSpace4, -kit::kSpace4);
    if (!m_arch) {
        write(all, Qt::AlignCenter | Qt::TextWordWrap, tr("Creating the teeth …"), kit::typeface(kit::kBody),
              QPalette::WindowText);
        return;
    }
    const auto plate = [&](const QRectF& where) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(QColor(20, 22, 24, 190));
        painter.drawRoundedRect(where, kit::kRadius, kit::kRadius);
    };
    const int told = m_hovered != 0 ? m_hovered : m_selected;
    if (told != 0) {
        const QString name = text::capitalised(text::toothName(told));
        const QString offer = isChoosable(told)
                                  ? told == m_selected ? tr("Selected. Press Enter or double-click to use it.")
                                                       : tr("Click to select it.")
                                  //: %1 is the FDI number of the tooth on the other side
                                  : tr("Only teeth of the left side can be drilled; %1 is its mirror image.")
                                        .arg(core::teeth::leftFellow(told));
        const QFontMetricsF small(kit::typeface(kit::kSmall));
        const double width =
            std::max(small.horizontalAdvance(offer), QFontMetricsF(kit::typeface(kit::kBody)).horizontalAdvance(name));
        const double lines = small.boundingRect(all, Qt::TextWordWrap, offer).height() / small.height();
        plate({all.left() - kit::kSpace2, all.top() - kit::kSpace2, std::min(width, all.width()) + 2 * kit::kSpace2 + 1,
               76.0 + std::ceil(lines - 0.5) * small.height()});
        write(all, Qt::AlignLeft | Qt::AlignTop, QString::number(told), kit::typeface(kit::kFigure, QFont::DemiBold),
              QPalette::WindowText);
        write(all.adjusted(0, 36, 0, 0), Qt::AlignLeft | Qt::AlignTop, name, kit::typeface(kit::kBody),
              QPalette::WindowText);
        write(all.adjusted(0, 58, 0, 0), Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap, offer,
              kit::typeface(kit::kSmall), QPalette::PlaceholderText);
    }
    write(all.adjusted(0, 0, -2 * kGizmoPx - kit::kSpace4, 0), Qt::AlignLeft | Qt::AlignBottom | Qt::TextWordWrap,
          tr("Right button turns, wheel zooms. From above or below you see one jaw."), kit::typeface(kit::kSmall),
          QPalette::PlaceholderText);

    // The number beside the tooth, so that the selection is not shown by colour alone.
    if (pieceOf(m_selected) != nullptr) {
        const QPointF at = placeOf(m_selected);
        const QRectF label(at.x() - 17.0, at.y() - 11.0, 34.0, 22.0);
        plate(label);
        write(label, Qt::AlignCenter, QString::number(m_selected), kit::typeface(kit::kBody, QFont::DemiBold),
              QPalette::WindowText);
    }
    if (const core::teeth::ArchPiece* piece = pieceOf(told); piece != nullptr) {
        render::paintGizmo(painter, QPointF(width() - kGizmoPx - kit::kSpace4, height() - kGizmoPx - kit::kSpace4),
                           kGizmoPx, glm::dmat3(m_camera.view() * piece->place),
                           tooth::gizmoLetters(core::teeth::leftFellow(told)));
    }
    if (hasFocus()) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(room.color(QPalette::Link), 2));
        painter.drawRect(QRectF(rect()).adjusted(1, 1, -1, -1));
    }
}

const core::teeth::ArchPiece* Mouth::pieceOf(int fdi) const
{
    const auto found = std::find_if(m_shown.begin(), m_shown.end(), [&](const core::teeth::ArchPiece& piece) {
        return fdi != 0 && piece.tooth && piece.fdi == fdi;
    });
    return found == m_shown.end() ? nullptr : &*found;
}

QPointF Mouth::placeOf(int fdi) const
{
    const core::teeth::ArchPiece* piece = pieceOf(fdi);
    if (piece == nullptr)
        return {};
    const glm::dvec2 at = m_camera.pixelOf(tooth::crownMiddleMm(*piece));
    return {at.x, at.y};
}

int Mouth::toothAt(QPointF position) const
{
    return render::toothMet(m_shown, m_camera.rayThrough({position.x(), position.y()}));
}

void Mouth::turn(double azimuthDeg, double elevationDeg)
{
    m_camera.turn(azimuthDeg, elevationDeg);
    showJaws();
}

void Mouth::zoom(double steps)
{
    m_fitted = false;
    m_camera.zoom(steps);
    if (m_movesLittle) {
        m_camera.advance(tooth::kAtOnceS);
        redraw();
        return;
    }
    m_sinceZoom.start();
    m_zooming.start();
}

void Mouth::mousePressEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton) {
        if (const int fdi = toothAt(event->position()); isChoosable(fdi))
            select(fdi);
    } else if (m_turning == Qt::NoButton &&
               (event->button() == Qt::RightButton || event->button() == Qt::MiddleButton)) {
        m_turning = event->button();
        m_turnedAt = event->position();
    }
}

void Mouth::mouseMoveEvent(QMouseEvent* event)
{
    if (m_turning == Qt::NoButton) {
        hover(toothAt(event->position()));
        return;
    }
    const QPointF by = event->position() - m_turnedAt;
    m_turnedAt = event->position();
    turn(-kDegreesPerPixel * by.x(), kDegreesPerPixel * by.y());
}

void Mouth::mouseReleaseEvent(QMouseEvent* event)
{
    if (event->button() == m_turning)
        m_turning = Qt::NoButton;
}

void Mouth::mouseDoubleClickEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton)
        return;
    if (const int fdi = toothAt(event->position()); isChoosable(fdi))
        emit toothActivated(fdi);
}

void Mouth::wheelEvent(QWheelEvent* event)
{
    zoom(event->angleDelta().y() / 120.0);
    event->accept();
}

void Mouth::leaveEvent(QEvent*)
{
    hover(0);
}

void Mouth::keyPressEvent(QKeyEvent* event)
{
    const int key = event->key();
    const bool arrow = key == Qt::Key_Left || key == Qt::Key_Right || key == Qt::Key_Up || key == Qt::Key_Down;
    if (arrow && event->modifiers().testFlag(Qt::ControlModifier)) {
        turn(key == Qt::Key_Left    ? -kKeyTurnDeg
             : key == Qt::Key_Right ? kKeyTurnDeg
                                    : 0.0,
             key == Qt::Key_Up     ? kKeyTurnDeg
             : key == Qt::Key_Down ? -kKeyTurnDeg
                                   : 0.0);
        return;
    }
    const int position = m_selected % 10;
    const int quadrant = m_selected / 10;
    switch (key) {
    case Qt::Key_Left:
    case Qt::Key_Right:
        walkTo(m_selected == 0 ? 21 : 10 * quadrant + std::clamp(position + (key == Qt::Key_Right ? 1 : -1), 1, 8));
        break;
    case Qt::Key_Up:
        walkTo(m_selected == 0 ? 21 : 20 + position);
        break;
    case Qt::Key_Down:
        walkTo(m_selected == 0 ? 31 : 30 + position);
        break;
    case Qt::Key_Return:
    case Qt::Key_Enter:
        if (m_selected != 0)
            emit toothActivated(m_selected);
        break;
    case Qt::Key_Plus:
    case Qt::Key_Equal:
        zoom(1.0);
        break;
    case Qt::Key_Minus:
        zoom(-1.0);
        break;
    case Qt::Key_Home:
        m_fitted = true;
        m_camera.set(tooth::kMouthAzimuthDeg, tooth::kMouthElevationDeg, m_camera.fittingMm());
        showJaws();
        break;
    default:
        SceneWidget::keyPressEvent(event);
    }
}

void Mouth::focusInEvent(QFocusEvent* event)
{
    SceneWidget::focusInEvent(event);
    redraw();
}

void Mouth::focusOutEvent(QFocusEvent* event)
{
    SceneWidget::focusOutEvent(event);
    m_turning = Qt::NoButton;
    redraw();
}

}  // namespace ui::toothchooser
