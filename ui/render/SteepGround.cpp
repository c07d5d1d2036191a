// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/render/SteepGround.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/terrain/Tooth.h"

namespace ui::render {
namespace {

using core::terrain::grown;
using core::terrain::kEmptyTop;
using core::terrain::NodeRect;

constexpr float kSteepFrom = 0.6F;      ///< slope of the blurred heights, mm per mm: 30 degrees
constexpr float kSteepestSlope = 1.4F;  ///< 55 degrees
constexpr float kSharpFrom = 0.12F;     ///< change that the blur makes at a crest or in a narrow groove, cells
constexpr float kSharpFull = 0.4F;
/// Weights of the blur along one axis, from the middle outwards: a Gaussian of 1.15 cells.
constexpr std::array<float, 4> kBlur{1.0F, 0.685F, 0.220F, 0.033F};
constexpr float kBlurSum = 2.876F;  ///< of all seven weights
/// Share of the blur's weight that must fall on existing nodes. Nodes beside empty ones are not blurred.
constexpr float kWholeFrom = 0.97F;
constexpr int kBlurReach = static_cast<int>(kBlur.size()) - 1;
constexpr int kWallReach = 3;        ///< distance within which the foot and lip of a wall are searched for, nodes
constexpr float kPull = 0.5F;        ///< share of the distance to the middle of the wall by which a node is moved
constexpr float kMostShift = 0.46F;  ///< largest move, cells: triangles must not turn over

float smooth(float from, float to, float value)
{
    const float t = std::clamp((value - from) / (to - from), 0.0F, 1.0F);
    return t * t * (3.0F - 2.0F * t);
}

/// Calls `use` with the column and row of each node in a rectangle.
template <class Use>
void each(const NodeRect& in, const Use& use)
{
    for (int j = in.beginJ; j < in.endJ; ++j)
        for (int i = in.beginI; i < in.endI; ++i)
            use(i, j);
}

}  // namespace

SteepGround::SteepGround(const core::terrain::Grid& lattice)
    : m_lattice(lattice), m_passed(lattice.count()), m_weights(lattice.count()), m_blurred(lattice.count()),
      m_whole(lattice.count()), m_low(lattice.count()), m_high(lattice.count())
{}

/// Blurs the heights of existing nodes, and finds the lowest and highest ground near each node.
void SteepGround::blur(const std::vector<float>& tops, const NodeRect& rect)
{
    const int side = m_lattice.side;
    const auto index = [&](int i, int j) { return m_lattice.index(i, j); };
    const auto isThere = [&](std::size_t k) { return tops[k] > kEmptyTop; };
    each(grown(rect, 1 + kBlurReach, m_lattice), [&](int i, int j) {
        float sum = 0.0F;
        float weights = 0.0F;
        float low = 1.0e9F;
        float high = -1.0e9F;
        for (int d = -kBlurReach; d <= kBlurReach; ++d) {
            if (i + d < 0 || i + d >= side || !isThere(index(i + d, j)))
                continue;
            const float top = tops[index(i + d, j)];
            const float weight = kBlur[static_cast<std::size_t>(std::abs(d))];
            sum += weight * top;
            weights += weight;
            low = std::min(low, top);
            high = std::max(high, top);
        }
        const std::size_t k = index(i, j);
        m_passed[k] = sum;
        m_weights[k] = weights;
        m_low[k] = low;
        m_high[k] = high;
    });
    each(grown(rect, 1, m_lattice), [&](int i, int j) {
        float sum = 0.0F;
        float weights = 0.0F;
        for (int d = -kBlurReach; d <= kBlurReach; ++d) {
            if (j + d < 0 || j + d >= side)
                continue;
            const float weight = kBlur[static_cast<std::size_t>(std::abs(d))];
            sum += weight * m_passed[index(i, j + d)];
            weights += weight * m_weights[index(i, j + d)];
        }
        const std::size_t k = index(i, j);
        m_blurred[k] = weights > 0.0F ? sum / weights : 0.0F;
        m_whole[k] = smooth(kWholeFrom, 1.0F, weights / (kBlurSum * kBlurSum));
    });
}

void SteepGround::draw(const std::vector<float>& tops, const NodeRect& rect, std::vector<float>& drawn,
                       std::vector<glm::vec2>& shifts)
{
    const int side = m_lattice.side;
    const auto cell = static_cast<float>(m_lattice.cellMm);
    const auto index = [&](int i, int j) { return m_lattice.index(i, j); };
    const auto isThere = [&](std::size_t k) { return tops[k] > kEmptyTop; };
    blur(tops, rect);
    each(rect, [&](int i, int j) {
        const std::size_t k = index(i, j);
        shifts[k] = glm::vec2(0.0F);
        if (!isThere(k))
            return;
        drawn[k] = tops[k];
        if (m_whole[k] == 0.0F || i == 0 || j == 0 || i == side - 1 || j == side - 1)
            return;
        const glm::vec2 slope = glm::vec2(m_blurred[index(i + 1, j)] - m_blurred[index(i - 1, j)],
                                          m_blurred[index(i, j + 1)] - m_blurred[index(i, j - 1)]) /
                                (2.0F * cell);
        const float steep2 = glm::dot(slope, slope);
        const float off = std::abs(tops[k] - m_blurred[k]) / cell;
        const float share =
            m_whole[k] * std::max(smooth(kSteepFrom * kSteepFrom, kSteepestSlope * kSteepestSlope, steep2),
                                  smooth(kSharpFrom, kSharpFull, off));
        if (share == 0.0F)
            return;
        drawn[k] = glm::mix(tops[k], m_blurred[k], share);
        float low = 1.0e9F;
        float high = -1.0e9F;
        for (int d = -kWallReach; d <= kWallReach; ++d) {
            if (j + d < 0 || j + d >= side)
                continue;
            low = std::min(low, m_low[index(i, j + d)]);
            high = std::max(high, m_high[index(i, j + d)]);
        }
        const float above = (m_blurred[k] - 0.5F * (low + high)) / (steep2 + 1.0F);
        const float limit = kMostShift * cell;
        shifts[k] = glm::clamp(-kPull * share * smooth(1.0F, 9.0F, steep2) * above * slope, -limit, limit);
    });
}

}  // namespace ui::render
