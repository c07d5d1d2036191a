// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tooth/ExerciseMarks.h"

#include <algorithm>
#include <utility>

#include <QCoreApplication>
#include <QPainterPath>

namespace ui::tooth {
namespace {

const QColor kHalo(16, 18, 20, 170);
const QColor kWords(240, 240, 238);
const QColor kQuietWords(178, 182, 186);
const QColor kRing(250, 250, 248);
const QColor kPin(77, 201, 195);
constexpr double kPinPx = 26.0;     ///< distance from a pin's tip to the middle of its head
constexpr double kPinHeadPx = 6.5;  ///< radius of the head
const QColor kTouched(0x0F, 0x8B, 0x8D);
const QColor kPointer(0x3C, 0xC8, 0xCA);
const QColor kGround(38, 40, 43);
const QColor kPad(58, 61, 65);
const QColor kPadEdge(128, 133, 138);
constexpr double kLeastRadiusPx = 9.0;
constexpr double kSpotPx = 8.0;
constexpr double kScaleTopMm = 1.0;
constexpr double kScaleBottomMm = -3.0;
constexpr double kScaleShare = 0.35;  ///< length of the scale, as a share of the view's height
constexpr double kLeastScalePx = 80.0;
constexpr double kMostScalePx = 200.0;
constexpr double kMarginPx = 20.0;

}  // namespace

void paintPoint(QPainter& painter, QPointF at, double radiusPx, bool isTouched, bool isHidden)
{
    const double radius = std::max(kLeastRadiusPx, radiusPx);
    painter.setBrush(Qt::NoBrush);
    if (isTouched) {
        painter.setPen(QPen(kRing, 2.0));
        painter.setBrush(kTouched);
        painter.drawEllipse(at, radius, radius);
        painter.setPen(QPen(kRing, 0.22 * radius, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        const QPointF tick[] = {at + radius * QPointF(-0.42, 0.02), at + radius * QPointF(-0.1, 0.34),
                                at + radius * QPointF(0.44, -0.32)};
        painter.drawPolyline(tick, 3);
        return;
    }
    painter.setPen(QPen(kHalo, 6.0));
    painter.drawEllipse(at, radius, radius);
    painter.setPen(QPen(kRing, 2.5, isHidden ? Qt::DotLine : Qt::SolidLine));
    painter.drawEllipse(at, radius, radius);
    if (isHidden)
        return;
    painter.setPen(QPen(kHalo, 1.5));
    painter.setBrush(kRing);
    painter.drawEllipse(at, 3.0, 3.0);
}

void paintPin(QPainter& painter, QPointF at, bool isHidden)
{
    const QPointF head = at - QPointF(0.0, kPinPx);
    for (const auto& [colour, wide] : {std::pair(kHalo, 5.0), std::pair(kPin, 2.0)}) {
        painter.setPen(QPen(colour, wide, isHidden ? Qt::DotLine : Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(at, head);
    }
    painter.setPen(QPen(kHalo, 2.0));
    painter.setBrush(isHidden ? Qt::NoBrush : QBrush(kPin));
    painter.drawEllipse(head, kPinHeadPx, kPinHeadPx);
    if (!isHidden)
        return;
    painter.setPen(QPen(kPin, 2.0));
    painter.drawEllipse(head, kPinHeadPx - 1.5, kPinHeadPx - 1.5);
}

void paintBlindfold(QPainter& painter, const QRectF& view)
{
    painter.fillRect(view, kGround);
}

void paintPad(QPainter& painter, const QPolygonF& outline, const QString& name)
{
    painter.setPen(QPen(kPadEdge, 2.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.setBrush(kPad);
    painter.drawPolygon(outline);
    QFont font = painter.font();
    font.setPixelSize(18);
    painter.setFont(font);
    painter.setPen(kWords);
    const QRectF around = outline.boundingRect();
    const double wide = QFontMetricsF(font).horizontalAdvance(name) + 4.0;
    painter.drawText(QRectF(around.center().x() - 0.5 * wide, around.top() - 34.0, wide, 28.0), Qt::AlignCenter, name);
}

void paintBurSpot(QPainter& painter, QPointF at, bool isTouching)
{
    painter.setPen(QPen(kHalo, 6.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(at, kSpotPx, kSpotPx);
    painter.setPen(QPen(kPointer, 2.5));
    if (isTouching)
        painter.setBrush(kPointer);
    painter.drawEllipse(at, kSpotPx, kSpotPx);
}

void paintHeight(QPainter& painter, QSizeF view, double heightMm)
{
    const double high = std::clamp(kScaleShare * view.height(), kLeastScalePx, kMostScalePx);
    //: Title of a scale: how high the bur's tip stands over the block
    const QString title = QCoreApplication::translate("ExerciseMarks", "height, mm");
    QFont font = painter.font();
    font.setPixelSize(14);
    painter.setFont(font);
    const double wide = std::max(74.0, QFontMetricsF(font).horizontalAdvance(title) + 20.0);
    const QRectF plate(kMarginPx, kMarginPx, wide, high + 52.0);
    const double top = plate.top() + 38.0;
    const auto level = [&](double mm) {
        const double share = (kScaleTopMm - mm) / (kScaleTopMm - kScaleBottomMm);
        return top + std::clamp(share, 0.0, 1.0) * high;
    };
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(20, 22, 24, 230));
    painter.drawRoundedRect(plate, 6.0, 6.0);
    painter.setPen(kWords);
    painter.drawText(QRectF(plate.left(), plate.top() + 6.0, wide, 20.0), Qt::AlignCenter, title);
    const double x = plate.left() + 24.0;
    painter.setPen(QPen(kPadEdge, 2.0));
    painter.drawLine(QPointF(x, top), QPointF(x, top + high));
    for (int mm = static_cast<int>(kScaleBottomMm); mm <= static_cast<int>(kScaleTopMm); ++mm) {
        const double y = level(mm);
        painter.setPen(QPen(kPadEdge, mm == 0 ? 2.5 : 1.0));
        painter.drawLine(QPointF(x, y), QPointF(x + 10.0, y));
        painter.setPen(kQuietWords);
        const QString figure = mm < 0 ? QChar(0x2212) + QString::number(-mm) : QString::number(mm);
        painter.drawText(QRectF(x + 16.0, y - 10.0, 28.0, 20.0), Qt::AlignLeft | Qt::AlignVCenter, figure);
    }
    const double y = level(heightMm);
    QPainterPath pointer(QPointF(x + 1.0, y));
    pointer.lineTo(x - 11.0, y - 7.0);
    pointer.lineTo(x - 11.0, y + 7.0);
    pointer.closeSubpath();
    painter.setPen(Qt::NoPen);
    painter.setBrush(kPointer);
    painter.drawPath(pointer);
    painter.drawRect(QRectF(x, y - 1.5, 12.0, 3.0));
}

}  // namespace ui::tooth
