// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/preparation/OcclusalReduction.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <memory>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>

#include "core/teeth/OcclusalField.h"
#include "core/teeth/PosteriorForm.h"
#include "core/teeth/ToothGenerator.h"

namespace core::preparation {
namespace {

using grading::Part;
using teeth::Cusp;

constexpr double kValleyRadiusMm = 0.8;  ///< tightest valley, so that a bur of 1.0 to 1.2 mm almost touches its bottom
constexpr double kClosedMm = 1.6;        ///< half the width of the widest valley that is closed
constexpr float kThinnestCutMm = 0.02F;  ///< a shallower floor is no cut

/// Heights over a grid, row by row.
using Heights = std::vector<float>;

/// Raises each height to the highest of x + sign * p, where p is a parabola of the valley's curvature along the row (or
/// column) within kClosedMm. With `sign` -1, lowers it to the lowest of x + p.
Heights swept(const terrain::Grid& grid, const Heights& heights, bool alongX, bool raises)
{
    const int reach = static_cast<int>(kClosedMm / grid.cellMm);
    std::vector<float> parabola;
    for (int n = 0; n <= reach; ++n)
        parabola.push_back(static_cast<float>(n * n * grid.cellMm * grid.cellMm / (2.0 * kValleyRadiusMm)));
    Heights result(heights.size());
    for (int j = 0; j < grid.side; ++j)
        for (int i = 0; i < grid.side; ++i) {
            const int here = alongX ? i : j;
            float best = heights[grid.index(i, j)];
            for (int n = -std::min(reach, here); n <= std::min(reach, grid.side - 1 - here); ++n) {
                const float there = heights[alongX ? grid.index(i + n, j) : grid.index(i, j + n)];
                const float off = parabola[static_cast<std::size_t>(std::abs(n))];
                best = raises ? std::max(best, there - off) : std::min(best, there + off);
            }
            result[grid.index(i, j)] = best;
        }
    return result;
}

/// Fills all valleys that are tighter than kValleyRadiusMm: a closing by a paraboloid.
void fillValleys(const terrain::Grid& grid, Heights& heights)
{
    for (const bool raises : {true, false})
        for (const bool alongX : {true, false})
            heights = swept(grid, heights, alongX, raises);
}

/// Raises heights until none falls to a neighbour by more than 45 degrees.
void limitSlope(const terrain::Grid& grid, Heights& heights)
{
    const auto straight = static_cast<float>(grid.cellMm);
    const auto askew = static_cast<float>(grid.cellMm * std::numbers::sqrt2);
    const auto raise = [&](int i, int j, int step) {
        float& here = heights[grid.index(i, j)];
        const auto from = [&](int ni, int nj, float fall) {
            if (grid.contains(ni, nj))
                here = std::max(here, heights[grid.index(ni, nj)] - fall);
        };
        from(i - step, j, straight);
        from(i - step, j - step, askew);
        from(i, j - step, straight);
        from(i + step, j - step, askew);
    };
    for (int j = 0; j < grid.side; ++j)
        for (int i = 0; i < grid.side; ++i)
            raise(i, j, 1);
    for (int j = grid.side - 1; j >= 0; --j)
        for (int i = grid.side - 1; i >= 0; --i)
            raise(i, j, -1);
}

/// Computes the position of a place between the middle of the tooth and the tips of its functional cusps, 0 to 1. It is
/// 1 at and beyond the tip that is nearest to the middle.
class FunctionalShare
{
public:
    explicit FunctionalShare(const teeth::PosteriorForm& form, int fdi) : m_form(form)
    {
        const std::vector<double> buccal = placesOf({Cusp::B, Cusp::MB, Cusp::DB, Cusp::D});
        const std::vector<double> lingual = placesOf({Cusp::L, Cusp::ML, Cusp::DL});
        m_middleY = 0.5 * (mean(buccal) + mean(lingual));
        const bool isUpper = fdi / 10 <= 2;
        const std::vector<double>& tips = isUpper ? lingual : buccal;
        m_tipY = *std::min_element(tips.begin(), tips.end(), [this](double a, double b) {
            return std::abs(a - m_middleY) < std::abs(b - m_middleY);
        });
    }

    [[nodiscard]] double at(glm::dvec2 toothMm) const
    {
        const double share = (m_form.toDesign(toothMm).y - m_middleY) / (m_tipY - m_middleY);
        const double t = std::clamp(share, 0.0, 1.0);
        return t * t * (3.0 - 2.0 * t);
    }

private:
    /// Returns the positions of the tips of these cusps across the tooth. Each premolar and molar has such a cusp on
    /// both sides.
    [[nodiscard]] std::vector<double> placesOf(std::initializer_list<Cusp> cusps) const
    {
        std::vector<double> places;
        for (const teeth::Lobe& lobe : m_form.crown.design().lobes)
            if (std::find(cusps.begin(), cusps.end(), lobe.cusp) != cusps.end())
                places.push_back(lobe.y);
        return places;
    }

    static double mean(const std::vector<double>& values)
    {
        return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
    }

    const teeth::PosteriorForm& m_form;
    double m_tipY = 1.0;
    double m_middleY = 0.0;
};

}  // namespace

Result<grading::Preparation> occlusalReduction(const ToothDesign& design, const terrain::ToothAnatomy& anatomy)
{
    const auto form = teeth::posteriorForm(anatomy.fdi, anatomy.seed);
    if (!form)
        return tl::unexpected<Error>(form.error());
    const FunctionalShare functional(*form, anatomy.fdi);
    const terrain::Grid& grid = anatomy.grid;
    Heights lowered = anatomy.top;
    for (std::size_t k = 0; k < lowered.size(); ++k)
        if (anatomy.top[k] > anatomy.bottom[k])
            lowered[k] -= static_cast<float>(design.reductionMm + functional.at(grid.nodeMm(k)) *
                                                                      (design.functionalMm - design.reductionMm));
    limitSlope(grid, lowered);
    fillValleys(grid, lowered);
    Heights top = anatomy.top;
    std::vector<Part> parts(grid.count(), Part::Keep);
    for (std::size_t k = 0; k < top.size(); ++k)
        if (top[k] > anatomy.bottom[k] && lowered[k] < top[k] - kThinnestCutMm) {
            top[k] = lowered[k] > anatomy.bottom[k] ? lowered[k] : terrain::kEmptyTop;
            parts[k] = Part::Floor;
        }
    return grading::Preparation{std::make_shared<const std::vector<float>>(std::move(top)), std::move(parts), {}};
}

}  // namespace core::preparation
