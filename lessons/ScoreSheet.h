// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "lessons/LocalText.h"

namespace lessons {

/// The direction in which a measure can deviate from its target.
enum class Side { Over, Under, Both };

/// How the points of a rubric add up. Schools use two ways (docs/facts/teaching.md, section 4).
enum class Verdict {
    SumOfErrors,  ///< every criterion costs its share of its weight
    WorstError    ///< only the worst criterion counts, with its share of 100 points
};

/// A condition that a criterion must meet to earn points. Otherwise an untouched tooth would score for tissue that was
/// spared.
struct Once
{
    std::string measure;
    std::string unit;      ///< of that measure
    double reaches = 0.0;  ///< in that unit
    bool operator==(const Once&) const = default;
};

/// One line of a score sheet: the measured value, its conversion into points, and the loss. All numbers are stored, so
/// that the formula can be shown: "4.2 %, free 1.0 %, 60 points over 30 % -> -6.4".
struct Criterion
{
    std::string id;
    LocalText title;      ///< empty: the name of the measure
    std::string measure;  ///< id of the measure; empty: only the points are known
    std::string unit;     ///< "percent", "mm3", "mm", "deg", ...
    std::optional<double> measured;
    Side side = Side::Over;
    double target = 0.0;
    double tolerance = 0.0;  ///< including the allowance
    double span = 0.0;
    int weightTenths = 0;
    bool critical = false;
    int capTenths = 0;  ///< most points after a critical error
    std::optional<Once> once;
    std::optional<double> onceMeasured;  ///< value of the measure in `once`
    bool isTooEarly = false;             ///< the condition `once` is not fulfilled
    double error = 0.0;                  ///< beyond the tolerance, in `unit`; 0 if the measure has no value
    double share = 0.0;  ///< of the weight lost, 0 to 1; 1 without a value or if isTooEarly (critical: 0)
    int lostTenths = 0;  ///< tenths of a point, exactly
    bool operator==(const Criterion&) const = default;
};

/// A score with its reasons. The total is exactly 100 points minus the losses of all criteria, in integer tenths of a
/// point.
struct ScoreSheet
{
    std::string rubricId;
    int rubricVersion = 0;
    std::string rubricHash;
    LocalText rubricTitle;
    Verdict verdict = Verdict::SumOfErrors;
    int passMarkTenths = 0;
    std::vector<Criterion> criteria;
    int totalTenths = 0;  ///< 0 .. 1000
    bool operator==(const ScoreSheet&) const = default;

    /// Returns the most points that critical errors allow, by the lowest limit; empty without a critical error.
    [[nodiscard]] std::optional<int> limitTenths() const
    {
        std::optional<int> limit;
        for (const Criterion& criterion : criteria)
            if (criterion.critical && criterion.share > 0.0)
                limit = limit ? std::min(*limit, criterion.capTenths) : criterion.capTenths;
        return limit;
    }
    [[nodiscard]] bool failedCritically() const { return limitTenths() == 0; }
    [[nodiscard]] bool passed() const { return totalTenths >= passMarkTenths && !failedCritically(); }
};

inline constexpr int kFullTenths = 1000;

}  // namespace lessons
