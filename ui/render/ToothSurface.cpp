// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/render/ToothSurface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/grading/Outline.h"
#include "core/terrain/Rim.h"
#include "ui/render/Junction.h"
#include "ui/render/SurfaceLayers.h"

namespace ui::render {
namespace {

using core::terrain::grown;
using core::terrain::kEmptyBottom;
using core::terrain::kEmptyTop;
using core::terrain::NodeRect;
using core::terrain::united;

/// Distance from a cut within which light is updated at once.
constexpr float kHurriedReachMm = 0.5F;
constexpr int kSweepNodes = 1000;  ///< nodes whose light is updated in one step
constexpr double kCrownMm = 8.0;   ///< largest height that counts as a tooth's crown
constexpr double kInsideMm = 2.0;  ///< distance from the outline, beyond which there is no flank
constexpr int kUncutReach = 3;     ///< distance to the next cut node, from which a flank is drawn as in an uncut tooth
constexpr float kThinnestMm = 1.0e-4F;  ///< thickness at which a solid column is drawn at least
constexpr int kFlankNodes = 3;          ///< nodes from the rim inwards whose height is averaged along the rim
constexpr float kFlankShift = 0.5F;     ///< cells that a node at a flank is moved at most
constexpr int kFlankReach = 5;          ///< range of the averaging, nodes
constexpr int kLipReach = 2;            ///< nodes over which a normal that turns sharply is averaged
constexpr float kLipFades = 0.5F;
constexpr float kLipTurns = 0.7F;  ///< cosine between neighbours below which a normal is averaged fully
constexpr float kLipFlat = 0.95F;  ///< and above which it is not averaged
constexpr int kOutlineBlur = 2;    ///< number of times that an outline is averaged over its neighbours
constexpr glm::vec2 kNoIdeal(0.0F, ToothSurface::kOutlineFarMm);
constexpr int kFissureReach = 5;     ///< range of averaging along a fissure to each side, nodes
constexpr float kGrooveFrom = 1.0F;  ///< curvature across minus along, 1/mm, from which a groove is a fissure
constexpr float kGrooveFull = 3.0F;

ToothSurface::PackedNormal pack(glm::vec3 n)
{
    const auto one = [](float v) {
        return static_cast<std::int16_t>(std::lround(32767.0F * std::clamp(v, -1.0F, 1.0F)));
    };
    return {one(n.x), one(n.y)};
}

}  // namespace

ToothSurface::ToothSurface(std::shared_ptr<const core::terrain::ToothAnatomy> anatomy, glm::vec3 towardsLight)
    : m_anatomy(std::move(anatomy))
{
    takeAnatomy();
    m_light.emplace(m_lattice, towardsLight);
    findResting();
    smoothFlanks();
    m_flanks.emplace(m_lattice, m_wholeTop, m_wholeBottom, m_flankTop, m_flankBottom);
    smoothFissures();
    SurfaceLayers layers = makeLayers(*m_anatomy, m_lattice, m_stride, m_wholeTop, m_wholeBottom, m_flankDej);
    m_upperLayers = std::move(layers.upper);
    m_lowerLayers = std::move(layers.lower);
    m_written = wholeOf(m_lattice);
    refresh();
    for (std::size_t k = 0; k < m_tops.size(); ++k)
        m_lowerLayers[k].z = m_tops[k];
}

void ToothSurface::takeAnatomy()
{
    const core::terrain::Grid& fine = m_anatomy->grid;
    m_stride = (fine.side + kMaxSide - 1) / kMaxSide;
    m_lattice = {(fine.side + m_stride - 1) / m_stride, fine.cellMm * m_stride, fine.originMm};
    const std::size_t count = m_lattice.count();
    m_wholeTop.resize(count);
    m_wholeBottom.resize(count);
    std::vector<float> pulpRoofs(count);
    m_lowestMm = glm::dvec3(1.0e9);
    m_highestMm = glm::dvec3(-1.0e9);
    for (int j = 0; j < m_lattice.side; ++j) {
        for (int i = 0; i < m_lattice.side; ++i) {
            const std::size_t from = fine.index(i * m_stride, j * m_stride);
            const std::size_t to = m_lattice.index(i, j);
            m_wholeTop[to] = m_anatomy->top[from];
            m_wholeBottom[to] = m_anatomy->bottom[from];
            pulpRoofs[to] = hasPulp(*m_anatomy, from) ? m_anatomy->layers[from].pulpRoof : kEmptyTop;
            if (m_wholeTop[to] > m_wholeBottom[to]) {
                const glm::dvec2 place = m_lattice.nodeMm(i, j);
                m_lowestMm = glm::min(m_lowestMm, glm::dvec3(place, m_wholeBottom[to]));
                m_highestMm = glm::max(m_highestMm, glm::dvec3(place, m_wholeTop[to]));
            }
        }
    }
    if (m_lowestMm.x > m_highestMm.x) {
        m_lowestMm = glm::dvec3(-1.0);
        m_highestMm = glm::dvec3(1.0);
    }
    m_top = m_wholeTop;
    m_bleeding.emplace(m_lattice, m_wholeTop, std::move(pulpRoofs));
    m_nodes.assign(count, Node::Empty);
    m_solidTop.assign(count, kEmptyTop);
    m_solidBottom.assign(count, kEmptyBottom);
    m_steep.emplace(m_lattice);
    m_drawnTop.assign(count, 0.0F);
    m_ideal.assign(count, kNoIdeal);
    m_shifts.assign(count, glm::vec2(0.0F));
    m_drawnBottom.assign(count, 0.0F);
    m_risen.assign(count, kEmptyTop);
    m_tops.assign(count, 0.0F);
    m_bottoms.assign(count, 0.0F);
    m_places.resize(count);
    for (auto& normals : m_rawNormals)
        normals.assign(count, glm::vec3(0.0F));
    for (auto& normals : m_calmNormals)
        normals.assign(count, glm::vec3(0.0F));
    m_topNormals.assign(count, PackedNormal{});
    m_bottomNormals.assign(count, PackedNormal{});
    m_tilesPerSide = (m_lattice.side - 1 + kTileCells - 1) / kTileCells;
    const auto tiles = static_cast<std::size_t>(m_tilesPerSide) * static_cast<std::size_t>(m_tilesPerSide);
    m_indices.assign(tiles * kTileIndices, 0);
    m_indexCounts.assign(tiles, 0);
}

/// Finds the resting height of the bur beside the tooth. A quarter of the tooth is lower, so a bur at this height is
/// beside the tooth and need not climb far. No fossa, fissure or lesion is lower: a lower place is always a flank near
/// the outline.
void ToothSurface::findResting()
{
    std::vector<float> heights;
    for (std::size_t k = 0; k < m_wholeTop.size(); ++k)
        if (m_wholeTop[k] > m_wholeBottom[k])
            heights.push_back(m_wholeTop[k]);
    m_beside.assign(m_lattice.count(), 1);
    if (heights.empty())
        return;
    const auto quarter = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 4);
    std::nth_element(heights.begin(), quarter, heights.end());
    m_restingMm = *quarter;

    const int side = m_lattice.side;
    // Distance to the outline in nodes, diagonal steps included.
    std::vector<int> inside(m_lattice.count(), 0);
    const int enough = static_cast<int>(std::ceil(kInsideMm / m_lattice.cellMm));
    std::vector<std::size_t> ring;
    for (std::size_t k = 0; k < inside.size(); ++k) {
        inside[k] = m_wholeTop[k] > m_wholeBottom[k] ? enough : 0;
        if (inside[k] == 0)
            ring.push_back(k);
    }
    for (int away = 1; away < enough; ++away) {
        std::vector<std::size_t> next;
        for (const std::size_t k : ring) {
            const int i = static_cast<int>(k % static_cast<std::size_t>(side));
            const int j = static_cast<int>(k / static_cast<std::size_t>(side));
            for (int dj = -1; dj <= 1; ++dj) {
                for (int di = -1; di <= 1; ++di) {
                    if (!m_lattice.contains(i + di, j + dj))
                        continue;
                    const std::size_t n = m_lattice.index(i + di, j + dj);
                    if (inside[n] > away) {
                        inside[n] = away;
                        next.push_back(n);
                    }
                }
            }
        }
        ring = std::move(next);
    }
    for (int j = 0; j < side; ++j) {
        for (int i = 0; i < side; ++i) {
            const std::size_t k = m_lattice.index(i, j);
            const core::terrain::ColumnLayers& column =
                m_anatomy->layers[m_anatomy->grid.index(i * m_stride, j * m_stride)];
            const bool isDecayed = column.cariesRoof > column.cariesFloor && column.cariesRoof >= m_wholeTop[k];
            if (inside[k] >= enough || (inside[k] > 0 && isDecayed))
                m_restingMm = std::min(m_restingMm, static_cast<double>(m_wholeTop[k]));
        }
    }
    for (std::size_t k = 0; k < inside.size(); ++k)
        m_beside[k] = inside[k] > 0 && static_cast<double>(m_wholeTop[k]) >= m_restingMm ? 0 : 1;
}

/// Smooths fissures. A fissure is hardly wider than a cell, so its bottom would rise and fall with the lattice. Where
/// the surface is curved like a groove, its heights are averaged along the groove.
void ToothSurface::smoothFissures()
{
    const int side = m_lattice.side;
    const auto cell = static_cast<float>(m_lattice.cellMm);
    constexpr int kAround = kFissureReach + 1;
    const std::vector<float> whole = m_flankTop;
    const auto calm = [&](int i, int j) {
        constexpr std::array<float, 3> kWeight{0.25F, 0.5F, 0.25F};
        float sum = 0.0F;
        for (int dj = -1; dj <= 1; ++dj)
            for (int di = -1; di <= 1; ++di)
                sum += kWeight[static_cast<std::size_t>(di + 1)] * kWeight[static_cast<std::size_t>(dj + 1)] *
                       whole[m_lattice.index(i + di, j + dj)];
        return sum;
    };
    for (int j = kAround; j < side - kAround; ++j) {
        for (int i = kAround; i < side - kAround; ++i) {
            bool inside = true;
            for (int dj = -kAround; dj <= kAround && inside; ++dj)
                for (int di = -kAround; di <= kAround && inside; ++di)
                    inside = whole[m_lattice.index(i + di, j + dj)] > m_wholeBottom[m_lattice.index(i + di, j + dj)];
            if (!inside)
                continue;
            // Second derivatives over two cells, and their principal directions.
            const float here = calm(i, j);
            const float area = 4.0F * cell * cell;
            const float xx = (calm(i + 2, j) + calm(i - 2, j) - 2.0F * here) / area;
            const float yy = (calm(i, j + 2) + calm(i, j - 2) - 2.0F * here) / area;
            const float xy =
                (calm(i + 2, j + 2) - calm(i + 2, j - 2) - calm(i - 2, j + 2) + calm(i - 2, j - 2)) / (4.0F * area);
            const float half = 0.5F * (xx + yy);
            const float apart = std::sqrt(0.25F * (xx - yy) * (xx - yy) + xy * xy);
            const float groove = glm::smoothstep(kGrooveFrom, kGrooveFull, half + apart - std::abs(half - apart));
            if (groove <= 0.0F)
                continue;
            const float angle = 0.5F * std::atan2(2.0F * xy, xx - yy);
            const glm::vec2 along(-std::sin(angle), std::cos(angle));
            float sum = 0.0F;
            float weights = 0.0F;
            for (int t = -kFissureReach; t <= kFissureReach; ++t) {
                const glm::vec2 at = glm::vec2(i, j) + static_cast<float>(t) * along;
                const glm::vec2 low = glm::floor(at);
                const glm::vec2 part = at - low;
                const float* row = whole.data() + m_lattice.index(static_cast<int>(low.x), static_cast<int>(low.y));
                const float height =
                    glm::mix(glm::mix(row[0], row[1], part.x), glm::mix(row[side], row[side + 1], part.x), part.y);
                const float weight = std::exp(-0.12F * static_cast<float>(t * t));
                sum += weight * height;
                weights += weight;
            }
            m_flankTop[m_lattice.index(i, j)] = glm::mix(whole[m_lattice.index(i, j)], sum / weights, groove);
        }
    }
}

/// Smooths flanks. Near the rim a flank falls by millimetres within a cell, so the height of its last nodes depends on
/// the lattice and would look like a comb. The heights are averaged along the rim, not across it.
void ToothSurface::smoothFlanks()
{
    m_flankTop = m_wholeTop;
    m_flankBottom = m_wholeBottom;
    m_flankShifts.assign(m_lattice.count(), glm::vec2(0.0F));
    const int side = m_lattice.side;
    m_flankDej.resize(m_lattice.count());
    for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i)
            m_flankDej[m_lattice.index(i, j)] =
                m_anatomy->layers[m_anatomy->grid.index(i * m_stride, j * m_stride)].dej;
    m_flankDej = drawnJunction(m_lattice, m_wholeTop, m_wholeBottom, std::move(m_flankDej));
    for (int j = 0; j < side; ++j) {
        for (int i = 0; i < side; ++i) {
            const std::size_t k = m_lattice.index(i, j);
            if (m_wholeTop[k] <= m_wholeBottom[k])
                continue;
            glm::vec2 outwards{0.0F};
            for (int dj = -kFlankNodes; dj <= kFlankNodes; ++dj) {
                for (int di = -kFlankNodes; di <= kFlankNodes; ++di) {
                    if (!m_lattice.contains(i + di, j + dj))
                        continue;
                    const std::size_t n = m_lattice.index(i + di, j + dj);
                    if (m_wholeTop[n] <= m_wholeBottom[n])
                        outwards += glm::vec2(di, dj) / static_cast<float>(di * di + dj * dj);
                }
            }
            if (outwards == glm::vec2(0.0F))
                continue;
            outwards = glm::normalize(outwards);
            float tops = 0.0F;
            float bottoms = 0.0F;
            float weights = 0.0F;
            for (int dj = -kFlankReach; dj <= kFlankReach; ++dj) {
                for (int di = -kFlankReach; di <= kFlankReach; ++di) {
                    if (!m_lattice.contains(i + di, j + dj))
                        continue;
                    const std::size_t n = m_lattice.index(i + di, j + dj);
                    if (m_wholeTop[n] <= m_wholeBottom[n])
                        continue;
                    const float across = glm::dot(glm::vec2(di, dj), outwards);
                    const float along = outwards.x * static_cast<float>(dj) - outwards.y * static_cast<float>(di);
                    const float weight = std::exp(-1.4F * across * across - 0.14F * along * along);
                    tops += weight * m_wholeTop[n];
                    bottoms += weight * m_wholeBottom[n];
                    weights += weight;
                }
            }
            m_flankTop[k] = tops / weights;
            // A node that was raised is moved inwards along the same flank; otherwise the outline would change.
            const glm::ivec2 inwards(glm::round(glm::vec2(i, j) - 1.5F * outwards));
            const std::size_t within = m_lattice.index(inwards.x, inwards.y);
            const float run = glm::length(glm::vec2(inwards - glm::ivec2(i, j))) * static_cast<float>(m_lattice.cellMm);
            const float steepness = std::max(1.0F, (m_wholeTop[within] - m_wholeTop[k]) / run);
            const float limit = kFlankShift * static_cast<float>(m_lattice.cellMm);
            m_flankShifts[k] = outwards * glm::clamp((m_wholeTop[k] - m_flankTop[k]) / steepness, -limit, limit);
            m_flankBottom[k] = std::min(bottoms / weights, m_flankTop[k]);
        }
    }
    // Where the junction is as steep as the neck that it meets, it is drawn the same way as the neck.
    std::vector<float> junction(m_lattice.count(), kEmptyTop);
    for (std::size_t k = 0; k < junction.size(); ++k)
        if (m_wholeTop[k] > m_wholeBottom[k])
            junction[k] = m_flankDej[k];
    m_steep->draw(junction, wholeOf(m_lattice), m_flankDej, m_shifts);
}

void ToothSurface::write(const core::servo::TilePatch& patch)
{
    const int x = patch.tileX * core::servo::kTileSide;
    const int y = patch.tileY * core::servo::kTileSide;
    const int first = (x + m_stride - 1) / m_stride;
    const int last = std::min((x + core::servo::kTileSide - 1) / m_stride, m_lattice.side - 1);
    const int firstRow = (y + m_stride - 1) / m_stride;
    const int lastRow = std::min((y + core::servo::kTileSide - 1) / m_stride, m_lattice.side - 1);
    for (int j = firstRow; j <= lastRow; ++j) {
        for (int i = first; i <= last; ++i) {
            float& here = m_top[m_lattice.index(i, j)];
            const float now =
                patch.top[static_cast<std::size_t>((j * m_stride - y) * core::servo::kTileSide + (i * m_stride - x))];
            if (here != now)
                m_written = united(m_written, {i, j, i + 1, j + 1});
            here = now;
        }
    }
}

void ToothSurface::write(const std::vector<float>& top)
{
    for (int j = 0; j < m_lattice.side; ++j)
        for (int i = 0; i < m_lattice.side; ++i)
            m_top[m_lattice.index(i, j)] = top[m_anatomy->grid.index(i * m_stride, j * m_stride)];
    m_written = wholeOf(m_lattice);
}

void ToothSurface::setLight(glm::vec3 towardsLight)
{
    if (towardsLight == m_light->direction())
        return;
    m_lightDue = wholeOf(m_lattice);
    m_light->setDirection(towardsLight);
}

std::size_t ToothSurface::Changes::bytes() const
{
    const auto nodes = [](const NodeRect& rect) {
        return static_cast<std::size_t>(std::max(0, rect.endI - rect.beginI)) *
               static_cast<std::size_t>(std::max(0, rect.endJ - rect.beginJ));
    };
    return nodes(heights) * (2 * sizeof(float) + sizeof(glm::vec2)) + nodes(normals) * 2 * sizeof(PackedNormal) +
           nodes(light) * sizeof(Light) + nodes(blood);
}

ToothSurface::Changes ToothSurface::refresh(bool hurried)
{
    Changes changes;
    const auto reached = [&](float mm) {
        return grown(changes.heights, static_cast<int>(std::ceil(mm / static_cast<float>(m_lattice.cellMm))) + 2,
                     m_lattice);
    };
    if (!m_written.isEmpty()) {
        sew(m_written);
        changes.heights = grown(m_written, SteepGround::kReach, m_lattice);
        changes.blood = m_bleeding->update(m_top, m_written);
        m_steep->draw(m_risen, changes.heights, m_drawnBottom, m_shifts);
        m_steep->draw(m_solidTop, changes.heights, m_drawnTop, m_shifts);
        smoothRim(changes.heights);
        smoothOutline(changes.heights);
        changes.triangles = buildTriangles(changes.heights);
        changes.normals = bendNormals(grown(changes.heights, core::terrain::kCalmReach + kLipReach + 1, m_lattice));
        m_lightDue = united(m_lightDue, reached(SurfaceLight::kShadowReachMm));
    }
    if (hurried && !changes.heights.isEmpty())
        changes.light = shineLight(reached(kHurriedReachMm));
    else if (!hurried && isBehind())
        changes.light = shineLight(united(std::exchange(m_lightDue, {}), std::exchange(m_sweep, {})));
    m_written = {};
    return changes;
}

ToothSurface::Changes ToothSurface::sweepLight()
{
    if (m_sweep.isEmpty())
        m_sweep = std::exchange(m_lightDue, {});
    Changes changes;
    if (m_sweep.isEmpty())
        return changes;
    const int rows = std::max(1, kSweepNodes / (m_sweep.endI - m_sweep.beginI));
    core::terrain::NodeRect some = m_sweep;
    some.endJ = std::min(some.beginJ + rows, some.endJ);
    m_sweep.beginJ = some.endJ;
    changes.light = shineLight(some);
    return changes;
}

/// Marks nodes with height as solid, and empty nodes joined to solid ones as rim.
void ToothSurface::sew(const NodeRect& written)
{
    for (int j = written.beginJ; j < written.endJ; ++j) {
        for (int i = written.beginI; i < written.endI; ++i) {
            const std::size_t k = m_lattice.index(i, j);
            const bool solid = m_top[k] > m_wholeBottom[k];
            const float drawn = m_top[k] < m_wholeTop[k] ? std::min(m_top[k], m_flankTop[k]) : m_flankTop[k];
            m_solidTop[k] = solid ? drawn : kEmptyTop;
            m_solidBottom[k] = solid ? std::min(m_flankBottom[k], drawn - kThinnestMm) : kEmptyBottom;
            m_risen[k] = solid ? -m_solidBottom[k] : kEmptyTop;
        }
    }
    core::terrain::sewRim(m_lattice, m_solidTop, m_solidBottom, written, m_sewn);
    const NodeRect rect = grown(written, 1, m_lattice);
    for (int j = rect.beginJ; j < rect.endJ; ++j) {
        for (int i = rect.beginI; i < rect.endI; ++i) {
            const std::size_t k = m_lattice.index(i, j);
            m_nodes[k] = m_solidTop[k] > kEmptyTop ? Node::Solid : m_sewn[k] > kEmptyTop ? Node::Rim : Node::Empty;
        }
    }
}

/// Calls use(node, weight) for the rim nodes at and around a position. Near nodes have larger weights.
template <class Use>
void ToothSurface::forRimAround(int i, int j, Use&& use) const
{
    constexpr float kFadesAt = kRimReach * kRimReach + 2.0F;
    for (int dj = -kRimReach; dj <= kRimReach; ++dj) {
        for (int di = -kRimReach; di <= kRimReach; ++di) {
            const float weight = 1.0F - static_cast<float>(di * di + dj * dj) / kFadesAt;
            if (weight <= 0.0F || !m_lattice.contains(i + di, j + dj))
                continue;
            const std::size_t n = m_lattice.index(i + di, j + dj);
            if (m_nodes[n] == Node::Rim)
                use(n, weight);
        }
    }
}

/// Smooths the rim. At a steep flank the last solid node, and with it the height of the rim, depends on the lattice. A
/// real rim has no such jumps, so the heights are averaged along it.
void ToothSurface::smoothRim(const NodeRect& rect)
{
    for (int j = rect.beginJ; j < rect.endJ; ++j) {
        for (int i = rect.beginI; i < rect.endI; ++i) {
            const std::size_t k = m_lattice.index(i, j);
            if (m_nodes[k] == Node::Solid) {
                m_tops[k] = m_drawnTop[k];
                m_bottoms[k] = std::min(-m_drawnBottom[k], m_drawnTop[k] - kThinnestMm);
            } else if (m_nodes[k] == Node::Rim) {
                float height = 0.0F;
                float weights = 0.0F;
                forRimAround(i, j, [&](std::size_t n, float weight) {
                    height += weight * m_sewn[n];
                    weights += weight;
                });
                m_tops[k] = m_bottoms[k] = height / weights;
            }
        }
    }
}

/// Moves rim nodes to the average of the rim nodes around them, so that the steps of the lattice become an outline.
void ToothSurface::smoothOutline(const NodeRect& rect)
{
    for (int j = rect.beginJ; j < rect.endJ; ++j) {
        for (int i = rect.beginI; i < rect.endI; ++i) {
            const std::size_t k = m_lattice.index(i, j);
            const glm::vec2 home(m_lattice.nodeMm(i, j));
            const glm::vec2 flank = m_top[k] < m_wholeTop[k] ? glm::vec2(0.0F) : m_flankShifts[k];
            m_places[k] = home + (m_nodes[k] == Node::Solid ? m_shifts[k] + flank : glm::vec2(0.0F));
            if (m_nodes[k] != Node::Rim)
                continue;
            glm::vec2 sum{0.0F};
            float weights = 0.0F;
            forRimAround(i, j, [&](std::size_t n, float weight) {
                sum += weight * glm::vec2(m_lattice.nodeMm(n));
                weights += weight;
            });
            // Moves a node less than half a cell, so that triangles do not turn over.
            const float limit = 0.45F * static_cast<float>(m_lattice.cellMm);
            m_places[k] = home + glm::clamp(sum / weights - home, -limit, limit);
        }
    }
}

/// Returns the slope of a height map by a 3 x 3 Sobel operator over the visible nodes. A missing node is replaced by
/// the mirror image of the opposite one.
glm::vec2 ToothSurface::slope(const std::vector<float>& heights, int i, int j) const
{
    const float here = heights[m_lattice.index(i, j)];
    const auto at = [&](int di, int dj) {
        if (isShown(i + di, j + dj))
            return heights[m_lattice.index(i + di, j + dj)];
        return isShown(i - di, j - dj) ? 2.0F * here - heights[m_lattice.index(i - di, j - dj)] : here;
    };
    const float cell = 8.0F * static_cast<float>(m_lattice.cellMm);
    const float e = at(1, -1) + 2.0F * at(1, 0) + at(1, 1);
    const float w = at(-1, -1) + 2.0F * at(-1, 0) + at(-1, 1);
    const float n = at(-1, 1) + 2.0F * at(0, 1) + at(1, 1);
    const float s = at(-1, -1) + 2.0F * at(0, -1) + at(1, -1);
    return {(e - w) / cell, (n - s) / cell};
}

/// Returns 1 if all nodes around a node are uncut, 0 if the node itself is cut, and values between them near a cut.
float ToothSurface::uncutAround(int i, int j) const
{
    int nearest2 = kUncutReach * kUncutReach;
    for (int dj = -kUncutReach; dj <= kUncutReach; ++dj)
        for (int di = -kUncutReach; di <= kUncutReach; ++di)
            if (m_lattice.contains(i + di, j + dj))
                if (const std::size_t n = m_lattice.index(i + di, j + dj); m_top[n] < m_wholeTop[n])
                    nearest2 = std::min(nearest2, di * di + dj * dj);
    return glm::smoothstep(1.0F, static_cast<float>(kUncutReach), std::sqrt(static_cast<float>(nearest2)));
}

float ToothSurface::flankNormal(std::size_t map, std::size_t k, glm::vec3& normal) const
{
    return m_flanks->normalAt(k, map == 0 ? Flanks::Side::Upper : Flanks::Side::Lower,
                              map == 0 ? m_tops[k] : m_bottoms[k], normal);
}

/// Returns a smoothed normal. At the lip of a cut the surface turns by a right angle within a cell, and the triangles
/// would be visible. The turn is therefore spread over a few cells.
glm::vec3 ToothSurface::softNormal(int map, int i, int j) const
{
    static const auto fades = [] {
        std::array<float, 2 * kLipReach * kLipReach + 1> fade{};
        for (std::size_t far2 = 0; far2 < fade.size(); ++far2)
            fade[far2] = std::exp(-kLipFades * static_cast<float>(far2));
        return fade;
    }();
    const std::vector<glm::vec3>& normals = m_calmNormals[map];
    const glm::vec3 own = normals[m_lattice.index(i, j)];
    glm::vec3 sum(0.0F);
    float least = 1.0F;
    for (int dj = -kLipReach; dj <= kLipReach; ++dj) {
        for (int di = -kLipReach; di <= kLipReach; ++di) {
            if (!isShown(i + di, j + dj))
                continue;
            const glm::vec3& normal = normals[m_lattice.index(i + di, j + dj)];
            least = std::min(least, glm::dot(own, normal));
            sum += normal * fades[static_cast<std::size_t>(di * di + dj * dj)];
        }
    }
    const float turn = 1.0F - glm::smoothstep(kLipTurns, kLipFlat, least);
    const float length = glm::length(sum);
    return turn <= 0.0F || length <= 0.0F ? own : glm::normalize(glm::mix(own, sum / length, turn));
}

NodeRect ToothSurface::bendNormals(const NodeRect& rect)
{
    // Normals of solid nodes come from the slopes. Normals of rim nodes come from their solid neighbours and point
    // straight outwards in both maps.
    const NodeRect calm = grown(rect, kLipReach, m_lattice);
    const NodeRect raw = grown(calm, core::terrain::kCalmReach, m_lattice);
    for (int j = raw.beginJ; j < raw.endJ; ++j) {
        for (int i = raw.beginI; i < raw.endI; ++i) {
            const std::size_t k = m_lattice.index(i, j);
            if (m_nodes[k] != Node::Solid)
                continue;
            for (std::size_t map = 0; map < 2; ++map) {
                glm::vec3& normal = m_rawNormals[map][k];
                const float share = isFlank(k) ? flankNormal(map, k, normal) : 0.0F;
                if (share == 1.0F)
                    continue;
                const glm::vec3 found =
                    map == 0 ? glm::vec3(-slope(m_tops, i, j), 1.0F) : glm::vec3(slope(m_bottoms, i, j), -1.0F);
                normal = share > 0.0F ? glm::normalize(glm::mix(glm::normalize(found), normal, share))
                                      : glm::normalize(found);
            }
        }
    }
    for (int j = raw.beginJ; j < raw.endJ; ++j) {
        for (int i = raw.beginI; i < raw.endI; ++i) {
            const std::size_t k = m_lattice.index(i, j);
            if (m_nodes[k] == Node::Solid)
                continue;
            if (m_nodes[k] == Node::Empty) {
                m_rawNormals[0][k] = m_rawNormals[1][k] = glm::vec3(0.0F);
                continue;
            }
            glm::vec2 outwards{0.0F};
            for (int dj = -2; dj <= 2; ++dj)
                for (int di = -2; di <= 2; ++di)
                    if (m_lattice.contains(i + di, j + dj) && isSolid(i + di, j + dj))
                        outwards -= glm::vec2(di, dj) / static_cast<float>(di * di + dj * dj);
            const float length = glm::length(outwards);
            const glm::vec3 normal = length > 0.0F ? glm::vec3(outwards / length, 0.0F) : glm::vec3(0.0F, 0.0F, 1.0F);
            m_rawNormals[0][k] = normal;
            m_rawNormals[1][k] = normal;
            if (isFlank(k) && flankNormal(0, k, m_rawNormals[0][k]) > 0.0F)
                m_rawNormals[1][k] = m_rawNormals[0][k];
        }
    }
    for (int map = 0; map < 2; ++map)
        core::terrain::calmSteepNormals(m_lattice, m_rawNormals[map], calm, m_calmNormals[map]);
    NodeRect changed;
    for (int j = rect.beginJ; j < rect.endJ; ++j) {
        for (int i = rect.beginI; i < rect.endI; ++i) {
            const std::size_t k = m_lattice.index(i, j);
            std::array<glm::vec3, 2> round{};
            std::array<float, 2> share{};
            if (m_nodes[k] != Node::Empty && m_flanks->isNear(k)) {
                share = {flankNormal(0, k, round[0]), flankNormal(1, k, round[1])};
                const float uncut = share[0] + share[1] > 0.0F ? uncutAround(i, j) : 0.0F;
                share = {uncut * share[0], uncut * share[1]};
            }
            const auto bent = [&](std::size_t map) {
                if (share[map] == 1.0F)
                    return round[map];
                const glm::vec3 soft = softNormal(static_cast<int>(map), i, j);
                return share[map] > 0.0F ? glm::normalize(glm::mix(soft, round[map], share[map])) : soft;
            };
            glm::vec3 top = bent(0);
            glm::vec3 bottom = bent(1);
            // Both surfaces get the same normal where they meet, so that the seam is invisible.
            if (m_nodes[k] == Node::Rim)
                if (const glm::vec3 both = top + bottom; glm::dot(both, both) > 0.0F)
                    top = bottom = glm::normalize(both);
            const PackedNormal before[] = {m_topNormals[k], m_bottomNormals[k]};
            m_topNormals[k] = pack(top);
            m_bottomNormals[k] = pack(bottom);
            if (m_topNormals[k] != before[0] || m_bottomNormals[k] != before[1])
                changed = united(changed, {i, j, i + 1, j + 1});
        }
    }
    return changed;
}

NodeRect ToothSurface::shineLight(const NodeRect& rect)
{
    return m_light->shine({m_wholeTop, m_top, m_solidTop, m_drawnTop, m_rawNormals[0], *m_flanks}, rect);
}

std::vector<ToothSurface::Stretch> ToothSurface::buildTriangles(const NodeRect& rect)
{
    std::vector<Stretch> changed;
    const int cells = m_lattice.side - 1;
    const auto tileOf = [](int cell) { return cell / kTileCells; };
    const int lastTileX = std::min(tileOf(rect.endI - 1), m_tilesPerSide - 1);
    const int lastTileY = std::min(tileOf(rect.endJ - 1), m_tilesPerSide - 1);
    for (int tileY = tileOf(std::max(0, rect.beginJ - 1)); tileY <= lastTileY; ++tileY) {
        for (int tileX = tileOf(std::max(0, rect.beginI - 1)); tileX <= lastTileX; ++tileX) {
            const std::size_t tile = static_cast<std::size_t>(tileY * m_tilesPerSide + tileX);
            std::size_t at = tile * kTileIndices;
            const std::size_t begin = at;
            Stretch differs{at + kTileIndices, at};
            const auto triangle = [&](std::size_t a, std::size_t b, std::size_t c) {
                // Three rim nodes lie in both surfaces, so nothing is drawn between them.
                if (m_nodes[a] != Node::Solid && m_nodes[b] != Node::Solid && m_nodes[c] != Node::Solid)
                    return;
                if (m_nodes[a] == Node::Empty || m_nodes[b] == Node::Empty || m_nodes[c] == Node::Empty)
                    return;
                for (const std::size_t node : {a, b, c}) {
                    if (m_indices[at] != node)
                        differs = {std::min(differs.begin, at), at + 1};
                    m_indices[at++] = static_cast<std::uint32_t>(node);
                }
            };
            for (int j = tileY * kTileCells; j < std::min((tileY + 1) * kTileCells, cells); ++j) {
                for (int i = tileX * kTileCells; i < std::min((tileX + 1) * kTileCells, cells); ++i) {
                    const std::size_t a = m_lattice.index(i, j);
                    const std::size_t b = m_lattice.index(i + 1, j);
                    const std::size_t c = m_lattice.index(i + 1, j + 1);
                    const std::size_t d = m_lattice.index(i, j + 1);
                    // The flatter diagonal runs along a wall instead of across it.
                    if (std::abs(m_tops[a] - m_tops[c]) <= std::abs(m_tops[b] - m_tops[d])) {
                        triangle(a, b, c);
                        triangle(a, c, d);
                    } else {
                        triangle(a, b, d);
                        triangle(b, c, d);
                    }
                }
            }
            m_indexCounts[tile] = static_cast<int>(at - begin);
            if (differs.begin < differs.end)
                changed.push_back(differs);
        }
    }
    return changed;
}

float ToothSurface::pickHeight(std::size_t k) const
{
    if (m_beside[k] != 0)
        return static_cast<float>(m_restingMm);
    return m_nodes[k] == Node::Solid ? m_top[k] : m_wholeBottom[k];
}

double ToothSurface::heightMm(glm::dvec2 pointMm) const
{
    const glm::dvec2 at = m_lattice.latticeOf(pointMm);
    if (at.x < 0.0 || at.y < 0.0 || at.x >= m_lattice.side - 1 || at.y >= m_lattice.side - 1)
        return m_restingMm;
    return between(pointMm, [this](std::size_t k) { return pickHeight(k); });
}

/// Interpolates between the four nodes around a point on the lattice. At the edge it returns the nearest value.
template <class Value>
double ToothSurface::between(glm::dvec2 pointMm, Value&& value) const
{
    const glm::dvec2 at = glm::clamp(m_lattice.latticeOf(pointMm), glm::dvec2(0.0), glm::dvec2(m_lattice.side - 1));
    const int i = std::min(static_cast<int>(at.x), m_lattice.side - 2);
    const int j = std::min(static_cast<int>(at.y), m_lattice.side - 2);
    const double u = at.x - i;
    const double v = at.y - j;
    const auto of = [&](int x, int y) { return static_cast<double>(value(m_lattice.index(x, y))); };
    return (1.0 - v) * ((1.0 - u) * of(i, j) + u * of(i + 1, j)) +
           v * ((1.0 - u) * of(i, j + 1) + u * of(i + 1, j + 1));
}

/// Interpolates as between() does if all four nodes exist. Otherwise returns the nearest node's value if that node
/// exists.
template <class IsThere, class Value>
std::optional<double> ToothSurface::where(glm::dvec2 pointMm, IsThere&& isThere, Value&& value) const
{
    const glm::dvec2 at = m_lattice.latticeOf(pointMm);
    const auto has = [&](int i, int j) { return m_lattice.contains(i, j) && isThere(m_lattice.index(i, j)); };
    const int i = static_cast<int>(std::floor(at.x));
    const int j = static_cast<int>(std::floor(at.y));
    if (has(i, j) && has(i + 1, j) && has(i, j + 1) && has(i + 1, j + 1))
        return between(pointMm, value);
    const int nearI = static_cast<int>(std::lround(at.x));
    const int nearJ = static_cast<int>(std::lround(at.y));
    if (!has(nearI, nearJ))
        return std::nullopt;
    return value(m_lattice.index(nearI, nearJ));
}

std::optional<double> ToothSurface::topMm(glm::dvec2 pointMm) const
{
    return where(
        pointMm, [this](std::size_t k) { return m_nodes[k] == Node::Solid; },
        [this](std::size_t k) { return m_top[k]; });
}

double ToothSurface::belowUncutMm(const glm::dvec3& pointMm) const
{
    const auto uncut = where(
        glm::dvec2(pointMm), [this](std::size_t k) { return m_wholeTop[k] > m_wholeBottom[k]; },
        [this](std::size_t k) { return m_wholeTop[k]; });
    return uncut.value_or(pointMm.z) - pointMm.z;
}

double ToothSurface::belowIdealMm(const glm::dvec3& pointMm) const
{
    return belowUncutMm(pointMm) - between(glm::dvec2(pointMm), [this](std::size_t k) { return m_ideal[k].x; });
}

void ToothSurface::setIdeal(const core::grading::IdealTop& ideal)
{
    m_ideal.assign(m_lattice.count(), kNoIdeal);
    if (!ideal)
        return;
    for (int j = 0; j < m_lattice.side; ++j) {
        for (int i = 0; i < m_lattice.side; ++i) {
            const std::size_t k = m_lattice.index(i, j);
            const float wanted = (*ideal)[m_anatomy->grid.index(i * m_stride, j * m_stride)];
            if (m_wholeTop[k] > m_wholeBottom[k])
                m_ideal[k].x = m_wholeTop[k] - std::max(wanted, m_wholeBottom[k]);
        }
    }
    const core::grading::Outline outline(*m_anatomy, *ideal);
    for (const core::grading::Outline::Segment& segment : outline.segments()) {
        const glm::dvec2 reach(kOutlineFarMm);
        const glm::dvec2 low = m_lattice.latticeOf(glm::min(segment.fromMm, segment.toMm) - reach);
        const glm::dvec2 high = m_lattice.latticeOf(glm::max(segment.fromMm, segment.toMm) + reach);
        for (int j = std::max(0, static_cast<int>(low.y)); j <= std::min(m_lattice.side - 1, static_cast<int>(high.y));
             ++j)
            for (int i = std::max(0, static_cast<int>(low.x));
                 i <= std::min(m_lattice.side - 1, static_cast<int>(high.x)); ++i) {
                float& awayMm = m_ideal[m_lattice.index(i, j)].y;
                awayMm = std::min(awayMm, static_cast<float>(segment.distanceMm(m_lattice.nodeMm(i, j))));
            }
    }
    for (int j = 0; j < m_lattice.side; ++j)
        for (int i = 0; i < m_lattice.side; ++i)
            if (outline.insideMm(i * m_stride, j * m_stride) > 0.0)
                m_ideal[m_lattice.index(i, j)].y *= -1.0F;
    smoothIdealOutline();
}

/// Averages the outline over its neighbours (1 2 1 along x and y), so that the outline of an upright wall does not show
/// the lattice.
void ToothSurface::smoothIdealOutline()
{
    const auto side = static_cast<std::size_t>(m_lattice.side);
    for (int pass = 0; pass < 2 * kOutlineBlur; ++pass) {
        const std::size_t step = pass % 2 == 0 ? 1 : side;
        const std::size_t next = pass % 2 == 0 ? side : 1;
        for (std::size_t line = 0; line < side; ++line) {
            float before = m_ideal[line * next].y;
            for (std::size_t n = 0; n + 1 < side; ++n) {
                float& here = m_ideal[line * next + n * step].y;
                const float after = m_ideal[line * next + (n + 1) * step].y;
                const float was = here;
                here = 0.25F * (before + after) + 0.5F * was;
                before = was;
            }
        }
    }
}

double ToothSurface::highestWithinMm(glm::dvec2 centreMm, double radiusMm) const
{
    const glm::dvec2 at = m_lattice.latticeOf(centreMm);
    const double reach = radiusMm / m_lattice.cellMm;
    double highest = heightMm(centreMm);
    for (int j = static_cast<int>(std::ceil(at.y - reach)); j <= static_cast<int>(std::floor(at.y + reach)); ++j)
        for (int i = static_cast<int>(std::ceil(at.x - reach)); i <= static_cast<int>(std::floor(at.x + reach)); ++i)
            if (m_lattice.contains(i, j) && (i - at.x) * (i - at.x) + (j - at.y) * (j - at.y) <= reach * reach)
                highest = std::max(highest, static_cast<double>(pickHeight(m_lattice.index(i, j))));
    return highest;
}

double ToothSurface::highestBetweenMm(glm::dvec2 fromMm, glm::dvec2 toMm, double radiusMm) const
{
    const double length = glm::distance(fromMm, toMm);
    const int steps = static_cast<int>(std::ceil(length / std::max(radiusMm, m_lattice.cellMm)));
    double highest = highestWithinMm(toMm, radiusMm);
    for (int k = 0; k < steps; ++k)
        highest = std::max(highest, highestWithinMm(glm::mix(fromMm, toMm, static_cast<double>(k) / steps), radiusMm));
    return highest;
}

glm::dvec3 ToothSurface::crownMiddleMm() const
{
    const double height = std::min(m_highestMm.z - m_lowestMm.z, kCrownMm);
    return {glm::dvec2(m_lowestMm + m_highestMm) * 0.5, m_highestMm.z - 0.38 * height};
}

double ToothSurface::crownRadiusMm() const
{
    const glm::dvec3 size = m_highestMm - m_lowestMm;
    return 0.5 * glm::length(glm::dvec3(size.x, size.y, std::min(size.z, kCrownMm)));
}

bool ToothSurface::meetPlane(const Ray& ray, double heightMm, glm::dvec3& pointMm)
{
    // Rejects rays that are nearly horizontal, which would be followed for metres.
    if (ray.direction.z > -0.02)
        return false;
    pointMm = ray.originMm + ray.direction * ((heightMm - ray.originMm.z) / ray.direction.z);
    return true;
}

/// Returns the point where a ray first falls below a height. `height` returns that height for a point seen from above.
template <class Height>
std::optional<glm::dvec3> ToothSurface::firstBelow(const Ray& ray, Height&& height) const
{
    glm::dvec3 above;
    glm::dvec3 below;
    if (!meetPlane(ray, m_highestMm.z + 0.01, above) || !meetPlane(ray, m_lowestMm.z - 0.01, below))
        return std::nullopt;
    const double length = glm::length(below - above);
    const double step = 0.5 * m_lattice.cellMm;
    double before = 0.0;
    for (double along = 0.0; along < length; along += step) {
        const glm::dvec3 point = above + ray.direction * along;
        if (point.z > height(glm::dvec2(point))) {
            before = along;
            continue;
        }
        double after = along;
        for (int halving = 0; halving < 16; ++halving) {
            const double middle = 0.5 * (before + after);
            const glm::dvec3 at = above + ray.direction * middle;
            (at.z > height(glm::dvec2(at)) ? before : after) = middle;
        }
        return above + ray.direction * after;
    }
    return std::nullopt;
}

bool ToothSurface::meet(const Ray& ray, glm::dvec3& pointMm) const
{
    if (const auto met = firstBelow(ray, [this](glm::dvec2 at) { return heightMm(at); })) {
        pointMm = *met;
        return true;
    }
    return meetPlane(ray, m_lowestMm.z - 0.01, pointMm);
}

std::optional<glm::dvec3> ToothSurface::meetTooth(const Ray& ray) const
{
    return firstBelow(ray, [this](glm::dvec2 at) { return topMm(at).value_or(core::terrain::kEmptyTop); });
}

}  // namespace ui::render
