// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include <QImage>
#include <QPainterPath>
#include <QRectF>

#include "core/imaging/Section.h"

class QPainter;

namespace ui::inside {

/// The picture of a tooth from above and the outline of its ideal. Both are slow to compute, so they are computed once.
/// A plain value.
struct FromAbove
{
    QImage relief;           ///< +y up; visible decay is brown
    QRectF reliefMm;         ///< position in the tooth frame
    QRectF shownMm;          ///< the tooth with a margin
    QPainterPath outlineMm;  ///< outline of the ideal as grading uses it; unordered pieces
};

/// Computes the picture and the outline. About 20 ms at 150 x 150. Any thread but the ui thread.
[[nodiscard]] FromAbove fromAbove(const core::terrain::ToothAnatomy& anatomy, const std::vector<float>& idealTop);

struct OutlineScene
{
    const core::terrain::ToothAnatomy* anatomy = nullptr;
    const FromAbove* above = nullptr;
    double toleranceMm = 0.0;                          ///< width of the band on each side of the outline
    double spanMm = 0.0;                               ///< width of the paler band beyond it, outside which all points
                                                       ///< are lost
    std::optional<core::imaging::SectionPlane> plane;  ///< drawn as a line
};

/// Returns the position of a place of the tooth frame in the picture; mmAt() is the inverse.
[[nodiscard]] QPointF placeOf(const QRectF& area, const FromAbove& above, QPointF mm);
[[nodiscard]] QPointF mmAt(const QRectF& area, const FromAbove& above, QPointF place);

/// Returns the area to paint in so that the picture fills a rectangle. Its labels are then outside the rectangle and
/// must be clipped.
[[nodiscard]] QRectF areaAround(const QRectF& picture);

/// Paints the scene, dark in both themes, with the names of the sides. Needs no window.
void paintOutline(QPainter& painter, const QRectF& area, const OutlineScene& scene);

}  // namespace ui::inside
