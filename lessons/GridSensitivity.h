// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "lessons/Assignment.h"

namespace lessons {

/// What the same work comes to when it is looked at more coarsely and more finely: how far a score hangs on the grid.
/// docs/scoring.md, "How exact a score is", says what that covers.
struct GridSensitivity
{
    struct Result
    {
        int totalTenths = 0;
        bool passed = false;
        bool operator==(const Result&) const = default;
    };
    Result own;
    Result half;                  ///< with about half as many nodes along a side
    std::optional<Result> twice;  ///< nothing where that would be more than the largest grid
    bool operator==(const GridSensitivity&) const = default;

    /// Whether it passes depends on the grid.
    [[nodiscard]] bool isUncertain() const
    {
        return half.passed != own.passed || (twice && twice->passed != own.passed);
    }
};

/// Marks a tooth of the assignment's anatomy three times: as it is, and with tooth, anatomy and ideal resampled
/// (core/terrain/Resample). What is about the way stays as it was. A tenth of a second or two at 150 x 150. Any thread
/// that owns the tooth.
[[nodiscard]] core::Result<GridSensitivity> gridNoise(const Assignment& assignment, const core::terrain::Tooth& tooth,
                                                      const std::optional<Conduct>& conduct = {});

}  // namespace lessons
