// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/catalog/LessonScene.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <variant>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "core/grading/Columns.h"
#include "lessons/IdealFromRecordings.h"

namespace ui::catalog {

using ::lessons::Lesson;
using ::lessons::Task;

namespace {

constexpr QRgb kRing = 0xFF56C7C9;
constexpr float kMuchMore = 1.6F;

}  // namespace

std::optional<core::imaging::SectionPlane> planeThroughDecay(const core::terrain::Tooth& tooth)
{
    const core::terrain::Grid& grid = tooth.grid();
    const auto decayMm = [&](int i, int j) {
        const core::grading::Decay decay = core::grading::decayIn(tooth, grid.index(i, j));
        return decay.any() ? decay.roof - decay.floor : 0.0F;
    };
    glm::ivec2 deepest(0);
    float mostMm = 0.0F;
    for (int j = 0; j < grid.side; ++j) {
        for (int i = 0; i < grid.side; ++i) {
            if (const float mm = decayMm(i, j); mm > mostMm) {
                mostMm = mm;
                deepest = {i, j};
            }
        }
    }
    if (mostMm <= 0.0F)
        return {};
    float alongX = 0.0F;
    float alongY = 0.0F;
    for (int k = 0; k < grid.side; ++k) {
        alongX += decayMm(k, deepest.y);
        alongY += decayMm(deepest.x, k);
    }
    return core::imaging::SectionPlane{grid.nodeMm(deepest.x, deepest.y),
                                       alongX > kMuchMore * alongY ? 0.0 : 0.5 * std::numbers::pi};
}

core::imaging::SectionPlane planeThroughIdeal(const core::terrain::ToothAnatomy& anatomy,
                                              const core::grading::Preparation& ideal)
{
    constexpr double kAcross = 0.5 * std::numbers::pi;
    constexpr double kFromBoxWallMm = 0.5;
    if (ideal.box) {
        const glm::dvec2 out = ideal.box->outwards;
        const glm::dvec2 aside(-out.y, out.x);
        glm::dvec2 through = ideal.box->atMm;
        if (ideal.isthmus) {  // inside the box, and as near to the isthmus as the box allows
            const double most = std::max(0.0, 0.5 * ideal.box->widthMm - kFromBoxWallMm);
            through += aside * std::clamp(glm::dot(ideal.isthmus->atMm - through, aside), -most, most);
        }
        // The left of the picture is the left of the tooth, whichever way the box opens.
        const bool isBack = std::abs(out.x) > std::abs(out.y) ? out.x < 0.0 : out.y < 0.0;
        return {through, isBack ? std::atan2(-out.y, -out.x) : std::atan2(out.y, out.x)};
    }
    if (ideal.isthmus)
        return {ideal.isthmus->atMm, kAcross};
    const core::terrain::Grid& grid = anatomy.grid;
    const auto isCut = [&](std::size_t k) { return ideal.parts[k] != core::grading::Part::Keep; };
    glm::dvec2 sum(0.0);
    int count = 0;
    for (std::size_t k = 0; k < grid.count(); ++k) {
        if (!isCut(k))
            continue;
        sum += grid.nodeMm(k);
        ++count;
    }
    if (count == 0)
        return {grid.middleMm(), kAcross};
    const glm::dvec2 middle = sum / static_cast<double>(count);
    const glm::ivec2 node = glm::clamp(glm::ivec2(glm::round(grid.latticeOf(middle))), 0, grid.side - 1);
    int alongX = 0;
    int alongY = 0;
    for (int k = 0; k < grid.side; ++k) {
        alongX += isCut(grid.index(k, node.y)) ? 1 : 0;
        alongY += isCut(grid.index(node.x, k)) ? 1 : 0;
    }
    return {middle, static_cast<float>(alongX) > kMuchMore * static_cast<float>(alongY) ? 0.0 : kAcross};
}

bool isPictured(const Lesson& lesson)
{
    return lesson.task != Task::TellLayers;
}

/// Returns whether the ideal may be shown. A student who must find the decay must not see where it ends.
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
    auto scene = std::make_shared<LessonScene>(LessonScene{assignment, core::terrain::Tooth(assignment.anatomy),
                                                           inside::fromAbove(anatomy, ideal ? *ideal : anatomy.top),
                                                           ideal, 0.0, std::nullopt});
    if (!ideal) {
        if (lesson.task == Task::RemoveDecay && lesson.aids.section)
            scene->plane = planeThroughDecay(scene->whole);
        return scene;
    }
    core::preparation::Tolerances tolerances{0.0, 0.0, 0.0, 0.0};
    if (assignment.leeway)
        tolerances = {assignment.leeway->sidesMm, assignment.leeway->bottomMm, 0.0, 0.0};
    tolerances = ::lessons::tolerancesOf(lesson.rubric, tolerances);
    scene->outlineMm = tolerances.outlineMm;
    scene->band =
        core::preparation::toleranceBand(anatomy, *assignment.ideal, tolerances.outlineMm, tolerances.depthMm);
    if (lesson.aids.section)
        scene->plane = planeThroughIdeal(anatomy, *assignment.ideal);
    return scene;
}

inside::SectionScene sectionOf(const LessonScene& scene)
{
    inside::SectionScene section;
    section.tooth = &scene.whole;
    section.plane = *scene.plane;
    section.ideal = scene.ideal;
    section.band = scene.band ? &*scene.band : nullptr;
    return section;
}

void paintFromAbove(QPainter& painter, const QRectF& room, const LessonScene& scene, bool showsPlane)
{
    const auto& assignment = scene.assignment;
    inside::paintOutline(
        painter, room,
        {assignment.anatomy.get(), &scene.above, scene.outlineMm, 0.0, showsPlane ? scene.plane : std::nullopt});
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

}  // namespace ui::catalog
