// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "lessons/LocalText.h"

namespace lessons {

/// On which side of its target a measure can be wrong.
enum class Side { Over, Under, Both };

/// How the points of a rubric add up. Schools know two ways (docs/facts/teaching.md, section 4).
enum class Verdict {
    SumOfErrors,  ///< every criterion takes its share of its weight
    WorstError    ///< the worst criterion alone decides, with its share of 100 points
};

/// What has to be done before a criterion can earn anything: who has left the tooth alone has spared all of it.
struct Once
{
    std::string measure;
    std::string unit;      ///< of that measure
    double reaches = 0.0;  ///< in that unit
    bool operator==(const Once&) const = default;
};

/// One line of a score: what was measured, how it was worked into points, and what was lost. Numbers are kept as they
/// were judged, so that the sentence can be worked again: "4.2 %, free 1.0 %, 60 points over 30 % -> -6.4".
struct Criterion
{
    std::string id;
    LocalText title;      ///< empty: the name of the measure
    std::string measure;  ///< id of the measure; empty: only the points are known
    std::string unit;     ///< "percent", "mm3", "mm", "deg", ...
    std::optional<double> measured;
    Side side = Side::Over;
    double target = 0.0;
    double tolerance = 0.0;  ///< with what the allowance added
    double span = 0.0;
    int weightTenths = 0;
    bool critical = false;
    int capTenths = 0;  ///< what a critical error leaves at most
    std::optional<Once> once;
    std::optional<double> onceMeasured;  ///< of the measure that `once` names
    bool isTooEarly = false;             ///< what `once` asks for has not been done
    double error = 0.0;                  ///< beyond the tolerance, in `unit`; 0 where nothing was measured
    double share =
        0.0;  ///< of the weight that is lost, 0 .. 1; 1 where nothing was measured or it is too early (critical: 0)
    int lostTenths = 0;  ///< tenths of a point, exactly
    bool operator==(const Criterion&) const = default;
};

/// A grade that explains itself: total = 100 points - the sum of what each criterion lost, exactly; all in tenths of a
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

    /// The points that the most serious error leaves at most; nothing without such an error.
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
