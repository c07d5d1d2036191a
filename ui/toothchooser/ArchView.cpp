// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/toothchooser/ArchView.h"

#include <algorithm>

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QTransform>

#include "ui/kit/Theme.h"
#include "ui/text/EveryLanguage.h"
#include "ui/text/Texts.h"
#include "ui/toothchooser/ToothOutlines.h"

namespace ui::toothchooser {
namespace {

/// Extent of the picture in mm: both arches with their labels.
constexpr double kWidthMm = 88.0;
constexpr double kHeightMm = 150.0;
/// Distance of the front of each arch from the middle of the picture.
constexpr double kFrontMm = 61.0;
/// Distance of a label from the crown's centre, outwards.
constexpr double kLabelMm = 10.4;
/// Width of the gum ridge below the crowns.
constexpr double kRidgeMm = 15.0;
/// Natural colours, the same in either theme.
constexpr QRgb kIvory = 0xFFF4EEDF;
constexpr QRgb kIvoryHovered = 0xFFFFFFFF;
constexpr QRgb kFissure = 0xFF5E5646;
constexpr QRgb kGumOnLight = 0xFFF3E2DF;
constexpr QRgb kGumOnDark = 0xFF4A3836;
/// Crowns touch each other; drawing them smaller leaves a visible gap.
constexpr double kCrownScale = 0.96;

bool isUpper(int fdi)
{
    return fdi / 10 == 1 || fdi / 10 == 2;
}

bool isOnChoosableSide(int fdi)
{
    return fdi / 10 == 2 || fdi / 10 == 3;
}

}  // namespace

ArchTooth::ArchTooth(int fdi, QWidget* parent) : QAbstractButton(parent), m_fdi(fdi)
{
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setFocusPolicy(Qt::TabFocus);
    setCheckable(true);
    setText(QString::number(fdi));
    //: %1 is the FDI number, %2 the tooth's name
    text::bindTranslation(this, [this, fdi] { setAccessibleName(tr("%1, %2").arg(fdi).arg(text::toothName(fdi))); });
}

ArchView::ArchView(QWidget* parent) : QWidget(parent)
{
    setMouseTracking(true);
    text::bindTranslation(this, [this] { setAccessibleName(tr("Arches")); });
    for (const int quadrant : {1, 2, 3, 4})
        for (int position = 1; position <= 8; ++position) {
            Tooth tooth;
            tooth.fdi = 10 * quadrant + position;
            if (isOnChoosableSide(tooth.fdi)) {
                tooth.button = new ArchTooth(tooth.fdi, this);
                tooth.button->installEventFilter(this);
                connect(tooth.button, &QAbstractButton::clicked, this, [this, fdi = tooth.fdi] { select(fdi); });
            }
            m_teeth.push_back(tooth);
        }
}

void ArchView::setSelected(int fdi)
{
    const Tooth* tooth = toothOf(fdi);
    m_selected = tooth != nullptr && tooth->button != nullptr ? fdi : 0;
    for (const Tooth& each : m_teeth)
        if (each.button != nullptr)
            each.button->setChecked(each.fdi == m_selected);
    update();
}

void ArchView::takeFocus()
{
    const Tooth* tooth = toothOf(m_selected != 0 ? m_selected : 21);
    tooth->button->setFocus(Qt::OtherFocusReason);
}

void ArchView::select(int fdi)
{
    setSelected(fdi);
    emit selectionChanged(m_selected);
}

void ArchView::layOut()
{
    m_pxPerMm = std::min(width() / kWidthMm, height() / kHeightMm);
    const QPointF middle(width() / 2.0, height() / 2.0);
    for (Tooth& tooth : m_teeth) {
        const bool upper = isUpper(tooth.fdi);
        const double side = isOnChoosableSide(tooth.fdi) ? 1.0 : -1.0;
        const int position = tooth.fdi % 10;
        const CrownPicture crown = crownPicture(upper, position);
        const ArchPlace place = archPlace(upper, position);
        // From the arch's frame, with the lips at +y, to the picture. The upper front is at the top, the lower front at
        // the bottom, and the patient's left is on the viewer's right.
        QTransform toPicture;
        toPicture.translate(middle.x(), middle.y());
        toPicture.scale(side * m_pxPerMm, (upper ? -1.0 : 1.0) * m_pxPerMm);
        toPicture.translate(0, kFrontMm);
        QTransform inArch;
        inArch.translate(place.centreMm.x(), place.centreMm.y());
        inArch.rotateRadians(place.angleRad);
        QTransform crownInArch = inArch;
        crownInArch.scale(kCrownScale, kCrownScale);
        tooth.outline = (crownInArch * toPicture).map(crown.outline);
        tooth.grooves = (crownInArch * toPicture).map(crown.grooves);
        tooth.centre = (inArch * toPicture).map(QPointF(0, 0));
        tooth.label = (inArch * toPicture).map(QPointF(0, kLabelMm));
        if (tooth.button != nullptr)
            tooth.button->setGeometry(tooth.outline.boundingRect().toAlignedRect());
    }
}

void ArchView::resizeEvent(QResizeEvent*)
{
    layOut();
}

void ArchView::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QPalette& p = palette();

    // The midline, and the labels of the patient's left and right.
    QColor faint = p.color(QPalette::Mid);
    painter.setPen(QPen(faint, 1, Qt::DashLine));
    const double midX = width() / 2.0;
    painter.drawLine(QPointF(midX, height() / 2.0 - 44 * m_pxPerMm), QPointF(midX, height() / 2.0 + 44 * m_pxPerMm));
    painter.setFont(kit::typeface(kit::kSmall));
    painter.setPen(p.color(QPalette::PlaceholderText));
    const double midY = height() / 2.0;
    painter.drawText(QRectF(midX - 120, midY - 10, 110, 20), Qt::AlignRight | Qt::AlignVCenter, tr("Right"));
    painter.drawText(QRectF(midX + 10, midY - 10, 110, 20), Qt::AlignLeft | Qt::AlignVCenter, tr("Left"));

    // The gum ridges, from the last tooth of the right half to the last of the left.
    for (const bool upper : {true, false}) {
        QPolygonF ridge;
        for (const Tooth& tooth : m_teeth)
            if (isUpper(tooth.fdi) == upper)
                isOnChoosableSide(tooth.fdi) ? ridge.append(tooth.centre) : ridge.prepend(tooth.centre);
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(QColor(kit::isDark(p) ? kGumOnDark : kGumOnLight), kRidgeMm * m_pxPerMm, Qt::SolidLine,
                            Qt::RoundCap, Qt::RoundJoin));
        painter.drawPath(smoothThrough(ridge, false));
    }
    for (const Tooth& tooth : m_teeth) {
        if (tooth.button == nullptr) {
            painter.setOpacity(0.25);
            painter.setPen(QPen(QColor(kFissure), 1));
            painter.setBrush(QColor(kIvory));
            painter.drawPath(tooth.outline);
            painter.setOpacity(1.0);
            continue;
        }
        const bool chosen = tooth.fdi == m_selected;
        const bool hovered = tooth.fdi == m_hovered;
        const bool focused = tooth.button->hasFocus();
        painter.setPen(QPen(chosen ? p.color(QPalette::Link) : QColor(kFissure), chosen ? 2.5 : 1.2));
        painter.setBrush(chosen ? p.color(QPalette::Highlight) : QColor(hovered ? kIvoryHovered : kIvory));
        painter.drawPath(tooth.outline);
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(chosen ? p.color(QPalette::HighlightedText) : QColor(kFissure), 1.3, Qt::SolidLine,
                            Qt::RoundCap, Qt::RoundJoin));
        painter.drawPath(tooth.grooves);
        if (focused) {
            painter.setPen(QPen(p.color(QPalette::WindowText), 2, Qt::DotLine));
            QTransform larger;
            const QPointF centre = tooth.outline.boundingRect().center();
            larger.translate(centre.x(), centre.y());
            larger.scale(1.13, 1.13);
            larger.translate(-centre.x(), -centre.y());
            painter.drawPath(larger.map(tooth.outline));
        }
        painter.setFont(kit::typeface(kit::kBody, chosen ? QFont::Bold : QFont::Normal));
        painter.setPen(p.color(chosen ? QPalette::Link : QPalette::WindowText));
        painter.drawText(QRectF(tooth.label.x() - 20, tooth.label.y() - 10, 40, 20), Qt::AlignCenter,
                         QString::number(tooth.fdi));
    }
}

const ArchView::Tooth* ArchView::toothAt(QPointF where) const
{
    const auto found = std::find_if(m_teeth.begin(), m_teeth.end(), [&](const Tooth& tooth) {
        return tooth.button != nullptr && tooth.outline.contains(where);
    });
    return found == m_teeth.end() ? nullptr : &*found;
}

const ArchView::Tooth* ArchView::toothOf(int fdi) const
{
    const auto found = std::find_if(m_teeth.begin(), m_teeth.end(), [&](const Tooth& t) { return t.fdi == fdi; });
    return found == m_teeth.end() ? nullptr : &*found;
}

void ArchView::mouseMoveEvent(QMouseEvent* event)
{
    const Tooth* tooth = toothAt(event->position());
    const int hovered = tooth != nullptr ? tooth->fdi : 0;
    if (hovered == m_hovered)
        return;
    m_hovered = hovered;
    setCursor(hovered != 0 ? Qt::PointingHandCursor : Qt::ArrowCursor);
    setToolTip(hovered != 0 ? text::toothName(hovered) : QString());
    update();
}

void ArchView::mousePressEvent(QMouseEvent* event)
{
    if (const Tooth* tooth = toothAt(event->position())) {
        select(tooth->fdi);
        takeFocus();
    }
}

void ArchView::mouseDoubleClickEvent(QMouseEvent* event)
{
    if (const Tooth* tooth = toothAt(event->position()))
        emit toothActivated(tooth->fdi);
}

void ArchView::leaveEvent(QEvent*)
{
    m_hovered = 0;
    update();
}

bool ArchView::eventFilter(QObject* watched, QEvent* event)
{
    auto* button = qobject_cast<ArchTooth*>(watched);
    if (button == nullptr)
        return QWidget::eventFilter(watched, event);
    if (event->type() == QEvent::FocusIn || event->type() == QEvent::FocusOut)
        update();
    if (event->type() != QEvent::KeyPress)
        return QWidget::eventFilter(watched, event);
    const int quadrant = button->fdi() / 10;
    const int position = button->fdi() % 10;
    int next = 0;
    switch (dynamic_cast<QKeyEvent*>(event)->key()) {
    case Qt::Key_Right:
        next = 10 * quadrant + std::min(8, position + 1);
        break;
    case Qt::Key_Left:
        next = 10 * quadrant + std::max(1, position - 1);
        break;
    case Qt::Key_Up:
        next = 20 + position;
        break;
    case Qt::Key_Down:
        next = 30 + position;
        break;
    case Qt::Key_Return:
    case Qt::Key_Enter:
        emit toothActivated(button->fdi());
        return true;
    default:
        return QWidget::eventFilter(watched, event);
    }
    if (const Tooth* tooth = toothOf(next)) {
        tooth->button->setFocus(Qt::TabFocusReason);
        select(next);
    }
    return true;
}

}  // namespace ui::toothchooser
