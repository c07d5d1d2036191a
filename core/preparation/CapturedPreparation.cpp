// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/preparation/CapturedPreparation.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/grading/Outline.h"

namespace core::preparation {
namespace {

using grading::Part;

constexpr float kCutMm = 0.02F;    ///< a shallower cut is only a brush
constexpr double kAcrossMm = 0.3;  ///< distance over which slopes are measured
constexpr float kSteepest = 1.0F;  ///< of a floor, mm per mm

bool wasCut(const terrain::Tooth& attempt, std::size_t k)
{
    return !attempt.isSolid(k) || attempt.top[k] < attempt.anatomy->top[k] - kCutMm;
}

/// The mean of several outlines, for columns that are cut in half of the attempts.
class MeanOutline
{
public:
    explicit MeanOutline(std::span<const terrain::Tooth* const> attempts) : m_attempts(attempts) {}

    [[nodiscard]] bool encloses(int i, int j)
    {
        if (m_outlines.empty())
            for (const terrain::Tooth* attempt : m_attempts)
                m_outlines.emplace_back(*attempt->anatomy, attempt->top);
        const terrain::Grid& grid = m_attempts.front()->anatomy->grid;
        double insideMm = 0.0;
        for (std::size_t n = 0; n < m_attempts.size(); ++n)
            if (!m_outlines[n].segments().empty())
                insideMm += (wasCut(*m_attempts[n], grid.index(i, j)) ? 1.0 : -1.0) *
                            m_outlines[n].distanceMm(grid.nodeMm(i, j));
        return insideMm > 0.0;
    }

private:
    std::span<const terrain::Tooth* const> m_attempts;
    std::vector<grading::Outline> m_outlines;  ///< made at the first use
};

/// Marks columns as floor or wall, by the slope around them.
void tellFloorFromWall(const terrain::Grid& grid, const std::vector<float>& top, std::vector<Part>& parts)
{
    constexpr float kUnknown = 1.0e9F;
    const int reach = std::max(1, static_cast<int>(std::lround(kAcrossMm / grid.cellMm)));
    const auto run = static_cast<float>(reach * grid.cellMm);
    const std::vector<Part> cut = parts;
    const auto isCut = [&](int i, int j) { return grid.contains(i, j) && cut[grid.index(i, j)] != Part::Keep; };
    for (int j = 0; j < grid.side; ++j)
        for (int i = 0; i < grid.side; ++i) {
            const std::size_t k = grid.index(i, j);
            if (cut[k] == Part::Keep)
                continue;
            bool atRim = false;
            float slope = 0.0F;
            for (const auto& [di, dj] : {std::pair(1, 0), std::pair(0, 1)}) {
                // Of the two slopes along an axis, the gentler one counts, so that the edge of a floor beside a wall is
                // still floor.
                float gentlest = kUnknown;
                for (const int sign : {-1, 1}) {
                    atRim = atRim || !isCut(i + sign * di, j + sign * dj);
                    const int ni = i + sign * di * reach;
                    const int nj = j + sign * dj * reach;
                    if (isCut(ni, nj))
                        gentlest = std::min(gentlest, std::abs(top[grid.index(ni, nj)] - top[k]) / run);
                }
                slope = std::max(slope, gentlest < kUnknown ? gentlest : 0.0F);
            }
            parts[k] = atRim || slope > kSteepest ? Part::Wall : Part::Floor;
        }
}

}  // namespace

Result<grading::Preparation> averagePreparation(std::span<const terrain::Tooth* const> attempts)
{
    if (attempts.empty())
        return unexpected(ErrorCode::BadStructure, "an ideal is taken from attempts, and there is none; choose at "
                                                   "least one");
    const terrain::Tooth& first = *attempts.front();
    for (const terrain::Tooth* attempt : attempts)
        if (!terrain::isSameTooth(*first.anatomy, *attempt->anatomy))
            return unexpected(ErrorCode::BadStructure, "the attempts are of different teeth ('" + first.anatomy->name +
                                                           "' and '" + attempt->anatomy->name +
                                                           "', grid, seed or decay); choose those of one");
    const terrain::ToothAnatomy& anatomy = *first.anatomy;
    std::vector<float> top = anatomy.top;
    std::vector<Part> parts(anatomy.grid.count(), Part::Keep);
    bool any = false;
    MeanOutline outline(attempts);
    for (std::size_t k = 0; k < top.size(); ++k) {
        if (!(anatomy.top[k] > anatomy.bottom[k]))
            continue;
        std::size_t cut = 0;
        std::size_t through = 0;
        double sum = 0.0;
        for (const terrain::Tooth* attempt : attempts) {
            if (!attempt->isSolid(k)) {
                ++through;
            } else if (wasCut(*attempt, k)) {
                ++cut;
                sum += static_cast<double>(attempt->top[k]);
            }
        }
        const std::size_t twice = 2 * (cut + through);
        const auto side = static_cast<std::size_t>(anatomy.grid.side);
        if (twice < attempts.size() ||
            (twice == attempts.size() && !outline.encloses(static_cast<int>(k % side), static_cast<int>(k / side))))
            continue;
        any = true;
        parts[k] = Part::Floor;
        top[k] = through >= cut ? terrain::kEmptyTop : static_cast<float>(sum / static_cast<double>(cut));
    }
    if (!any)
        return unexpected(ErrorCode::BadStructure,
                          "there is no place that most of the attempts cut; choose attempts at one preparation");
    tellFloorFromWall(anatomy.grid, top, parts);
    return grading::Preparation{std::make_shared<const std::vector<float>>(std::move(top)), std::move(parts), {}};
}

}  // namespace core::preparation
