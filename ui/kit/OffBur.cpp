// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/OffBur.h"

#include <algorithm>
#include <cmath>

namespace ui::kit {
namespace {

double distancePx(QPointF from, const QRectF& to)
{
    return std::hypot(from.x() - std::clamp(from.x(), to.left(), to.right()),
                      from.y() - std::clamp(from.y(), to.top(), to.bottom()));
}

}  // namespace

QRectF placeOffBur(const std::optional<QPointF>& bur, const QRectF& usual, const QRectF& other)
{
    if (!bur)
        return usual;
    const double usualPx = distancePx(*bur, usual);
    return usualPx < kOffBurPx && distancePx(*bur, other) > usualPx ? other : usual;
}

}  // namespace ui::kit
