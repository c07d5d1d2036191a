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

constexpr int kReach = 14;           ///< width of a flank from the rim inwards, nodes
constexpr float kFadesFrom = 9.0F;   ///< distance from the rim at which a flank begins to fade, nodes
constexpr float kSteepFull = 0.6F;   ///< z of a normal below which a flank is drawn fully rounded
constexpr float kSteepNone = 0.8F;   ///< z of a normal above which it is not rounded
constexpr float kDeepFromMm = 2.0F;  ///< below the height of contour: the crown becomes the root, which is not rounded
constexpr float kDeepFullMm = 3.5F;
constexpr int kContourReach = 7;  ///< range of averaging along the rim, nodes
constexpr float kContourBlur = 4.0F;
constexpr int kSlopeReach = 7;
constexpr float kBlurAcross = 2.0F;  ///< perpendicular to the rim, nodes
constexpr float kBlurAlong = 3.5F;
constexpr float kFallsFrom = 0.3F;  ///< slope towards the rim, mm per mm: a flatter one is part of a ridge
constexpr float kFallsFull = 0.9F;
constexpr float kOwnFrom = 1.5F;  ///< distance from the rim, nodes, from which the slope of a node's own height counts
constexpr float kOwnFull = 4.0F;
constexpr float kAlikeMm = 0.25F;  ///< difference in height at which the weight of a neighbour falls to a quarter

/// A plane fitted by weighted least squares to values around a node; positions in cells.
struct Plane
{
    double ones = 0.0;  ///< sums of the weights, and of the weights times positions
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

/// Finds the flanks of a tooth.
class FlankFinder
{
public:
    FlankFinder(const core::terrain::Grid& lattice, const std::vector<float>& tops, const std::vector<float>& bottoms,
                std::vector<FlankNode>& nodes)
        : m_lattice(lattice), m_tops(tops), m_bottoms(bottoms), m_nodes(nodes),
          m_cell(static_cast<float>(lattice.cellMm)), m_distance(lattice.count(), 1.0e9F),
          m_inwards(lattice.count(), glm::vec2(0.0F)), m_isFlank(lattice.count(), 0.0F)
    {}

    /// Finds the height of contour, first on the rim and then inwards from there.
    void findContour()
    {
        for (int j = 0; j < m_lattice.side; ++j)
            for (int i = 0; i < m_lattice.side; ++i)
                if (isRim(i, j))
                    addContour(i, j);
        for (int j = 0; j < m_lattice.side; ++j)
            for (int i = 0; i < m_lattice.side; ++i)
                spreadContour(i, j);
        for (glm::vec2& inward : m_inwards)
            if (glm::dot(inward, inward) > 0.0F)
                inward = glm::normalize(inward);
    }

    /// Finds where the upper side is a flank. Beyond a ridge the surface slopes the other way.
    void findFlanks()
    {
        for (int j = 0; j < m_lattice.side; ++j) {
            for (int i = 0; i < m_lattice.side; ++i) {
                const std::size_t k = m_lattice.index(i, j);
                if (m_distance[k] > kReach)
                    continue;
                Plane ground;
                around(i, j, m_inwards[k],
                       [&](std::size_t n, glm::vec2 to, float near) { ground.add(to, m_tops[n], near); });
                if (ground.isKnown())
                    m_isFlank[k] =
                        glm::smoothstep(kFallsFrom, kFallsFull, glm::dot(ground.slopePerCell(), m_inwards[k]) / m_cell);
            }
        }
    }

    /// Finds the slopes of a node near the rim; its share is 0 where the nodes around do not determine them.
    void findSlopes(int i, int j, const std::vector<float>& drawnTops, const std::vector<float>& drawnBottoms)
    {
        const std::size_t k = m_lattice.index(i, j);
        FlankNode& node = m_nodes[k];
        if (node.share <= 0.0F)
            return;
        const glm::vec2 inward = node.isRim ? inwardsFromRim(i, j) : m_inwards[k];
        Plane upper;
        Plane lower;
        Plane contourAround;
        // The last nodes before the rim lie anywhere on the flank, so their own heights do not count.
        const float own = node.isRim ? 0.0F : glm::smoothstep(kOwnFrom, kOwnFull, m_distance[k]);
        const float up = node.isRim ? 0.0F : own * (drawnTops[k] - node.contourMm);
        const float down = node.isRim ? 0.0F : node.contourMm - drawnBottoms[k];
        around(i, j, inward, [&](std::size_t n, glm::vec2 to, float near) {
            const float level = m_nodes[n].contourMm;
            const auto add = [&](Plane& plane, float here, float there, float weight) {
                const float apart = kAlikeMm + std::abs(there - here);
                plane.add(to, there * std::abs(there), weight / (apart * apart));
            };
            add(upper, up, m_tops[n] - level, near * m_isFlank[n]);
            add(lower, down, level - m_bottoms[n], near);
            contourAround.add(to, level, near);
        });
        if (!upper.isKnown() || !lower.isKnown()) {
            node.share = 0.0F;
            return;
        }
        node.upper = upper.slopePerCell() / m_cell;
        node.lower = lower.slopePerCell() / m_cell;
        node.contour = contourAround.slopePerCell() / m_cell;
        node.upperShare = node.isRim ? node.share : node.share * m_isFlank[k];
    }

private:
    [[nodiscard]] bool isSolid(int i, int j) const
    {
        return m_lattice.contains(i, j) && m_tops[m_lattice.index(i, j)] > m_bottoms[m_lattice.index(i, j)];
    }

    [[nodiscard]] bool isRim(int i, int j) const
    {
        if (isSolid(i, j))
            return false;
        for (int dj = -1; dj <= 1; ++dj)
            for (int di = -1; di <= 1; ++di)
                if (isSolid(i + di, j + dj))
                    return true;
        return false;
    }

    /// Finds the height at which top and bottom would meet on the rim. The middles of columns approach that height
    /// linearly as the columns get thinner.
    void addContour(int i, int j)
    {
        m_nodes[m_lattice.index(i, j)].isRim = true;
        double sum = 0.0;
        double thick = 0.0;
        double thick2 = 0.0;
        double middle = 0.0;
        double both = 0.0;
        for (int dj = -kReach; dj <= kReach; ++dj) {
            for (int di = -kReach; di <= kReach; ++di) {
                if (!isSolid(i + di, j + dj))
                    continue;
                const std::size_t n = m_lattice.index(i + di, j + dj);
                const auto far2 = static_cast<float>(di * di + dj * dj);
                m_distance[n] = std::min(m_distance[n], std::sqrt(far2));
                m_inwards[n] += glm::vec2(di, dj) / (far2 * far2);
                if (std::max(std::abs(di), std::abs(dj)) > kContourReach)
                    continue;
                const auto t = static_cast<double>(m_tops[n] - m_bottoms[n]);
                const double m = 0.5 * static_cast<double>(m_tops[n] + m_bottoms[n]);
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
        m_contour.push_back({{i, j}, static_cast<float>(at)});
    }

    /// Sets the contour height of a node near the rim to the mean contour height of the rim around it.
    void spreadContour(int i, int j)
    {
        FlankNode& node = m_nodes[m_lattice.index(i, j)];
        const float away = node.isRim ? 0.0F : m_distance[m_lattice.index(i, j)];
        if (away > kReach)
            return;
        float sum = 0.0F;
        float weights = 0.0F;
        for (const Contour& rim : m_contour) {
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

    /// Calls `use` with each solid node around, its position and its weight. Weights fall off as a Gaussian that is
    /// rotated to the rim. The exponent is a polynomial of di and dj. It is computed as a product of factors for di²,
    /// dj² and di dj, which takes a fifth of the calls to exp().
    template <class Use>
    void around(int i, int j, glm::vec2 inward, const Use& use) const
    {
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
                if (!isSolid(i + di, j + dj) || m_distance[m_lattice.index(i + di, j + dj)] > kReach)
                    continue;
                const float near =
                    fall[static_cast<std::size_t>(std::abs(di))].x * fall[static_cast<std::size_t>(std::abs(dj))].y;
                use(m_lattice.index(i + di, j + dj), glm::vec2(di, dj), near * slant);
            }
        }
    }

    [[nodiscard]] glm::vec2 inwardsFromRim(int i, int j) const
    {
        glm::vec2 inward = m_inwards[m_lattice.index(i, j)];
        for (int dj = -2; dj <= 2; ++dj)
            for (int di = -2; di <= 2; ++di)
                if (isSolid(i + di, j + dj))
                    inward += m_inwards[m_lattice.index(i + di, j + dj)];
        return glm::normalize(inward);
    }

    const core::terrain::Grid& m_lattice;
    const std::vector<float>& m_tops;
    const std::vector<float>& m_bottoms;
    std::vector<FlankNode>& m_nodes;
    float m_cell;
    std::vector<Contour> m_contour;
    std::vector<float> m_distance;     ///< distance to the rim, nodes
    std::vector<glm::vec2> m_inwards;  ///< unit vectors that point away from the rim
    std::vector<float> m_isFlank;      ///< 0 .. 1
};

}  // namespace

Flanks::Flanks(const core::terrain::Grid& lattice, const std::vector<float>& tops, const std::vector<float>& bottoms,
               const std::vector<float>& drawnTops, const std::vector<float>& drawnBottoms)
    : m_nodes(lattice.count())
{
    FlankFinder finder(lattice, tops, bottoms, m_nodes);
    finder.findContour();
    finder.findFlanks();
    for (int j = 0; j < lattice.side; ++j)
        for (int i = 0; i < lattice.side; ++i)
            finder.findSlopes(i, j, drawnTops, drawnBottoms);
}

float Flanks::normalAt(std::size_t k, Side side, float heightMm, glm::vec3& normal) const
{
    const FlankNode& node = m_nodes[k];
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
