// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tooth/ViewMarks.h"

#include <algorithm>
#include <cmath>

#include <QCoreApplication>
#include <QLinearGradient>
#include <QLocale>
#include <QPainterPath>

#include "ui/kit/OffBur.h"
#include "ui/text/Texts.h"

namespace ui::tooth {
namespace {

const QColor kPlate(20, 22, 24, 190);
const QColor kMarkInk(240, 240, 238);
constexpr int kWordsPx = 14;
constexpr double kArrowInPx = 26.0;  ///< distance from the edge of the view
constexpr double kShaftPx = 9.0;
constexpr double kHeadPx = 26.0;
constexpr double kScaleWide = 14.0;
constexpr double kScaleHigh = 150.0;
constexpr double kMargin = 20.0;
constexpr double kOnIdealMm = 0.05;  ///< a place nearer to the ideal than this counts as on it

QFont wordsFont(const QPainter& painter)
{
    QFont font = painter.font();
    font.setPixelSize(kWordsPx);
    return font;
}

}  // namespace

render::GizmoLetters gizmoLetters(int fdi)
{
    render::GizmoLetters letters;
    const QStringList words = text::surfaceLetters(fdi);
    std::copy_n(words.begin(), std::min<qsizetype>(words.size(), letters.size()), letters.begin());
    return letters;
}

void paintArrowOut(QPainter& painter, QSizeF view, QPointF from, QPointF towards)
{
    if (QRectF(QPointF(), view).contains(towards))
        return;
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
    // At least the head of the arrow is visible, even if the bur has left the view as well.
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

QString depthWords(const render::ToothSurface& surface, const glm::dvec3& pointMm, render::DepthColours colours)
{
    const auto millimetres = [](double mm) {
        //: A length in millimetres
        return QCoreApplication::translate("ViewMarks", "%1 mm").arg(QLocale().toString(std::abs(mm), 'f', 2));
    };
    if (colours == render::DepthColours::BelowOriginal)
        return millimetres(std::max(0.0, surface.belowUncutMm(pointMm)));
    const double below = surface.belowIdealMm(pointMm);
    if (std::abs(below) < kOnIdealMm)
        return QCoreApplication::translate("ViewMarks", "as it should be");
    //: %1 is a length: the tooth is cut deeper than it should be
    return below > 0.0 ? QCoreApplication::translate("ViewMarks", "%1 too deep").arg(millimetres(below))
                       //: %1 is a length: so much is still to be taken away
                       : QCoreApplication::translate("ViewMarks", "%1 to cut").arg(millimetres(below));
}

void paintDepthScale(QPainter& painter, QSizeF view, const render::Look& look, const render::Presentation& how,
                     const std::optional<QPointF>& bur)
{
    const bool aboutIdeal = look.depthColours == render::DepthColours::AgainstIdeal;
    const double endMm = aboutIdeal ? render::kIdealScaleMm : render::kDepthScaleMm;
    const double beginMm = aboutIdeal ? -endMm : 0.0;
    painter.setFont(wordsFont(painter));
    const QFontMetricsF words(painter.font());
    //: Titles of a scale of colours: how deep a cut is, and how far from the ideal
    const QString title = aboutIdeal ? QCoreApplication::translate("ViewMarks", "deviation, mm")
                                     : QCoreApplication::translate("ViewMarks", "depth, mm");
    // Beyond an end of the scale the colour does not change.
    const QString end = QStringLiteral("\u2265\u2009") + QLocale().toString(endMm, 'f', 1);
    const QString first = aboutIdeal ? QCoreApplication::translate("ViewMarks", "%1 to cut").arg(end)
                                     : QLocale().toString(beginMm, 'f', 1);
    const QString last = aboutIdeal ? QCoreApplication::translate("ViewMarks", "%1 too deep").arg(end) : end;
    const double wide =
        std::max(words.horizontalAdvance(title),
                 kScaleWide + 9.0 + std::max(words.horizontalAdvance(first), words.horizontalAdvance(last)));
    // At the right edge, half way up. At the left are the history, below a hint or the bar of a replay.
    const QRectF usual(view.width() - kMargin - wide - 10.0, 0.5 * (view.height() - kScaleHigh) - 34.0, wide + 20.0,
                       kScaleHigh + 46.0);
    const QRectF plate = kit::placeOffBur(bur, usual, QRectF(QPointF(kMargin - 10.0, usual.top()), usual.size()));
    const QRectF bar(plate.left() + 10.0, plate.top() + 34.0, kScaleWide, kScaleHigh);
    painter.setPen(Qt::NoPen);
    painter.setBrush(kPlate);
    painter.drawRoundedRect(plate, 6.0, 6.0);
    QLinearGradient colours(bar.topLeft(), bar.bottomLeft());
    // The same colours as in tooth.frag, after its tone mapping.
    colours.setColorAt(0.0, render::seenAs(QColor(102, 158, 214), how.stereo));
    colours.setColorAt(0.5, render::seenAs(QColor(240, 240, 236), how.stereo));
    colours.setColorAt(1.0, render::seenAs(QColor(216, 104, 52), how.stereo));
    painter.setBrush(colours);
    painter.drawRoundedRect(bar, 3.0, 3.0);
    painter.setPen(kMarkInk);
    painter.drawText(QPointF(bar.left(), bar.top() - 14.0), title);
    const int steps = aboutIdeal ? 4 : 3;
    for (int k = 0; k <= steps; ++k) {
        const double share = static_cast<double>(k) / steps;
        const double y = bar.top() + share * kScaleHigh;
        painter.drawLine(QPointF(bar.right(), y), QPointF(bar.right() + 5.0, y));
        const double mm = beginMm + (endMm - beginMm) * share;
        const QString figure = k == 0 ? first : k == steps ? last : QLocale().toString(std::abs(mm), 'f', 1);
        painter.drawText(QPointF(bar.right() + 9.0, y + 0.36 * kWordsPx), figure);
    }
}

void paintPlate(QPainter& painter, QSizeF view, QPointF place, double gapPx, const QString& text, bool onTheLeft)
{
    painter.setFont(wordsFont(painter));
    const double width = QFontMetricsF(painter.font()).horizontalAdvance(text) + 16.0;
    const bool hasRoom = onTheLeft ? place.x() - gapPx - width > 0.0 : place.x() + gapPx + width < view.width();
    const double left = onTheLeft == hasRoom ? place.x() - gapPx - width : place.x() + gapPx;
    const QRectF plate(left, place.y() - 13.0, width, 26.0);
    painter.setPen(Qt::NoPen);
    painter.setBrush(kPlate);
    painter.drawRoundedRect(plate, 6.0, 6.0);
    painter.setPen(kMarkInk);
    painter.drawText(plate, Qt::AlignCenter, text);
}

}  // namespace ui::tooth
