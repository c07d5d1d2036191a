// SPDX-License-Identifier: GPL-3.0-or-later
#include "lessons/GridSensitivity.h"

#include <utility>

#include "core/terrain/Resample.h"

namespace lessons {
namespace {

using core::terrain::Sampling;

GridSensitivity::Result resultOf(const ScoreSheet& sheet)
{
    return {sheet.totalTenths, sheet.passed()};
}

core::Result<GridSensitivity::Result> markedAt(Sampling sampling, const Assignment& assignment,
                                               const core::terrain::Tooth& tooth, const std::optional<Conduct>& conduct)
{
    const core::terrain::ToothAnatomy& anatomy = *assignment.anatomy;
    Assignment other = assignment;
    other.anatomy = core::terrain::resampled(anatomy, sampling);
    if (assignment.ideal) {
        other.ideal->top = std::make_shared<const std::vector<float>>(
            core::terrain::resampledTop(anatomy, *assignment.ideal->top, sampling));
        other.ideal->parts = core::terrain::resampledLabels(anatomy.grid, assignment.ideal->parts, sampling);
    }
    const auto marked = mark(other, core::terrain::resampled(tooth, other.anatomy, sampling), conduct);
    if (!marked)
        return tl::unexpected(marked.error());
    return resultOf(marked->sheet);
}

}  // namespace

core::Result<GridSensitivity> gridNoise(const Assignment& assignment, const core::terrain::Tooth& tooth,
                                        const std::optional<Conduct>& conduct)
{
    GridSensitivity noise;
    const auto marked = mark(assignment, tooth, conduct);
    if (!marked)
        return tl::unexpected(marked.error());
    noise.own = resultOf(marked->sheet);
    const auto half = markedAt(Sampling::Half, assignment, tooth, conduct);
    if (!half)
        return tl::unexpected(half.error());
    noise.half = *half;
    if (core::terrain::resampled(tooth.grid(), Sampling::Double).side <= core::terrain::kMaxGridSide) {
        const auto twice = markedAt(Sampling::Double, assignment, tooth, conduct);
        if (!twice)
            return tl::unexpected(twice.error());
        noise.twice = *twice;
    }
    return noise;
}

}  // namespace lessons
