// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/render/SurfaceLight.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/terrain/Tooth.h"
#include "ui/render/Flanks.h"

namespace ui::render {
namespace {

using core::terrain::kEmptyTop;
using core::terrain::NodeRect;

/// Distances at which the horizon is sampled, mm: near ones for fissures, far ones for cusps and cavity walls.
constexpr std::array<float, 7> kSkyReachMm{0.08F, 0.16F, 0.28F, 0.5F, 0.85F, 1.4F, 2.2F};
/// The two samples that tell a fissure from a fossa. The walls of a fissure rise only near its bottom; those of a bowl
/// keep rising.
constexpr std::size_t kNearSample = 2;
constexpr std::size_t kFarSample = 4;
constexpr float kBowlShare = 0.5F;
constexpr float kUnknownRise = -1.0e3F;  ///< slope towards an empty node
/// Half-width of the operating light as a tangent. Determines how soft the edge of a shadow is.
constexpr float kPenumbra = 0.5F;
constexpr float kUpright = 1.0e-4F;  ///< horizontal part of the direction of a light straight from above
/// Depth below the whole surface at which a spot counts as cut, mm.
constexpr float kCutFromMm = 0.01F;
constexpr float kCutFullMm = 0.06F;
constexpr int kLightBlur = 3;       ///< range over which light is averaged, nodes
constexpr float kFreeFull = 0.25F;  ///< z of a flank's normal up to which the flank sees the whole sky
constexpr float kFreeNone = 0.6F;
constexpr glm::vec4 kFreeLight(1.0F, 1.0F, 0.0F, 0.5F);

std::uint8_t toByte(float value)
{
    return static_cast<std::uint8_t>(std::lround(255.0F * std::clamp(value, 0.0F, 1.0F)));
}

/// Returns whether a node is uncut and near the rim.
bool isFlank(const LitMaps& maps, std::size_t k)
{
    return maps.top[k] >= maps.wholeTop[k] && maps.flanks.isNear(k);
}

}  // namespace

SurfaceLight::SurfaceLight(const core::terrain::Grid& lattice, glm::vec3 towardsLight)
    : m_lattice(lattice), m_raw(lattice.count(), kFreeLight), m_light(lattice.count(), Light{})
{
    static_assert(kSkyReachMm.size() == kSkySamples);
    const auto cell = static_cast<float>(m_lattice.cellMm);
    for (std::size_t d = 0; d < kSkyDirections; ++d) {
        const float angle = (static_cast<float>(d) + 0.5F) * 6.2831853F / static_cast<float>(kSkyDirections);
        m_directions[d] = {std::cos(angle), std::sin(angle)};
        for (std::size_t s = 0; s < kSkyReachMm.size(); ++s) {
            const int di = static_cast<int>(std::lround(kSkyReachMm[s] * std::cos(angle) / cell));
            const int dj = static_cast<int>(std::lround(kSkyReachMm[s] * std::sin(angle) / cell));
            m_sky[d][s] = {di, dj, cell * std::sqrt(static_cast<float>(di * di + dj * dj))};
        }
    }
    setDirection(towardsLight);
}

void SurfaceLight::setDirection(glm::vec3 towardsLight)
{
    m_towardsLight = towardsLight;
    m_lightPath.clear();
    const auto cell = static_cast<float>(m_lattice.cellMm);
    if (glm::length(glm::vec2(m_towardsLight)) > kUpright)
        for (float t = 1.5F * cell; t < kShadowReachMm; t *= 1.12F)
            m_lightPath.push_back(t);
}

NodeRect SurfaceLight::shine(const LitMaps& maps, const NodeRect& rect)
{
    // Computes raw values on solid nodes. Then every node, rim nodes included, gets the average of the solid nodes
    // around it.
    const NodeRect raw = core::terrain::grown(rect, kLightBlur, m_lattice);
    for (int j = raw.beginJ; j < raw.endJ; ++j)
        for (int i = raw.beginI; i < raw.endI; ++i)
            if (isSolid(maps, i, j))
                m_raw[m_lattice.index(i, j)] = lightAt(maps, i, j);
    NodeRect changed;
    for (int j = rect.beginJ; j < rect.endJ; ++j) {
        for (int i = rect.beginI; i < rect.endI; ++i) {
            const glm::vec4 mean = meanAround(maps, i, j);
            const Light now{toByte(mean.r), toByte(mean.g), toByte(mean.b), toByte(mean.a)};
            if (Light& before = m_light[m_lattice.index(i, j)]; before != now) {
                before = now;
                changed = core::terrain::united(changed, {i, j, i + 1, j + 1});
            }
        }
    }
    return changed;
}

/// Returns the unsmoothed light of a solid node, with the components of Light, each 0 to 1.
glm::vec4 SurfaceLight::lightAt(const LitMaps& maps, int i, int j) const
{
    const std::size_t k = m_lattice.index(i, j);
    const glm::vec3& normal = maps.normals[k];
    // Nothing shades an uncut flank. If a sample finds something, it is an effect of the lattice.
    const float free = isFlank(maps, k) ? 1.0F - glm::smoothstep(kFreeFull, kFreeNone, normal.z) : 0.0F;
    if (free == 1.0F)
        return kFreeLight;
    const glm::vec2 slope = -glm::vec2(normal) / std::max(normal.z, 0.12F);
    const Sky sky = skyAt(maps, i, j, slope);
    const float cut =
        (maps.wholeTop[k] - std::max(maps.top[k], maps.drawnTop[k]) - kCutFromMm) / (kCutFullMm - kCutFromMm);
    // Measured along the normal and not along the axis, so a bend in a flank does not count as a fissure.
    const float crevice = normal.z * normal.z * sky.crevice;
    const glm::vec4 found(sky.open, litAt(maps, i, j, slope), cut, 0.5F + 0.5F * crevice);
    return glm::clamp(glm::mix(found, kFreeLight, free), 0.0F, 1.0F);
}

/// Returns how much of the sky a node sees. In each direction the sky begins at the slope of the surface itself. Ground
/// above that takes away the square of the sine, as for the light that a flat patch receives.
SurfaceLight::Sky SurfaceLight::skyAt(const LitMaps& maps, int i, int j, glm::vec2 slope) const
{
    const std::size_t k = m_lattice.index(i, j);
    float open = 0.0F;
    float near = 0.0F;
    float far = 0.0F;
    for (std::size_t d = 0; d < m_sky.size(); ++d) {
        const float own = glm::dot(slope, m_directions[d]);
        float horizon = own;
        for (std::size_t s = 0; s < m_sky[d].size(); ++s) {
            horizon = std::max(horizon, climb(maps, maps.drawnTop, {i, j}, maps.drawnTop[k], m_sky[d][s]));
            if (s != kNearSample && s != kFarSample)
                continue;
            // Uses the solid heights, because little of a narrow fissure may be drawn.
            const float rises = climb(maps, maps.solidTop, {i, j}, maps.solidTop[k], m_sky[d][s]);
            if (rises > kUnknownRise)
                (s == kNearSample ? near : far) += rises - own;
        }
        const float along = 1.0F + horizon * own;
        const float above = along > 0.0F ? (horizon - own) / along : 1.0e3F;
        open += 1.0F / (1.0F + above * above);
    }
    constexpr auto kCount = static_cast<float>(kSkyDirections);
    return {open / kCount, (near - kBowlShare * std::max(far, 0.0F)) / kCount};
}

/// Returns the slope from a node up to another one, or kUnknownRise if the other one is not solid.
float SurfaceLight::climb(const LitMaps& maps, const std::vector<float>& tops, glm::ivec2 node, float here,
                          const Sample& sample) const
{
    const int x = node.x + sample.di;
    const int y = node.y + sample.dj;
    if (sample.distanceMm <= 0.0F || !m_lattice.contains(x, y) || !isSolid(maps, x, y))
        return kUnknownRise;
    return (tops[m_lattice.index(x, y)] - here) / sample.distanceMm;
}

/// Returns how much of the operating light reaches a node: below 0 in full shadow, above 1 in full light.
float SurfaceLight::litAt(const LitMaps& maps, int i, int j, glm::vec2 slope) const
{
    const int side = m_lattice.side;
    const auto cell = static_cast<float>(m_lattice.cellMm);
    const float here = maps.drawnTop[m_lattice.index(i, j)];
    const glm::vec2 across{m_towardsLight.x, m_towardsLight.y};
    const float run = glm::length(across);
    const float rise = run > kUpright ? m_towardsLight.z / run : 1.0e4F;
    const float facing = run > kUpright ? glm::dot(slope, across) / run : -1.0e3F;
    float blocked = -1.0e3F;
    for (const float t : m_lightPath) {
        // Interpolates between nodes; the edge of a shadow would show the lattice otherwise.
        const glm::vec2 at = glm::vec2(i, j) + across * (t / (run * cell));
        const int x = static_cast<int>(at.x);
        const int y = static_cast<int>(at.y);
        if (at.x < 0.0F || at.y < 0.0F || x + 1 >= side || y + 1 >= side)
            break;
        if (!isSolid(maps, x, y) || !isSolid(maps, x + 1, y) || !isSolid(maps, x, y + 1) ||
            !isSolid(maps, x + 1, y + 1))
            continue;
        const float u = at.x - static_cast<float>(x);
        const float v = at.y - static_cast<float>(y);
        const float* row = maps.drawnTop.data() + m_lattice.index(x, y);
        const float height = glm::mix(glm::mix(row[0], row[1], u), glm::mix(row[side], row[side + 1], u), v);
        blocked = std::max(blocked, (height - here) / t);
    }
    // A slope that faces away from the light counts as lit here, because its normal already darkens it.
    return (std::max(rise, facing) + kPenumbra - blocked) / (2.0F * kPenumbra);
}

/// Returns the mean light of the solid nodes around one. On a flank it averages along the flank and not over the ridge.
glm::vec4 SurfaceLight::meanAround(const LitMaps& maps, int i, int j) const
{
    const bool flank = isFlank(maps, m_lattice.index(i, j));
    const glm::vec3 normal = maps.normals[m_lattice.index(i, j)];
    glm::vec4 sum{0.0F};
    float weights = 0.0F;
    for (int dj = -kLightBlur; dj <= kLightBlur; ++dj) {
        for (int di = -kLightBlur; di <= kLightBlur; ++di) {
            if (!m_lattice.contains(i + di, j + dj) || !isSolid(maps, i + di, j + dj))
                continue;
            const std::size_t n = m_lattice.index(i + di, j + dj);
            auto weight = static_cast<float>((kLightBlur + 1 - std::abs(di)) * (kLightBlur + 1 - std::abs(dj)));
            if (flank)
                weight *= std::max(glm::dot(normal, maps.normals[n]), 0.01F);
            sum += weight * m_raw[n];
            weights += weight;
        }
    }
    return weights > 0.0F ? sum / weights : kFreeLight;
}

bool SurfaceLight::isSolid(const LitMaps& maps, int i, int j) const
{
    return maps.solidTop[m_lattice.index(i, j)] > kEmptyTop;
}

}  // namespace ui::render
