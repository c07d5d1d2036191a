// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tooth/MouthScene.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "core/teeth/ToothTable.h"

namespace ui::tooth {
namespace {

/// Elevation of the eye, up or down, beyond which only the jaw that faces the eye is drawn.
constexpr double kOneJawDeg = 24.0;
/// Radius that must fit into the picture, as a share of the extent of the teeth: for both jaws, and for one jaw, which
/// fills more of its bounding ball.
constexpr double kBothJaws = 0.52;
constexpr double kOneJaw = 0.62;
/// Direction of the light over the viewer's left shoulder, in the eye's frame.
const glm::dvec3 kLamp = glm::normalize(glm::dvec3(-0.35, 0.55, 0.75));
const glm::dvec3 kSky = glm::normalize(glm::dvec3(0.0, 0.5, 0.86));

}  // namespace

Jaws jawsSeen(double elevationDeg)
{
    return {elevationDeg<kOneJawDeg, elevationDeg> - kOneJawDeg};
}

std::vector<core::teeth::ArchPiece> piecesOf(std::span<const core::teeth::ArchPiece> mouth, Jaws jaws)
{
    std::vector<core::teeth::ArchPiece> pieces;
    for (const core::teeth::ArchPiece& piece : mouth)
        if (piece.upper ? jaws.upper : jaws.lower)
            pieces.push_back(piece);
    return pieces;
}

glm::dvec3 crownMiddleMm(const core::teeth::ArchPiece& tooth)
{
    const double heightMm = core::teeth::findToothSizes(core::teeth::leftFellow(tooth.fdi))->crownHeightMm;
    return glm::dvec3(tooth.place * glm::dvec4(0.0, 0.0, -0.4 * heightMm, 1.0));
}

void showPieces(Camera& camera, std::span<const core::teeth::ArchPiece> shown)
{
    glm::dvec3 low(1.0e9);
    glm::dvec3 high(-1.0e9);
    Jaws jaws;
    for (const core::teeth::ArchPiece& piece : shown) {
        if (!piece.tooth)
            continue;
        low = glm::min(low, crownMiddleMm(piece));
        high = glm::max(high, crownMiddleMm(piece));
        (piece.upper ? jaws.upper : jaws.lower) = true;
    }
    camera.setSubject(0.5 * (low + high), (jaws.upper && jaws.lower ? kBothJaws : kOneJaw) * glm::distance(low, high));
}

render::ArchScene mouthThrough(const Camera& camera)
{
    render::ArchScene scene;
    scene.eyeFromScene = camera.view();
    scene.clipFromEye = camera.projection();
    scene.eyeMm = camera.eyeMm();
    const glm::dmat3 sceneFromEye = glm::transpose(glm::dmat3(scene.eyeFromScene));
    scene.towardsLight = glm::vec3(sceneFromEye * kLamp);
    scene.towardsSky = glm::vec3(sceneFromEye * kSky);
    return scene;
}

}  // namespace ui::tooth
