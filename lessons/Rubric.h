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

/// What a criterion allows beyond its tolerance, in proportion to another measure: a large lesion asks for a large
/// cavity.
struct Allowance
{
    std::string measure;
    double each = 0.0;  ///< units of the criterion for each unit of that measure
    bool operator==(const Allowance&) const = default;
};

/// How one measure is judged. All numbers are the teacher's; none is part of the program.
struct CriterionRule
{
    std::string id;       ///< unique in its rubric
    LocalText title;      ///< empty: the name of the measure
    std::string measure;  ///< of core::grading's table: "caries_left_percent"
    std::string unit;     ///< of that measure
    Side side = Side::Over;
    double target = 0.0;     ///< what the measure ought to be
    double tolerance = 0.0;  ///< so far off it costs nothing
    std::optional<Allowance> allowance;
    std::optional<Once> once;
    double span = 0.0;      ///< an error of so much beyond the tolerance costs the whole weight; 0: any does
    int weightTenths = 0;   ///< tenths of a point that can be lost here; 0 for a critical one
    bool critical = false;  ///< any error beyond the tolerance takes all points above capTenths
    int capTenths = 0;      ///< what a critical error leaves at most; 0: nothing, and the attempt fails
    bool operator==(const CriterionRule&) const = default;
};

/// A way of marking: criteria whose weights make 100 points, and which of the two rules of schools adds them up.
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

/// What was measured, by the ids of core::grading's table. What is missing was not measured.
using Values = std::map<std::string, double, std::less<>>;

/// Every measure that has a value.
[[nodiscard]] Values valuesOf(const core::grading::Measured& measured);

/// Whether a rubric can mark anything: ids unique, numbers finite and in range, weights of 100 points in all, critical
/// criteria without weight. The sentence names criterion and key.
[[nodiscard]] core::Status check(const Rubric& rubric);

/// Tenths of a point that a criterion which is not critical costs taken by itself: its share of its weight, or of 100
/// points where the worst error decides.
[[nodiscard]] int lostAlone(const Criterion& line, Verdict verdict);

/// The same by its error alone, as if whatever has to be done before had been done.
[[nodiscard]] int lostByError(const Criterion& line, Verdict verdict);

/// Marks an attempt. docs/scoring.md says every step; a rubric that fails check() gives no sensible sheet. Any thread.
[[nodiscard]] ScoreSheet grade(const Rubric& rubric, const Values& values);

}  // namespace lessons
