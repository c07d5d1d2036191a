// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/study/LessonScene.h"

#include <numbers>
#include <variant>

#include "lessons/Capture.h"

namespace ui::study {

using ::lessons::Lesson;
using ::lessons::Task;

namespace {

constexpr QRgb kRing = 0xFF56C7C9;

}  // namespace

bool isPictured(const Lesson& lesson)
{
    return lesson.task != Task::TellLayers;
}

/// Whoever is to look for decay is not told where it ends.
bool isIdealTold(const Lesson& lesson)
{
    return lesson.aids.ideal && (lesson.task == Task::CutIdeal || lesson.task == Task::TraceShape);
}

std::shared_ptr<const LessonScene> makeLessonScene(const Lesson& lesson)
{
    auto assigned = ::lessons::assign(lesson);
    if (!assigned)
        return nullptr;
    ::lessons::Assignment& assignment = assigned->assignment;
    const core::terrain::ToothAnatomy& anatomy = *assignment.anatomy;
    const core::grading::IdealTop ideal = isIdealTold(lesson) ? assignment.shownIdeal() : nullptr;
    auto scene = std::make_shared<LessonScene>(LessonScene{assignment,
                                                           core::terrain::Tooth(assignment.anatomy),
                                                           inside::fromAbove(anatomy, ideal ? *ideal : anatomy.top),
                                                           ideal,
                                                           0.0,
                                                           std::nullopt,
                                                           {}});
    if (!ideal)
        return scene;
    core::preparation::Tolerances tolerances{0.0, 0.0, 0.0, 0.0};
    if (assignment.leeway)
        tolerances = {assignment.leeway->sidesMm, assignment.leeway->bottomMm, 0.0, 0.0};
    tolerances = ::lessons::tolerancesOf(lesson.rubric, tolerances);
    scene->outlineMm = tolerances.outlineMm;
    scene->band =
        core::preparation::toleranceBand(anatomy, *assignment.ideal, tolerances.outlineMm, tolerances.depthMm);
    scene->plane.throughMm = assignment.ideal->isthmus ? assignment.ideal->isthmus->atMm : anatomy.grid.middleMm();
    scene->plane.angleRad = 0.5 * std::numbers::pi;
    return scene;
}

void paintFromAbove(QPainter& painter, const QRectF& room, const LessonScene& scene, bool showsPlane)
{
    const auto& assignment = scene.assignment;
    inside::paintOutline(painter, room,
                         {assignment.anatomy.get(), &scene.above, scene.outlineMm, 0.0,
                          showsPlane ? std::optional(scene.plane) : std::nullopt});
    if (!assignment.exercise)
        return;
    if (const auto* asked = std::get_if<core::grading::PointsToTouch>(&*assignment.exercise)) {
        painter.setPen(QPen(QColor(kRing), 2.0));
        painter.setBrush(Qt::NoBrush);
        for (const glm::dvec2& point : asked->pointsMm) {
            const QPointF middle = inside::placeOf(room, scene.above, {point.x, point.y});
            const QPointF edge = inside::placeOf(room, scene.above, {point.x + asked->reachMm, point.y});
            painter.drawEllipse(middle, edge.x() - middle.x(), edge.x() - middle.x());
        }
    }
}

}  // namespace ui::study
