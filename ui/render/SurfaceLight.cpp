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

/// Distances at which the sky is looked for, mm: close ones for fissures, far ones for cusps and cavity walls.
constexpr std::array<float, 7> kSkyReachMm{0.08F, 0.16F, 0.28F, 0.5F, 0.85F, 1.4F, 2.2F};
/// The two of them at which a fissure is told from a fossa: the walls of a fissure rise at once and no more after
/// that, those of a bowl rise ever more.
constexpr std::size_t kNearSample = 2;
constexpr std::size_t kFarSample = 4;
constexpr float kBowlShare = 0.5F;
constexpr float kUnknownRise = -1.0e3F;  ///< where there is no ground to rise
/// Half-width of the light's own disc as a tangent: what makes the edge of a shadow soft.
constexpr float kPenumbra = 0.5F;
constexpr float kUpright = 1.0e-4F;  ///< horizontal part of a light that comes straight from above
/// Depth below the whole surface at which a spot counts as cut, mm.
constexpr float kCutFromMm = 0.01F;
constexpr float kCutFullMm = 0.06F;
constexpr int kBlur = 3;            ///< nodes around one that its light is averaged over
constexpr float kFreeFull = 0.25F;  ///< z of the normal of a flank up to which it has the sky for itself
constexpr float kFreeNone = 0.6F;
constexpr glm::vec4 kFreeLight(1.0F, 1.0F, 0.0F, 0.5F);

std::uint8_t toByte(float value)
{
    return static_cast<std::uint8_t>(std::lround(255.0F * std::clamp(value, 0.0F, 1.0F)));
}

/// True for uncut ground near the rim.
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
    // Raw values on solid nodes; then each node takes the average of the solid ones around it, the rim as well.
    const NodeRect raw = core::terrain::grown(rect, kBlur, m_lattice);
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

/// Returns the light of a solid node by itself, as in Light, 0 to 1.
glm::vec4 SurfaceLight::lightAt(const LitMaps& maps, int i, int j) const
{
    const std::size_t k = m_lattice.index(i, j);
    const glm::vec3& normal = maps.normals[k];
    // Nothing stands before an uncut flank; that something seems to is the lattice's doing.
    const float free = isFlank(maps, k) ? 1.0F - glm::smoothstep(kFreeFull, kFreeNone, normal.z) : 0.0F;
    if (free == 1.0F)
        return kFreeLight;
    const glm::vec2 slope = -glm::vec2(normal) / std::max(normal.z, 0.12F);
    const Sky sky = skyAt(maps, i, j, slope);
    const float cut =
        (maps.wholeTop[k] - std::max(maps.top[k], maps.drawnTop[k]) - kCutFromMm) / (kCutFullMm - kCutFromMm);
    // Along the normal, not along the axis: a bend in a flank is no fissure.
    const float crevice = normal.z * normal.z * sky.crevice;
    const glm::vec4 found(sky.open, litAt(maps, i, j, slope), cut, 0.5F + 0.5F * crevice);
    return glm::clamp(glm::mix(found, kFreeLight, free), 0.0F, 1.0F);
}

/// Returns how much of the sky a node sees. Towards each side the sky begins at the slope of the surface itself; what
/// stands above that takes away the square of a sine, as of the light that a flat patch receives.
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
            // A fissure may be so narrow that little of it is drawn.
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

/// Returns the slope from a node up to another one; kUnknownRise where that is not solid.
float SurfaceLight::climb(const LitMaps& maps, const std::vector<float>& tops, glm::ivec2 node, float here,
                          const Sample& sample) const
{
    const int x = node.x + sample.di;
    const int y = node.y + sample.dj;
    if (sample.distanceMm <= 0.0F || !m_lattice.contains(x, y) || !isSolid(maps, x, y))
        return kUnknownRise;
    return (tops[m_lattice.index(x, y)] - here) / sample.distanceMm;
}

/// Returns how much of the operating light arrives at a node: below 0 in full shadow, above 1 in full light.
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
        // Between nodes, or the edge of a shadow would have their steps.
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
    // A slope that turns away is not in shadow by this measure: its normal says enough.
    return (std::max(rise, facing) + kPenumbra - blocked) / (2.0F * kPenumbra);
}

/// Returns the mean light of the solid nodes around one: on a flank along it, not over the ridge that it ends at.
glm::vec4 SurfaceLight::meanAround(const LitMaps& maps, int i, int j) const
{
    const bool flank = isFlank(maps, m_lattice.index(i, j));
    const glm::vec3 normal = maps.normals[m_lattice.index(i, j)];
    glm::vec4 sum{0.0F};
    float weights = 0.0F;
    for (int dj = -kBlur; dj <= kBlur; ++dj) {
        for (int di = -kBlur; di <= kBlur; ++di) {
            if (!m_lattice.contains(i + di, j + dj) || !isSolid(maps, i + di, j + dj))
                continue;
            const std::size_t n = m_lattice.index(i + di, j + dj);
            auto weight = static_cast<float>((kBlur + 1 - std::abs(di)) * (kBlur + 1 - std::abs(dj)));
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
