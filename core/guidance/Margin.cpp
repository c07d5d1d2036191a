// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/guidance/Margin.h"

#include <algorithm>
#include <cmath>

namespace core::guidance {

std::optional<double> marginMm(const terrain::ToothAnatomy& anatomy, const std::vector<float>& ideal,
                               const bur::Bur& bur, const glm::dvec3& tip)
{
    const terrain::Grid& grid = anatomy.grid;
    const glm::dvec2 at = grid.latticeOf({tip.x, tip.y});
    const double reach = (bur.headRadiusMm + kToldMm) / grid.cellMm;
    const auto last = static_cast<double>(grid.side - 1);
    // The condition is also false for NaN.
    if (!(at.x > -reach && at.y > -reach && at.x < last + reach && at.y < last + reach))
        return std::nullopt;
    const auto from = [](double v) { return std::max(0, static_cast<int>(std::ceil(v))); };
    const auto to = [&](double v) { return std::min(grid.side - 1, static_cast<int>(std::floor(v))); };
    double margin = kToldMm;
    for (int j = from(at.y - reach); j <= to(at.y + reach); ++j) {
        for (int i = from(at.x - reach); i <= to(at.x + reach); ++i) {
            const std::size_t k = grid.index(i, j);
            if (!(anatomy.top[k] > anatomy.bottom[k]))
                continue;
            const double x = (i - at.x) * grid.cellMm;
            const double y = (j - at.y) * grid.cellMm;
            const double radius = std::sqrt(x * x + y * y);
            const double under = std::min(radius, bur.headRadiusMm);
            const double above = tip.z + bur.undersideMm(under) - static_cast<double>(ideal[k]);
            const double beside = radius - under;
            if (beside == 0.0)  // the point is below the bur, so the nearest way out is up or sideways
                margin = std::min(margin, above > 0.0 ? above : std::max(above, radius - bur.headRadiusMm));
            else if (above > 0.0)
                margin = std::min(margin, std::sqrt(beside * beside + above * above));
            else
                margin = std::min(margin, beside);
        }
    }
    if (margin >= kToldMm)
        return std::nullopt;
    return margin;
}

Progress progressOf(const terrain::ToothAnatomy& anatomy, const std::vector<float>& ideal,
                    const std::vector<float>& top)
{
    Progress sum;
    for (std::size_t k = 0; k < top.size(); ++k) {
        if (!(anatomy.top[k] > anatomy.bottom[k]))
            continue;
        const auto areaMm2 = static_cast<double>(anatomy.areaMm2[k]);
        const auto whole = static_cast<double>(anatomy.top[k]);
        const auto bottom = static_cast<double>(anatomy.bottom[k]);
        const double wanted = std::clamp(static_cast<double>(ideal[k]), bottom, whole);
        const double now = std::clamp(static_cast<double>(top[k]), bottom, whole);
        sum.askedMm3 += areaMm2 * (whole - wanted);
        sum.leftMm3 += areaMm2 * std::max(0.0, now - wanted);
        sum.beyondMm3 += areaMm2 * std::max(0.0, wanted - now);
    }
    return sum;
}

}  // namespace core::guidance
