// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/guidance/Fixture.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/bur/Bur.h"
#include "core/teeth/Lattice.h"

namespace core::guidance {
namespace {

constexpr double kBeginsOverMm = 0.5;  ///< over the top of the crown; at full strength as far below it
constexpr double kFadesMm = 1.0;
/// The axis of a bur may come nearer to the outline than its radius by this much: a shape may be as wide as the bur,
/// and a grid has an edge only to half a cell.
constexpr double kSlackMm = 0.1;

/// Smoothstep from 0 to 1, and its slope.
struct Ease
{
    double value;
    double slope;
};
Ease ease(double t)
{
    const double u = std::clamp(t, 0.0, 1.0);
    return {u * u * (3.0 - 2.0 * u), 6.0 * u * (1.0 - u)};
}

}  // namespace

Fixture::Fixture(const terrain::ToothAnatomy& anatomy, const std::vector<float>& ideal)
    : m_grid(anatomy.grid), m_topMm(static_cast<double>(*std::max_element(anatomy.top.begin(), anatomy.top.end())))
{
    std::vector<std::uint8_t> marked(ideal.size());
    for (std::size_t k = 0; k < ideal.size(); ++k)
        marked[k] = ideal[k] < anatomy.top[k] ? 1 : 0;
    const std::vector<float> inside = teeth::distanceInside(m_grid, marked);
    std::vector<double> radiiMm;
    for (const bur::Bur& bur : bur::burs()) {
        const auto known = std::find(radiiMm.begin(), radiiMm.end(), bur.headRadiusMm);
        m_mapOfBur.push_back(static_cast<std::size_t>(known - radiiMm.begin()));
        if (known != radiiMm.end())
            continue;
        radiiMm.push_back(bur.headRadiusMm);
        const double needed = bur.headRadiusMm - kSlackMm - 0.5 * m_grid.cellMm;
        bool fits = false;
        for (std::size_t k = 0; k < inside.size(); ++k) {
            const bool mayBe = inside[k] > 0.0F && static_cast<double>(inside[k]) >= needed;
            marked[k] = mayBe ? 0 : 1;
            fits = fits || mayBe;
        }
        // A bur that does not fit into the shape gets no fixture.
        m_besideMm.push_back(fits ? teeth::distanceInside(m_grid, marked, teeth::Beyond::Marked)
                                  : std::vector<float>(inside.size(), 0.0F));
    }
}

glm::dvec3 Fixture::forceN(const glm::dvec3& tip, std::size_t bur) const noexcept
{
    const glm::dvec2 at = m_grid.latticeOf({tip.x, tip.y});
    const double i0 = std::floor(at.x);
    const double j0 = std::floor(at.y);
    // The slope at a node needs its neighbours. The condition is also false for NaN.
    if (!(i0 >= 1.0 && j0 >= 1.0 && i0 + 3.0 <= m_grid.side && j0 + 3.0 <= m_grid.side) || bur >= m_mapOfBur.size())
        return glm::dvec3(0.0);
    const int i = static_cast<int>(i0);
    const int j = static_cast<int>(j0);
    const std::vector<float>& beside = m_besideMm[m_mapOfBur[bur]];
    const auto value = [&](int x, int y) { return static_cast<double>(beside[m_grid.index(x, y)]); };
    double mm = 0.0;
    glm::dvec2 slope(0.0);
    for (int y = 0; y < 2; ++y) {
        for (int x = 0; x < 2; ++x) {
            const double share = (x == 0 ? 1.0 - (at.x - i0) : at.x - i0) * (y == 0 ? 1.0 - (at.y - j0) : at.y - j0);
            mm += share * value(i + x, j + y);
            slope += share * glm::dvec2(value(i + x + 1, j + y) - value(i + x - 1, j + y),
                                        value(i + x, j + y + 1) - value(i + x, j + y - 1));
        }
    }
    const double length = std::sqrt(glm::dot(slope, slope));
    if (!(mm > 0.0) || !(length > 0.0))
        return glm::dvec3(0.0);
    const Ease out = ease((mm - kHoldsMm) / kFadesMm);
    const Ease down = ease((m_topMm + kBeginsOverMm - tip.z) / (2.0 * kBeginsOverMm));
    const double newtons = std::min(kNPerMm * mm, kMostN) * (1.0 - out.value) * down.value;
    return glm::dvec3(-newtons / length * slope, 0.0);
}

}  // namespace core::guidance
