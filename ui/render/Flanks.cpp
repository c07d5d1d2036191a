// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/render/Flanks.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

namespace ui::render {
namespace {

constexpr int kReach = 14;           ///< from the rim inwards, nodes
constexpr float kFadesFrom = 9.0F;   ///< nodes
constexpr float kSteepFull = 0.6F;   ///< z of a normal below which a flank is taken as round
constexpr float kSteepNone = 0.8F;   ///< and above which it is not
constexpr float kDeepFromMm = 2.0F;  ///< below the contour, where crowns become roots: no longer round
constexpr float kDeepFullMm = 3.5F;
constexpr int kContourReach = 7;  ///< along the rim, nodes
constexpr float kContourBlur = 4.0F;
constexpr int kSlopeReach = 7;
constexpr float kBlurAcross = 2.0F;  ///< the rim, nodes
constexpr float kBlurAlong = 3.5F;
constexpr float kFallsFrom = 0.3F;  ///< mm a mm towards the rim: less steep and it is no flank, but a ridge
constexpr float kFallsFull = 0.9F;
constexpr float kOwnFrom = 1.5F;  ///< from the rim, nodes: from where the slope of a node's own height counts
constexpr float kOwnFull = 4.0F;
constexpr float kAlikeMm = 0.25F;  ///< of heights: what is much higher or lower says less of a node

/// A plane through values around a node, by weighted least squares; places in cells.
struct Plane
{
    double ones = 0.0;  ///< sums of weights, and of weights times places
    double x = 0.0;
    double y = 0.0;
    double xx = 0.0;
    double xy = 0.0;
    double yy = 0.0;
    glm::dvec3 values{0.0};

    void add(glm::dvec2 at, double value, double weight)
    {
        ones += weight;
        x += weight * at.x;
        y += weight * at.y;
        xx += weight * (at.x * at.x);
        xy += weight * (at.x * at.y);
        yy += weight * (at.y * at.y);
        values += weight * value * glm::dvec3(1.0, at);
    }
    [[nodiscard]] glm::dmat3 squares() const { return {ones, x, y, x, xx, xy, y, xy, yy}; }
    [[nodiscard]] bool isKnown() const
    {
        return ones > 0.0 && glm::determinant(squares()) > 1.0e-3 * ones * ones * ones;
    }
    [[nodiscard]] glm::vec2 slopePerCell() const
    {
        const glm::dvec3 found = glm::inverse(squares()) * values;
        return {static_cast<float>(found.y), static_cast<float>(found.z)};
    }
};

struct Contour
{
    glm::ivec2 node;
    float heightMm;
};

}  // namespace

Flanks::Flanks(const core::terrain::Grid& lattice, const std::vector<float>& tops, const std::vector<float>& bottoms,
               const std::vector<float>& drawnTops, const std::vector<float>& drawnBottoms)
    : m_nodes(lattice.count())
{
    const int side = lattice.side;
    const auto cell = static_cast<float>(lattice.cellMm);
    const auto isSolid = [&](int i, int j) {
        return lattice.contains(i, j) && tops[lattice.index(i, j)] > bottoms[lattice.index(i, j)];
    };
    // On the rim, the height at which top and bottom would meet: where columns are thin, their middles go there evenly.
    std::vector<Contour> contour;
    std::vector<float> distance(lattice.count(), 1.0e9F);
    std::vector<glm::vec2> inwards(lattice.count(), glm::vec2(0.0F));
    for (int j = 0; j < side; ++j) {
        for (int i = 0; i < side; ++i) {
            bool isRim = false;
            for (int dj = -1; dj <= 1 && !isSolid(i, j); ++dj)
                for (int di = -1; di <= 1; ++di)
                    isRim = isRim || isSolid(i + di, j + dj);
            if (!isRim)
                continue;
            m_nodes[lattice.index(i, j)].isRim = true;
            double sum = 0.0;
            double thick = 0.0;
            double thick2 = 0.0;
            double middle = 0.0;
            double both = 0.0;
            for (int dj = -kReach; dj <= kReach; ++dj) {
                for (int di = -kReach; di <= kReach; ++di) {
                    if (!isSolid(i + di, j + dj))
                        continue;
                    const std::size_t n = lattice.index(i + di, j + dj);
                    const auto far2 = static_cast<float>(di * di + dj * dj);
                    distance[n] = std::min(distance[n], std::sqrt(far2));
                    inwards[n] += glm::vec2(di, dj) / (far2 * far2);
                    if (std::max(std::abs(di), std::abs(dj)) > kContourReach)
                        continue;
                    const auto t = static_cast<double>(tops[n] - bottoms[n]);
                    const double m = 0.5 * static_cast<double>(tops[n] + bottoms[n]);
                    const double weight = std::exp(-0.06 * static_cast<double>(far2)) / ((0.3 + t) * (0.3 + t));
                    sum += weight;
                    thick += weight * t;
                    thick2 += weight * t * t;
                    middle += weight * m;
                    both += weight * t * m;
                }
            }
            const double spread = sum * thick2 - thick * thick;
            const double at = spread > 1.0e-3 * sum * sum ? (middle * thick2 - thick * both) / spread : middle / sum;
            contour.push_back({{i, j}, static_cast<float>(at)});
        }
    }
    // From there inwards.
    for (int j = 0; j < side; ++j) {
        for (int i = 0; i < side; ++i) {
            Node& node = m_nodes[lattice.index(i, j)];
            const float away = node.isRim ? 0.0F : distance[lattice.index(i, j)];
            if (away > kReach)
                continue;
            float sum = 0.0F;
            float weights = 0.0F;
            for (const Contour& rim : contour) {
                const glm::vec2 to(rim.node - glm::ivec2(i, j));
                const float further = (glm::dot(to, to) - away * away) / (2.0F * kContourBlur * kContourBlur);
                if (further > 12.0F)
                    continue;
                const float weight = std::exp(-further);
                sum += weight * rim.heightMm;
                weights += weight;
            }
            node.contourMm = sum / weights;
            node.share = 1.0F - glm::smoothstep(kFadesFrom, static_cast<float>(kReach), away);
        }
    }
    for (std::size_t k = 0; k < inwards.size(); ++k)
        if (glm::dot(inwards[k], inwards[k]) > 0.0F)
            inwards[k] = glm::normalize(inwards[k]);
    // Weights fall as a Gaussian turned to the rim. Its exponent is a polynomial of di and dj: a product of factors for
    // di², dj² and di dj, the last of which grows evenly along a row, takes a fifth of the exponentials.
    const auto around = [&](int i, int j, glm::vec2 inward, auto&& use) {
        const glm::vec2 across = inward / kBlurAcross;
        const glm::vec2 along = glm::vec2(-inward.y, inward.x) / kBlurAlong;
        const glm::vec2 straight = across * across + along * along;
        const float slanted = across.x * across.y + along.x * along.y;
        std::array<glm::vec2, kSlopeReach + 1> fall;
        for (std::size_t d = 0; d < fall.size(); ++d)
            fall[d] = glm::exp(-0.5F * static_cast<float>(d * d) * straight);
        for (int dj = -kSlopeReach; dj <= kSlopeReach; ++dj) {
            const float onwards = std::exp(-slanted * static_cast<float>(dj));
            float slant = std::exp(slanted * static_cast<float>(dj * kSlopeReach));
            for (int di = -kSlopeReach; di <= kSlopeReach; ++di, slant *= onwards) {
                if (!isSolid(i + di, j + dj) || distance[lattice.index(i + di, j + dj)] > kReach)
                    continue;
                const float near =
                    fall[static_cast<std::size_t>(std::abs(di))].x * fall[static_cast<std::size_t>(std::abs(dj))].y;
                use(lattice.index(i + di, j + dj), glm::vec2(di, dj), near * slant);
            }
        }
    };
    // Beyond a ridge a tooth falls the other way.
    std::vector<float> isFlank(lattice.count(), 0.0F);
    for (int j = 0; j < side; ++j) {
        for (int i = 0; i < side; ++i) {
            const std::size_t k = lattice.index(i, j);
            if (distance[k] > kReach)
                continue;
            Plane ground;
            around(i, j, inwards[k], [&](std::size_t n, glm::vec2 to, float near) { ground.add(to, tops[n], near); });
            if (ground.isKnown())
                isFlank[k] =
                    glm::smoothstep(kFallsFrom, kFallsFull, glm::dot(ground.slopePerCell(), inwards[k]) / cell);
        }
    }
    for (int j = 0; j < side; ++j) {
        for (int i = 0; i < side; ++i) {
            const std::size_t k = lattice.index(i, j);
            Node& node = m_nodes[k];
            if (node.share <= 0.0F)
                continue;
            glm::vec2 inward = inwards[k];
            if (node.isRim) {
                for (int dj = -2; dj <= 2; ++dj)
                    for (int di = -2; di <= 2; ++di)
                        if (isSolid(i + di, j + dj))
                            inward += inwards[lattice.index(i + di, j + dj)];
                inward = glm::normalize(inward);
            }
            Plane upper;
            Plane lower;
            Plane contourAround;
            // The last nodes before the rim lie anywhere on the flank: all of them are to tell the same of it.
            const float own = node.isRim ? 0.0F : glm::smoothstep(kOwnFrom, kOwnFull, distance[k]);
            const float up = node.isRim ? 0.0F : own * (drawnTops[k] - node.contourMm);
            const float down = node.isRim ? 0.0F : node.contourMm - drawnBottoms[k];
            around(i, j, inward, [&](std::size_t n, glm::vec2 to, float near) {
                const float level = m_nodes[n].contourMm;
                const auto add = [&](Plane& plane, float here, float there, float weight) {
                    const float apart = kAlikeMm + std::abs(there - here);
                    plane.add(to, there * std::abs(there), weight / (apart * apart));
                };
                add(upper, up, tops[n] - level, near * isFlank[n]);
                add(lower, down, level - bottoms[n], near);
                contourAround.add(to, level, near);
            });
            if (!upper.isKnown() || !lower.isKnown()) {
                node.share = 0.0F;
                continue;
            }
            node.upper = upper.slopePerCell() / cell;
            node.lower = lower.slopePerCell() / cell;
            node.contour = contourAround.slopePerCell() / cell;
            node.upperShare = node.isRim ? node.share : node.share * isFlank[k];
        }
    }
}

float Flanks::normalAt(std::size_t k, Side side, float heightMm, glm::vec3& normal) const
{
    const Node& node = m_nodes[k];
    if (node.share <= 0.0F)
        return 0.0F;
    glm::vec3 found;
    if (node.isRim) {
        found = glm::vec3(-glm::normalize(node.upper) - glm::normalize(node.lower), 0.0F);
    } else if (side == Side::Upper) {
        const float twice = 2.0F * std::max(heightMm - node.contourMm, 0.0F);
        found = {-node.upper - twice * node.contour, twice};
    } else {
        const float twice = 2.0F * std::max(node.contourMm - heightMm, 0.0F);
        found = {twice * node.contour - node.lower, -twice};
    }
    const float length = glm::length(found);
    if (!(length > 0.0F))
        return 0.0F;
    normal = found / length;
    const float share =
        side == Side::Upper
            ? node.upperShare
            : node.share * (1.0F - glm::smoothstep(kDeepFromMm, kDeepFullMm, node.contourMm - heightMm));
    return share * (1.0F - glm::smoothstep(kSteepFull, kSteepNone, std::abs(normal.z)));
}

}  // namespace ui::render
