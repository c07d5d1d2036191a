// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <glm/vec3.hpp>

#include <QRectF>

#include "core/bur/Bur.h"
#include "core/grading/IdealCavity.h"
#include "core/imaging/Section.h"
#include "core/preparation/ToleranceBand.h"
#include "ui/kit/MaterialLook.h"

class QPainter;

namespace ui::inside {

/// The contents of a section's picture.
struct SectionScene
{
    const core::terrain::Tooth* tooth = nullptr;
    core::imaging::SectionPlane plane;
    core::grading::IdealTop ideal;  ///< drawn as a dashed line; null: none
    /// The region that can be cut without losing points, drawn as a band around the ideal; null: none.
    const core::preparation::ToleranceBand* band = nullptr;
    /// A bur whose axis lies in the plane, drawn at its true size; null: none.
    const core::bur::Bur* bur = nullptr;
    glm::dvec3 tipMm{0.0};
    std::optional<double> downToPulpMm;  ///< length of a dotted line from the tip down to the pulp
    std::optional<glm::dvec3> markMm;    ///< a place in the plane, marked with a ring
    render::Palette palette = render::Palette::Natural;
    bool onPaper = false;  ///< dark text on white
};

/// Paints the crown, and as much of the root as fits, on a millimetre grid: the materials, the original and the ideal
/// surface as lines, the bur, the directions at both ends of the plane, and a legend. Dark in both themes, except on
/// paper. Needs no window. About 1.5 ms at 320 x 500.
void paintSection(QPainter& painter, const QRectF& area, const SectionScene& scene);

/// Paints materials and ideal only, for a picture that is too small for a grid and text.
void paintSmallSection(QPainter& painter, const QRectF& area, const SectionScene& scene);

}  // namespace ui::inside
