// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lessoneditor/ToleranceView.h"

#include <numbers>

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include "ui/catalog/LessonScene.h"
#include "ui/inside/SectionPainter.h"
#include "ui/kit/Theme.h"
#include "ui/text/EveryLanguage.h"

namespace ui::lessoneditor {
namespace {

constexpr double kRowGapPx = 4.0;
constexpr double kTurnDeg = 15.0;
constexpr double kStepMm = 0.2;

}  // namespace

ToleranceView::ToleranceView(QWidget* parent) : QWidget(parent)
{
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    text::bindTranslation(this, [this] {
        setAccessibleName(tr("The tolerances on the tooth"));
        setToolTip(ui::kit::brokenIntoLines(
            tr("Drag the line of the section; arrow keys move it, Shift with them turns it, as a double click does")));
    });
}

void ToleranceView::show(std::shared_ptr<const EvaluatedDraft> weighed)
{
    const auto anatomyOf = [](const std::shared_ptr<const EvaluatedDraft>& of) {
        return of && of->assignment ? of->assignment->anatomy.get() : nullptr;
    };
    const bool isSameTooth = anatomyOf(weighed) == anatomyOf(m_weighed);
    m_weighed = std::move(weighed);
    if (!isSameTooth && anatomyOf(m_weighed) != nullptr) {
        const auto& assignment = *m_weighed->assignment;
        m_whole.emplace(assignment.anatomy);
        m_plane = assignment.ideal
                      ? catalog::planeThroughIdeal(*assignment.anatomy, *assignment.ideal)
                      : core::imaging::SectionPlane{assignment.anatomy->grid.middleMm(), 0.5 * std::numbers::pi};
    }
    update();
}

QRectF ToleranceView::aboveArea() const
{
    const QRectF all(rect());
    return width() >= height() ? QRectF(all.left(), all.top(), 0.5 * all.width() - kRowGapPx, all.height())
                               : QRectF(all.left(), all.top(), all.width(), 0.5 * all.height() - kRowGapPx);
}

QRectF ToleranceView::sectionArea() const
{
    const QRectF all(rect());
    return width() >= height() ? QRectF(all.left() + 0.5 * all.width() + kRowGapPx, all.top(),
                                        0.5 * all.width() - kRowGapPx, all.height())
                               : QRectF(all.left(), all.top() + 0.5 * all.height() + kRowGapPx, all.width(),
                                        0.5 * all.height() - kRowGapPx);
}

void ToleranceView::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    if (!m_weighed || !m_weighed->assignment || !m_whole) {
        painter.setPen(palette().color(QPalette::PlaceholderText));
        painter.setFont(kit::typeface(kit::kBody));
        painter.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap,
                         m_weighed ? tr("Nothing to show yet: what is wrong is said at the left.")
                                   : tr("The ideal is being made …"));
        return;
    }
    const ::lessons::Assignment& assignment = *m_weighed->assignment;
    inside::paintOutline(
        painter, aboveArea(),
        {assignment.anatomy.get(), &m_weighed->above, m_weighed->outlineMm, m_weighed->spanMm, m_plane});
    inside::SectionScene section;
    section.tooth = &*m_whole;
    section.plane = m_plane;
    section.ideal = assignment.shownIdeal();
    section.band = m_weighed->band ? &*m_weighed->band : nullptr;
    inside::paintSection(painter, sectionArea(), section);
    if (hasFocus()) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(palette().color(QPalette::Link), 2));
        painter.drawRect(QRectF(rect()).adjusted(1, 1, -1, -1));
    }
}

void ToleranceView::drag(const QPointF& place)
{
    if (!m_weighed || !m_weighed->assignment || !aboveArea().contains(place))
        return;
    const QPointF mm = inside::mmAt(aboveArea(), m_weighed->above, place);
    m_plane.throughMm = {mm.x(), mm.y()};
    update();
}

void ToleranceView::turn(double degrees)
{
    m_plane.angleRad += degrees * std::numbers::pi / 180.0;
    update();
}

void ToleranceView::mousePressEvent(QMouseEvent* event)
{
    drag(event->position());
}

void ToleranceView::mouseMoveEvent(QMouseEvent* event)
{
    if (event->buttons().testFlag(Qt::LeftButton))
        drag(event->position());
}

void ToleranceView::mouseDoubleClickEvent(QMouseEvent*)
{
    turn(90.0);
}

void ToleranceView::wheelEvent(QWheelEvent* event)
{
    turn(event->angleDelta().y() > 0 ? kTurnDeg : -kTurnDeg);
    event->accept();
}

void ToleranceView::keyPressEvent(QKeyEvent* event)
{
    const bool isForward = event->key() == Qt::Key_Right || event->key() == Qt::Key_Up;
    if (!isForward && event->key() != Qt::Key_Left && event->key() != Qt::Key_Down) {
        QWidget::keyPressEvent(event);
        return;
    }
    const double sign = isForward ? 1.0 : -1.0;
    if (event->modifiers().testFlag(Qt::ShiftModifier)) {
        turn(sign * kTurnDeg);
        return;
    }
    const glm::dvec2 along = m_plane.direction();
    m_plane.throughMm += sign * kStepMm * glm::dvec2(along.y, -along.x);
    update();
}

}  // namespace ui::lessoneditor
