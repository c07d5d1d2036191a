// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tooth/ViewMarks.h"

#include <algorithm>
#include <cmath>

#include <QCoreApplication>
#include <QLinearGradient>
#include <QLocale>
#include <QPainterPath>

namespace ui::tooth {
namespace {

const QColor kPlate(20, 22, 24, 190);
const QColor kWords(240, 240, 238);
constexpr int kWordsPx = 14;
constexpr double kArrowInPx = 26.0;  ///< from the edge of the view
constexpr double kShaftPx = 9.0;
constexpr double kHeadPx = 26.0;
constexpr double kScaleWide = 14.0;
constexpr double kScaleHigh = 150.0;
constexpr double kMargin = 20.0;
constexpr int kSteps = 3;

QFont wordsFont(const QPainter& painter)
{
    QFont font = painter.font();
    font.setPixelSize(kWordsPx);
    return font;
}

}  // namespace

void paintArrowOut(QPainter& painter, QSizeF view, QPointF from, QPointF towards)
{
    const QRectF inside(kArrowInPx, kArrowInPx, std::max(1.0, view.width() - 2.0 * kArrowInPx),
                        std::max(1.0, view.height() - 2.0 * kArrowInPx));
    const auto clamped = [&](QPointF at) {
        return QPointF(std::clamp(at.x(), inside.left(), inside.right()),
                       std::clamp(at.y(), inside.top(), inside.bottom()));
    };
    const QPointF end = clamped(towards);
    QPointF start = clamped(from);
    QPointF way = towards - start;
    const double whole = std::hypot(way.x(), way.y());
    if (whole < 1.0)
        return;
    way /= whole;
    // At least its head is seen, even if the bur has left as well.
    const double length = std::max(1.6 * kHeadPx, std::hypot(end.x() - start.x(), end.y() - start.y()));
    start = end - way * length;
    const QPointF aside(-way.y(), way.x());
    const QPointF neck = end - way * kHeadPx;
    QPainterPath arrow(end);
    arrow.lineTo(neck + aside * kHeadPx * 0.6);
    arrow.lineTo(neck + aside * kShaftPx * 0.5);
    arrow.lineTo(start + aside * kShaftPx * 0.5);
    arrow.lineTo(start - aside * kShaftPx * 0.5);
    arrow.lineTo(neck - aside * kShaftPx * 0.5);
    arrow.lineTo(neck - aside * kHeadPx * 0.6);
    arrow.closeSubpath();
    painter.setPen(QPen(QColor(255, 255, 255, 90), 1.0));
    painter.setBrush(QColor(198, 64, 43, 130));
    painter.drawPath(arrow);
}

void paintDepthScale(QPainter& painter, QSizeF view, double endMm)
{
    // Half way up: below, a hint or the bar of a replay may lie over the view.
    const QRectF bar(kMargin + 8.0, 0.5 * (view.height() - kScaleHigh), kScaleWide, kScaleHigh);
    painter.setFont(wordsFont(painter));
    const QFontMetricsF words(painter.font());
    const QString title = QCoreApplication::translate("ViewMarks", "depth, mm");
    const double wide = std::max(words.horizontalAdvance(title), kScaleWide + 44.0);
    painter.setPen(Qt::NoPen);
    painter.setBrush(kPlate);
    painter.drawRoundedRect(QRectF(bar.left() - 10.0, bar.top() - 34.0, wide + 20.0, kScaleHigh + 46.0), 6.0, 6.0);
    QLinearGradient colours(bar.topLeft(), bar.bottomLeft());
    // As in tooth.frag, after its tone curve.
    colours.setColorAt(0.0, QColor(102, 158, 214));
    colours.setColorAt(0.5, QColor(240, 240, 236));
    colours.setColorAt(1.0, QColor(216, 104, 52));
    painter.setBrush(colours);
    painter.drawRoundedRect(bar, 3.0, 3.0);
    painter.setPen(kWords);
    painter.drawText(QPointF(bar.left(), bar.top() - 14.0), title);
    for (int k = 0; k <= kSteps; ++k) {
        const double share = static_cast<double>(k) / kSteps;
        const double y = bar.top() + share * kScaleHigh;
        painter.drawLine(QPointF(bar.right(), y), QPointF(bar.right() + 5.0, y));
        painter.drawText(QPointF(bar.right() + 9.0, y + 0.36 * kWordsPx), QLocale().toString(endMm * share, 'f', 1));
    }
}

void paintPlate(QPainter& painter, QPointF beside, const QString& text, bool onTheLeft)
{
    painter.setFont(wordsFont(painter));
    const double width = QFontMetricsF(painter.font()).horizontalAdvance(text) + 16.0;
    const QRectF plate(onTheLeft ? beside.x() - width : beside.x(), beside.y() - 13.0, width, 26.0);
    painter.setPen(Qt::NoPen);
    painter.setBrush(kPlate);
    painter.drawRoundedRect(plate, 6.0, 6.0);
    painter.setPen(kWords);
    painter.drawText(plate, Qt::AlignCenter, text);
}

}  // namespace ui::tooth
