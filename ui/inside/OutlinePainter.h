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

/// A tooth from above with the outline of its ideal, made once for both: what is slow to make. A plain value.
struct FromAbove
{
    QImage relief;           ///< +y up; decay that lies open is brown
    QRectF reliefMm;         ///< where it lies in the tooth frame
    QRectF shownMm;          ///< the tooth, with a little around it
    QPainterPath outlineMm;  ///< of the ideal, as grading takes it: pieces, in no order
};

/// Some 20 ms at 150 x 150. Any thread that may wait.
[[nodiscard]] FromAbove fromAbove(const core::terrain::ToothAnatomy& anatomy, const std::vector<float>& idealTop);

struct OutlineScene
{
    const core::terrain::ToothAnatomy* anatomy = nullptr;
    const FromAbove* above = nullptr;
    double toleranceMm = 0.0;                          ///< a band so wide on each side of the outline
    double spanMm = 0.0;                               ///< and a paler one so much wider: beyond it all points are lost
    std::optional<core::imaging::SectionPlane> plane;  ///< drawn as a line
};

/// Where a place of the tooth frame lies in the picture.
[[nodiscard]] QPointF placeOf(const QRectF& area, const FromAbove& above, QPointF mm);
[[nodiscard]] QPointF mmAt(const QRectF& area, const FromAbove& above, QPointF place);

/// The area to paint in for a picture that fills this one; its words lie outside, to be clipped.
[[nodiscard]] QRectF areaAround(const QRectF& picture);

/// Paints it, dark in either theme like the section, with which side is where. Needs no window.
void paintOutline(QPainter& painter, const QRectF& area, const OutlineScene& scene);

}  // namespace ui::inside
