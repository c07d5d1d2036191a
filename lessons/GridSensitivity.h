// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "lessons/Assignment.h"

namespace lessons {

/// The scores of the same attempt on a coarser and a finer grid, which show how much the score depends on the grid.
/// docs/scoring.md, "How exact a score is", explains what this covers.
struct GridSensitivity
{
    struct Result
    {
        int totalTenths = 0;
        bool passed = false;
        bool operator==(const Result&) const = default;
    };
    Result own;
    Result half;                  ///< with about half as many nodes per side
    std::optional<Result> twice;  ///< empty if that would exceed the largest grid
    bool operator==(const GridSensitivity&) const = default;

    /// Returns whether passing depends on the grid.
    [[nodiscard]] bool isUncertain() const
    {
        return half.passed != own.passed || (twice && twice->passed != own.passed);
    }
};

/// Grades a tooth of the assignment's anatomy three times: unchanged, and with tooth, anatomy and ideal resampled
/// (core/terrain/Resample). Measures of the process stay the same. 0.1 to 0.2 s at 150 x 150. Any thread that owns the
/// tooth.
[[nodiscard]] core::Result<GridSensitivity> gridNoise(const Assignment& assignment, const core::terrain::Tooth& tooth,
                                                      const std::optional<Conduct>& conduct = {});

}  // namespace lessons
