// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/base/Result.h"
#include "core/grading/MeasureTable.h"
#include "lessons/LocalText.h"
#include "lessons/ScoreSheet.h"

namespace lessons {

/// An additional tolerance of a criterion, proportional to another measure: a large lesion needs a large cavity.
struct Allowance
{
    std::string measure;
    double each = 0.0;  ///< units of the criterion for each unit of that measure
    bool operator==(const Allowance&) const = default;
};

/// How one measure is graded. All numbers come from the teacher's rubric; none is built into the program.
struct CriterionRule
{
    std::string id;       ///< unique in its rubric
    LocalText title;      ///< empty: the name of the measure
    std::string measure;  ///< of core::grading's table: "caries_left_percent"
    std::string unit;     ///< of that measure
    Side side = Side::Over;
    double target = 0.0;     ///< the ideal value
    double tolerance = 0.0;  ///< deviation that costs nothing
    std::optional<Allowance> allowance;
    std::optional<Once> once;
    double span = 0.0;      ///< error beyond the tolerance that costs the whole weight; 0: any error costs all of it
    int weightTenths = 0;   ///< tenths of a point that can be lost here; 0 for a critical one
    bool critical = false;  ///< any error beyond the tolerance takes all points above capTenths
    int capTenths = 0;      ///< most points after a critical error; 0: no points, and the attempt fails
    bool operator==(const CriterionRule&) const = default;
};

/// A rubric: criteria whose weights are 100 points in total, and one of the two rules by which schools add them up.
struct Rubric
{
    std::string id;
    int version = 1;
    LocalText title;
    Verdict verdict = Verdict::SumOfErrors;
    int passMarkTenths = 750;
    std::vector<CriterionRule> criteria;
    std::string hash;  ///< 64 hex digits over the rubric's content (SHA-256); set by the reader
    bool operator==(const Rubric&) const = default;
};

inline constexpr double kLargestRubricNumber = 1.0e6;
inline constexpr std::size_t kMostCriteria = 40;

/// Measured values by the ids of core::grading's table. A missing value was not measured.
using Values = std::map<std::string, double, std::less<>>;

/// Returns every measure that has a value.
[[nodiscard]] Values valuesOf(const core::grading::Measured& measured);

/// Checks a rubric: ids unique, numbers finite and in range, weights of 100 points in total, critical criteria without
/// weight. The error names criterion and key.
[[nodiscard]] core::Status check(const Rubric& rubric);

/// Returns the tenths of a point that a criterion without critical errors costs by itself: its share of its weight, or
/// of 100 points if only the worst error counts.
[[nodiscard]] int lostAlone(const Criterion& line, Verdict verdict);

/// Returns the same as if the criterion's condition were fulfilled.
[[nodiscard]] int lostByError(const Criterion& line, Verdict verdict);

/// Grades an attempt as described in docs/scoring.md. The rubric must pass check(). Any thread.
[[nodiscard]] ScoreSheet grade(const Rubric& rubric, const Values& values);

}  // namespace lessons
