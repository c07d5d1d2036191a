// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace lessons {

/// How a measured value becomes points lost.
enum class PointRule {
    PerUnit,  ///< min(maxPoints, round(pointsPerUnit * max(0, measured - free))), halves away from zero
    Once      ///< maxPoints as soon as measured > free
};

/// One line of a score: what was measured, how it was worked into points, and what was lost. The ui builds the sentence
/// ("4.2 % left, free 1.0 %, 2 points per % -> -6") from the id and these numbers.
struct Criterion
{
    std::string id;         ///< "caries_left", "sound_tissue", "pulp_exposure", "perforation"; the ui translates it
    double measured = 0.0;  ///< in `unit`
    std::string unit;       ///< "%", "mm3", "mm2"
    double free = 0.0;      ///< up to here nothing is lost, in `unit`
    PointRule rule = PointRule::PerUnit;
    double pointsPerUnit = 0.0;  ///< of PerUnit; 0 for Once
    int maxPoints = 0;           ///< the most this criterion can take away
    bool critical = false;       ///< losing points here fails the attempt, whatever the total
    int pointsLost = 0;          ///< by the rule, exactly
    bool operator==(const Criterion&) const = default;
};

/// A grade that explains itself: total = max(0, 100 - sum of points lost), exactly; all integers.
struct ScoreSheet
{
    std::string rubricId;
    int rubricVersion = 0;
    std::vector<Criterion> criteria;
    int total = 0;     ///< 0 .. 100
    int passMark = 0;  ///< 0 .. 100
    bool operator==(const ScoreSheet&) const = default;

    [[nodiscard]] int pointsLost() const
    {
        int sum = 0;
        for (const Criterion& criterion : criteria)
            sum += criterion.pointsLost;
        return sum;
    }
    /// Points lost that the total does not show because it ends at 0.
    [[nodiscard]] int pointsBelowZero() const { return pointsLost() - (100 - total); }
    [[nodiscard]] bool failedCritically() const
    {
        for (const Criterion& criterion : criteria)
            if (criterion.critical && criterion.pointsLost > 0)
                return true;
        return false;
    }
    [[nodiscard]] bool passed() const { return total >= passMark && !failedCritically(); }
};

/// The points that a criterion's own numbers take away, its pointsLost ignored. A measured value that is not a number
/// loses everything: nothing unmeasured earns points.
[[nodiscard]] int pointsLostBy(const Criterion& criterion);

/// Fills pointsLost of every criterion and the total.
void addUp(ScoreSheet& sheet);

}  // namespace lessons
