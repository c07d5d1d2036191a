// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QPainterPath>
#include <QPointF>

namespace ui::toothchooser {

/// A crown from above, for the picture of the arches. In millimetres, with the origin at the crown's centre, +x distal
/// and +y towards cheek or lip. Sizes are mean crown diameters (Wheeler); shapes are simplified by eye.
struct CrownPicture
{
    QPainterPath outline;
    QPainterPath grooves;  ///< fissures, or the incisal edge
};

/// Returns a smooth curve through the points (Catmull-Rom as cubic segments).
[[nodiscard]] QPainterPath smoothThrough(const QList<QPointF>& points, bool closed);

/// Returns the picture of a crown.
/// @param upper     upper or lower jaw
/// @param position  1 central incisor to 8 third molar
[[nodiscard]] CrownPicture crownPicture(bool upper, int position);

/// The position of a crown in its arch, seen from above with the lips at +y. x is the distance from the midline.
struct ArchPlace
{
    QPointF centreMm;
    double angleRad = 0.0;  ///< angle of the distal direction to +x
};

[[nodiscard]] ArchPlace archPlace(bool upper, int position);

}  // namespace ui::toothchooser
