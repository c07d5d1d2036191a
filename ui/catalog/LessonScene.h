// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include <QPainter>
#include <QRectF>

#include "core/grading/Preparation.h"
#include "core/imaging/Section.h"
#include "core/preparation/ToleranceBand.h"
#include "core/terrain/Tooth.h"
#include "lessons/Assignment.h"
#include "ui/inside/OutlinePainter.h"
#include "ui/inside/SectionPainter.h"

namespace ui::catalog {

/// The ground that lessons are pictured on: dark in either theme, like the room with the tooth.
inline constexpr QRgb kPictureGround = 0xFF15181A;

/// What can be pictured of a lesson before it is begun: the tooth, with decay as it is seen on its surface; the ideal,
/// where that is an aid of the lesson and no decay is to be found; and a section through either, where sections are an
/// aid.
struct LessonScene
{
    ::lessons::Assignment assignment;
    core::terrain::Tooth whole;
    inside::FromAbove above;
    core::grading::IdealTop ideal;  ///< null: not told
    double outlineMm = 0.0;         ///< tolerance
    std::optional<core::preparation::ToleranceBand> band;
    std::optional<core::imaging::SectionPlane> plane = {};  ///< nothing: no section is shown
};

/// Not what is to be felt and not seen.
[[nodiscard]] bool isPictured(const ::lessons::Lesson& lesson);
/// Whether the ideal may be seen beforehand.
[[nodiscard]] bool isIdealTold(const ::lessons::Lesson& lesson);

/// Returns a section through the deepest decay: in the bucco-lingual direction, or in the mesio-distal direction if the
/// decay is much longer that way. Nothing without decay.
[[nodiscard]] std::optional<core::imaging::SectionPlane> planeThroughDecay(const core::terrain::Tooth& tooth);

/// Returns a section through the ideal: along the direction in which its box opens, if it has one; otherwise across its
/// isthmus; otherwise through its middle, with the direction chosen as in planeThroughDecay().
[[nodiscard]] core::imaging::SectionPlane planeThroughIdeal(const core::terrain::ToothAnatomy& anatomy,
                                                            const core::grading::Preparation& ideal);

/// Makes the tooth, which takes its time. Null: it cannot be made; starting the lesson says why. Any thread.
[[nodiscard]] std::shared_ptr<const LessonScene> makeLessonScene(const ::lessons::Lesson& lesson);

/// What its section shows; the scene must have a plane and outlive it.
[[nodiscard]] inside::SectionScene sectionOf(const LessonScene& scene);

/// The tooth from above with the outline that is to be cut, or the points that are to be touched.
/// @param showsPlane  where the section runs
void paintFromAbove(QPainter& painter, const QRectF& room, const LessonScene& scene, bool showsPlane);

}  // namespace ui::catalog
