// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/render/BurLight.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "core/bur/Bur.h"
#include "ui/render/Shaders.h"
#include "ui/render/SolidMesh.h"

namespace ui::render {
namespace {

constexpr double kLampAsideMm = 3.0;  ///< distance of the handpiece's lamp from the bur's axis
constexpr float kLampReachMm = 9.0F;  ///< reach of the lamp's light around the bur
/// Half the width of a shadow's edge per millimetre of height: the operating light is 20 cm wide and 70 cm away.
constexpr double kSpotPenumbra = 0.14;
constexpr double kSoftestMm = 0.08;  ///< half-width of the sharpest shadow edge: what the lattice can show
constexpr double kThickFor = 3.0;    ///< a rod this many times a box's radius leaves it lit if it shades no corner
constexpr float kTold = 0.85F;       ///< strength of the shadow of bur and shank, which shows the user where the bur is
constexpr float kFilled = 0.45F;     ///< strength of the handpiece's shadow, which the other lamps of the room brighten

/// A round rod that casts a shadow.
struct Rod
{
    glm::dvec3 fromMm;  ///< in the handpiece's frame
    glm::dvec3 toMm;
    double radiusMm;
    float strength;  ///< largest share of the light that the rod blocks
};
constexpr std::size_t kRods = 5;

/// Returns rods for the bur, the shank, and the head, neck and handle of the handpiece: the shapes of SolidMesh,
/// simplified. The first rod is the bur.
std::array<Rod, kRods> rodsOf(const core::bur::Bur& bur)
{
    const double chuck = core::bur::kChuckMm;
    const double head = bur.headLengthMm;
    const double round = std::min(bur.headRadiusMm, 0.5 * head);
    return {{{{0.0, 0.0, round}, {0.0, 0.0, head - 0.5 * round}, bur.headRadiusMm, kTold},
             // The shank of a bur with a long head is inside the handpiece.
             {{0.0, 0.0, head + kNeckMm + 2.0}, {0.0, 0.0, std::max(chuck, head + kNeckMm + 3.0)}, 0.8, kTold},
             {{0.0, 0.0, chuck + 4.0}, {0.0, 0.0, chuck + 5.0}, 3.6, kFilled},
             {{2.5, 0.0, chuck + 4.9}, {20.0, 0.0, chuck + 9.0}, 2.8, kFilled},
             {{20.0, 0.0, chuck + 9.0}, {60.0, 0.0, chuck + 24.0}, 4.6, kFilled}}};
}

/// Returns the distance between a ray towards the light and a rod, minus the penumbra, in mm.
double clearanceMm(const glm::dvec3& from, const Rod& rod, const glm::dvec3& towardsLight)
{
    const glm::dvec3 way = rod.toMm - rod.fromMm;
    const glm::dvec3 away = from - rod.fromMm;
    const double e = glm::dot(way, way);
    const double b = glm::dot(towardsLight, way);
    const double c = glm::dot(towardsLight, away);
    const double f = glm::dot(way, away);
    const double on = std::clamp((b * std::max((b * f - c * e) / std::max(e - b * b, 1.0e-4), 0.0) + f) / e, 0.0, 1.0);
    const double along = std::max(b * on - c, 0.0);
    return glm::length(away + towardsLight * along - way * on) - rod.radiusMm - kSpotPenumbra * along - kSoftestMm;
}

/// Returns whether a rod may shade a point inside a box.
bool isShadowed(const Box& box, const Rod& rod, const glm::dvec3& towardsLight)
{
    const glm::dvec3 low(box.low);
    const glm::dvec3 high(box.high);
    const double radius = 0.5 * glm::length(high - low);
    if (clearanceMm(0.5 * (low + high), rod, towardsLight) > (1.0 + kSpotPenumbra) * radius)
        return false;
    // Next to a rod that is thick compared with the box, the corners decide.
    const auto isClear = [&](int corner) {
        const glm::dvec3 at((corner & 1) != 0 ? high.x : low.x, (corner & 2) != 0 ? high.y : low.y,
                            (corner & 4) != 0 ? high.z : low.z);
        return clearanceMm(at, rod, towardsLight) > 0.0;
    };
    constexpr std::array<int, 8> kCorners{0, 1, 2, 3, 4, 5, 6, 7};
    return rod.radiusMm < kThickFor * radius || !std::all_of(kCorners.begin(), kCorners.end(), isClear);
}

}  // namespace

bool BurLight::initialize(QString& reason)
{
    if (!initializeOpenGLFunctions()) {
        reason = QStringLiteral("no OpenGL 3.3 core profile");
        return false;
    }
    m_nothing.create();
    return buildProgram(m_program, "backdrop", "burlight", reason);
}

void BurLight::find(ToothMaps& maps, const Pose& pose)
{
    if (m_pose == pose && m_uploadedBytes == maps.uploadedBytes())
        return;
    m_pose = pose;
    m_uploadedBytes = maps.uploadedBytes();
    const glm::vec3 tip(pose.toothFromBur[3]);
    std::array<Rod, kRods> rods = rodsOf(core::bur::burs()[pose.burIndex]);
    std::array<glm::vec4, kRods> from{};
    std::array<glm::vec4, kRods> to{};
    for (std::size_t k = 0; k < kRods; ++k) {
        const glm::dmat4& toothFromPart = k == 0 ? pose.toothFromBur : pose.toothFromHand;
        rods[k].fromMm = glm::dvec3(toothFromPart * glm::dvec4(rods[k].fromMm, 1.0));
        rods[k].toMm = glm::dvec3(toothFromPart * glm::dvec4(rods[k].toMm, 1.0));
        from[k] = glm::vec4(glm::vec3(rods[k].fromMm), static_cast<float>(rods[k].radiusMm));
        to[k] = glm::vec4(glm::vec3(rods[k].toMm), rods[k].strength);
    }
    const glm::dvec3 towardsLight(pose.towardsLight);
    m_reached = maps.select(ToothMaps::Side::Upper, [&](const TileBounds& tile) {
        const Box& box = tile.box;
        const glm::vec2 nearest = glm::clamp(glm::vec2(tip), glm::vec2(box.low), glm::vec2(box.high));
        return (pose.lamp && glm::distance(nearest, glm::vec2(tip)) < kLampReachMm) ||
               std::any_of(rods.begin(), rods.end(),
                           [&](const Rod& rod) { return isShadowed(box, rod, towardsLight); });
    });
    if (m_reached.nodes.isEmpty())
        return;

    GLint target = 0;
    std::array<GLint, 4> viewport{};
    glGetIntegerv(GL_FRAMEBUFFER_BINDING, &target);
    glGetIntegerv(GL_VIEWPORT, viewport.data());
    const QSize size(maps.side(), maps.side());
    if (!m_map || m_map->size() != size)
        m_map = std::make_unique<QOpenGLFramebufferObject>(size, QOpenGLFramebufferObject::NoAttachment,
                                                           GLenum{GL_TEXTURE_2D}, GLenum{GL_R16F});
    m_map->bind();
    glViewport(0, 0, size.width(), size.height());
    glEnable(GL_SCISSOR_TEST);
    glScissor(m_reached.nodes.x(), m_reached.nodes.y(), m_reached.nodes.width(), m_reached.nodes.height());
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    m_program.bind();
    setVector(m_program, "towardsLight", pose.towardsLight);
    glUniform4fv(m_program.uniformLocation("castFrom"), kRods, glm::value_ptr(from[0]));
    glUniform4fv(m_program.uniformLocation("castTo"), kRods, glm::value_ptr(to[0]));
    setVector(m_program, "tipMm", tip);
    // The lamp stays vertically above the bur, because what it lights must not depend on the position of the eye.
    const double headMm = core::bur::kChuckMm + pose.liftMm;
    const glm::dvec3 lampMm = glm::dvec3(pose.toothFromBur * glm::dvec4(kLampAsideMm, 0.0, headMm, 1.0));
    setVector(m_program, "burLampMm", glm::vec3(lampMm));
    m_program.setUniformValue("penumbra", static_cast<float>(kSpotPenumbra));
    m_program.setUniformValue("softestMm", static_cast<float>(kSoftestMm));
    m_program.setUniformValue("lampReachMm", kLampReachMm);
    m_program.setUniformValue("burLamp", pose.lamp ? 1.0F : 0.0F);
    maps.bind(m_program, ToothMaps::Side::Upper);
    {
        const QOpenGLVertexArrayObject::Binder bound(&m_nothing);
        glDrawArrays(GL_TRIANGLES, 0, 3);
    }
    glDisable(GL_SCISSOR_TEST);
    glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(target));
    glViewport(viewport[0], viewport[1], viewport[2], viewport[3]);
}

}  // namespace ui::render
