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

/// What a picture of a section shows.
struct SectionScene
{
    const core::terrain::Tooth* tooth = nullptr;
    core::imaging::SectionPlane plane;
    core::grading::IdealTop ideal;  ///< drawn as a broken line; null: none
    /// What may be cut at no cost, drawn as a band around the ideal; null: none.
    const core::preparation::ToleranceBand* band = nullptr;
    /// A bur whose axis lies in the plane, drawn at its true size; null: none.
    const core::bur::Bur* bur = nullptr;
    glm::dvec3 tipMm{0.0};
    std::optional<double> downToPulpMm;  ///< from the tip: a dotted line is drawn so far down
    std::optional<glm::dvec3> markMm;    ///< a place in the plane that is ringed
    render::Palette palette = render::Palette::Natural;
    bool onPaper = false;  ///< dark words on white instead
};

/// Paints the crown, and of the root what there is room for, on a millimetre grid: the materials, the original surface
/// and the ideal one as lines, the bur, where the two ends of the plane point, and what the colours mean. Dark in
/// either theme, like the room with the tooth, but on paper. Needs no window. About 1.5 ms at 320 x 500.
void paintSection(QPainter& painter, const QRectF& area, const SectionScene& scene);

/// Paints materials and ideal alone, for a picture that is too small for grid and words.
void paintSmallSection(QPainter& painter, const QRectF& area, const SectionScene& scene);

}  // namespace ui::inside
