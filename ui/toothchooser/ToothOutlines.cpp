// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/toothchooser/ToothOutlines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <QList>

namespace ui::toothchooser {
namespace {

struct Size
{
    double mesioDistalMm;
    double buccoLingualMm;
};

constexpr std::array<Size, 8> kUpper{
    {{8.5, 7.0}, {6.5, 6.0}, {7.5, 8.0}, {7, 9}, {7, 9}, {10, 11}, {9, 11}, {8.5, 10}}};
constexpr std::array<Size, 8> kLower{
    {{5.0, 6.0}, {5.5, 6.5}, {7.0, 7.5}, {7, 7.5}, {7, 8}, {11, 10.5}, {10.5, 10}, {10, 9.5}}};

/// Half-axes of the curve through the crowns' centres,
/// x/a
/// ^p +
/// y/b
/// ^p = 1, which is flatter in front than an ellipse.
constexpr double kUpperHalfWidthMm = 29.0;
constexpr double kUpperDepthMm = 47.0;
constexpr double kLowerHalfWidthMm = 27.0;
constexpr double kLowerDepthMm = 47.0;
constexpr double kFlatness = 2.5;

// Outlines in half diameters, in order around the crown. A smooth curve connects the points.
using Points = QList<QPointF>;

Points outlinePoints(bool upper, int position)
{
    switch (position) {
    case 1:
    case 2:
        if (upper)
            return {{-1, .45}, {-.7, .86}, {0, 1}, {.7, .86}, {1, .4}, {.62, -.5}, {0, -1}, {-.62, -.5}};
        return {{-.98, .5}, {-.6, .9}, {0, 1}, {.6, .9}, {.98, .5}, {.6, -.5}, {0, -1}, {-.6, -.5}};
    case 3:
        return {{-.98, .2}, {-.55, .72}, {-.05, 1}, {.55, .68}, {1, .1}, {.5, -.62}, {0, -1}, {-.55, -.6}};
    case 4:
    case 5:
        if (upper)
            return {{-.94, .45}, {-.5, .94}, {.1, 1},   {.6, .86},   {1, .35},
                    {.86, -.5},  {.4, -.96}, {-.3, -1}, {-.82, -.6}, {-.94, 0}};
        return {{-1, .2}, {-.7, .78}, {0, 1}, {.72, .76}, {1, .15}, {.8, -.65}, {.1, -1}, {-.7, -.75}};
    case 6:
    case 7:
    case 8:
        if (upper)
            return {{-1, .3},   {-.92, .82}, {-.5, .98}, {-.05, .86}, {.45, .9},    {.82, .66}, {.95, .1},
                    {.98, -.5}, {.7, -.94},  {.15, -.9}, {-.4, -1},   {-.86, -.74}, {-.92, -.2}};
        return {{-1, .3},   {-.88, .82}, {-.45, .98}, {-.1, .88},   {.3, .96}, {.72, .74},   {1, .25},
                {.94, -.4}, {.72, -.86}, {.3, -.98},  {-.05, -.88}, {-.5, -1}, {-.88, -.76}, {-.96, -.2}};
    default:
        return {};
    }
}

QList<Points> groovePoints(bool upper, int position)
{
    switch (position) {
    case 1:
    case 2:
        return {{{-.78, .3}, {0, .42}, {.78, .28}}};
    case 3:
        return {{{-.72, .05}, {-.05, .32}, {.72, 0}}};
    case 4:
        // One groove from the mesial to the distal pit, forked at each pit. In the lower tooth a ridge separates the
        // two pits.
        if (!upper)
            return {{{-.62, .12}, {-.42, -.12}, {-.5, -.38}}, {{.64, .1}, {.44, -.14}, {.5, -.4}}};
        [[fallthrough]];
    case 5:
        if (upper)
            return {{{-.5, .02}, {0, -.04}, {.5, .02}},
                    {{-.72, .3}, {-.5, .02}, {-.7, -.26}},
                    {{.72, .3}, {.5, .02}, {.7, -.26}}};
        return {{{-.68, .16}, {-.36, -.1}, {0, -.18}, {.36, -.1}, {.68, .16}}, {{0, -.18}, {.04, -.74}}};
    case 6:
    case 7:
    case 8:
        if (upper)
            return {{{-.62, .12}, {-.3, .02}, {-.05, .05}},
                    {{-.05, .05}, {0, .45}, {-.05, .78}},
                    {{-.05, .05}, {.2, -.02}},
                    {{.6, .2}, {.42, -.12}, {.3, -.4}, {.18, -.82}}};
        return {{{-.66, .05}, {-.35, -.06}, {-.02, .08}, {.32, -.06}, {.64, .1}},
                {{-.2, .02}, {-.16, .42}, {-.1, .8}},
                {{.32, -.06}, {.48, .34}, {.58, .66}},
                {{-.02, .08}, {-.02, -.4}, {-.05, -.8}}};
    default:
        return {};
    }
}

Size sizeOf(bool upper, int position)
{
    return (upper ? kUpper : kLower).at(static_cast<std::size_t>(position - 1));
}

/// Converts points in half diameters to millimetres.
Points scaled(Points points, Size size)
{
    for (QPointF& point : points)
        point = {point.x() * size.mesioDistalMm / 2, point.y() * size.buccoLingualMm / 2};
    return points;
}

}  // namespace

QPainterPath smoothThrough(const QList<QPointF>& points, bool closed)
{
    const qsizetype count = points.size();
    const auto at = [&](qsizetype k) {
        return points[closed ? (k % count + count) % count : std::clamp<qsizetype>(k, 0, count - 1)];
    };
    QPainterPath path(at(0));
    const qsizetype pieces = closed ? count : count - 1;
    for (qsizetype k = 0; k < pieces; ++k)
        path.cubicTo(at(k) + (at(k + 1) - at(k - 1)) / 6, at(k + 1) - (at(k + 2) - at(k)) / 6, at(k + 1));
    if (closed)
        path.closeSubpath();
    return path;
}

CrownPicture crownPicture(bool upper, int position)
{
    const Size size = sizeOf(upper, position);
    CrownPicture picture{smoothThrough(scaled(outlinePoints(upper, position), size), true), {}};
    for (const Points& groove : groovePoints(upper, position))
        picture.grooves.addPath(smoothThrough(scaled(groove, size), false));
    return picture;
}

ArchPlace archPlace(bool upper, int position)
{
    double targetMm = sizeOf(upper, position).mesioDistalMm / 2;
    for (int nearer = 1; nearer < position; ++nearer)
        targetMm += sizeOf(upper, nearer).mesioDistalMm;
    const double a = upper ? kUpperHalfWidthMm : kLowerHalfWidthMm;
    const double b = upper ? kUpperDepthMm : kLowerDepthMm;
    // Follows the curve from the midline. Beyond its end it continues straight.
    const auto pointAt = [&](double t) {
        return QPointF(a * std::pow(std::sin(t), 2 / kFlatness), -b * (1 - std::pow(std::cos(t), 2 / kFlatness)));
    };
    constexpr int kSteps = 4000;
    double walkedMm = 0.0;
    QPointF here(0, 0);
    for (int k = 1; k <= kSteps; ++k) {
        const double t = std::min(std::numbers::pi / 2 * k / kSteps, std::numbers::pi / 2 - 1e-9);
        const QPointF next = pointAt(t);
        const QPointF step = next - here;
        const double length = std::hypot(step.x(), step.y());
        if (walkedMm + length >= targetMm)
            return {here, std::atan2(step.y(), step.x())};
        walkedMm += length;
        here = next;
    }
    return {here - QPointF(0, targetMm - walkedMm), -std::numbers::pi / 2};
}

}  // namespace ui::toothchooser
