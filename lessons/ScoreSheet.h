// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "lessons/LocalText.h"

namespace lessons {

/// The side of its target on which a measure can be wrong.
enum class Side { Over, Under, Both };

/// How the points of a rubric add up. Schools use two ways (docs/facts/teaching.md, section 4).
enum class Verdict {
    SumOfErrors,  ///< every criterion costs its share of its weight
    WorstError    ///< only the worst criterion counts, with its share of 100 points
};

/// A condition for a criterion to earn points: an untouched tooth has spared all tissue.
struct Once
{
    std::string measure;
    std::string unit;      ///< of that measure
    double reaches = 0.0;  ///< in that unit
    bool operator==(const Once&) const = default;
};

/// One line of a score: the measured value, its conversion into points, and the loss. All numbers are stored, so that
/// the formula can be shown: "4.2 %, free 1.0 %, 60 points over 30 % -> -6.4".
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
    double error = 0.0;                  ///< beyond the tolerance, in `unit`; 0 if it was not measured
    double share = 0.0;  ///< of the weight lost, 0 to 1; 1 if it was not measured or is too early (critical: 0)
    int lostTenths = 0;  ///< tenths of a point, exactly
    bool operator==(const Criterion&) const = default;
};

/// A grade with its reasons: total = 100 points - the sum of what each criterion lost, exactly; all in tenths of a
/// point, as integers.
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

    /// Returns the most points that the most serious error allows; empty without such an error.
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
