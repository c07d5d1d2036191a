// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QPainterPath>
#include <QPointF>

namespace ui::toothchooser {

/// A crown seen from above, for the picture of the arches. Millimetres, origin at the crown's centre,
/// +x distal, +y towards cheek or lip. Sizes: mean crown diameters (Wheeler); shapes simplified by eye.
struct CrownPicture
{
    QPainterPath outline;
    QPainterPath grooves;  ///< fissures, or the incisal edge
};

/// A smooth line through the points (Catmull-Rom as cubic pieces).
[[nodiscard]] QPainterPath smoothThrough(const QList<QPointF>& points, bool closed);

/// @param upper     upper or lower jaw
/// @param position  1 central incisor .. 8 third molar
[[nodiscard]] CrownPicture crownPicture(bool upper, int position);

/// Where a crown stands in its arch, seen from above with the lips at +y: x to the side of the midline.
struct ArchPlace
{
    QPointF centreMm;
    double angleRad = 0.0;  ///< of the distal direction against +x
};

[[nodiscard]] ArchPlace archPlace(bool upper, int position);

}  // namespace ui::toothchooser
