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

/// Background of lesson pictures: dark in both themes.
inline constexpr QRgb kPictureGround = 0xFF15181A;

/// The contents of a lesson's preview: the tooth with the decay that is visible on its surface; the ideal, if it is an
/// aid of the lesson and there is no decay to find; and a section through the decay or the ideal, if sections are an
/// aid.
struct LessonScene
{
    ::lessons::Assignment assignment;
    core::terrain::Tooth whole;
    inside::FromAbove above;
    core::grading::IdealTop ideal;  ///< null: not shown
    double outlineMm = 0.0;         ///< tolerance
    std::optional<core::preparation::ToleranceBand> band;
    std::optional<core::imaging::SectionPlane> plane = {};  ///< empty: no section
};

/// Returns whether a lesson has a preview. Lessons in which the student feels the tooth and does not see it have none.
[[nodiscard]] bool isPictured(const ::lessons::Lesson& lesson);
/// Returns whether the preview may show the ideal.
[[nodiscard]] bool isIdealTold(const ::lessons::Lesson& lesson);

/// Returns a section through the deepest decay: in the bucco-lingual direction, or in the mesio-distal direction if the
/// decay is much longer that way. Empty without decay.
[[nodiscard]] std::optional<core::imaging::SectionPlane> planeThroughDecay(const core::terrain::Tooth& tooth);

/// Returns a section through the ideal: along the direction in which its box opens, if it has one; otherwise across its
/// isthmus; otherwise through its middle, with the direction chosen as in planeThroughDecay().
[[nodiscard]] core::imaging::SectionPlane planeThroughIdeal(const core::terrain::ToothAnatomy& anatomy,
                                                            const core::grading::Preparation& ideal);

/// Builds the tooth of a lesson, which is slow. Returns null if that fails; starting the lesson then shows the reason.
/// Any thread.
[[nodiscard]] std::shared_ptr<const LessonScene> makeLessonScene(const ::lessons::Lesson& lesson);

/// Returns the section of a scene. The scene must have a plane and outlive the result.
[[nodiscard]] inside::SectionScene sectionOf(const LessonScene& scene);

/// Paints the tooth from above with the outline to cut or the points to touch.
/// @param showsPlane  marks the plane of the section
void paintFromAbove(QPainter& painter, const QRectF& room, const LessonScene& scene, bool showsPlane);

}  // namespace ui::catalog
