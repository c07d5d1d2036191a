// SPDX-License-Identifier: GPL-3.0-or-later
#include "lessons/Rubric.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include <QtGlobal>

namespace lessons {
namespace {

/// Largest difference that counts as rounding, in units of the measure and of its inputs.
constexpr double kRoundingUnits = 1.0e-9;
constexpr double kRoundingShare = 1.0e-14;

/// Returns an error that names the criterion and the key.
tl::unexpected<core::Error> wrong(core::ErrorCode code, const Rubric& rubric, const CriterionRule& rule,
                                  const char* key, core::LocalizableText what)
{
    return core::unexpected(
        code, core::LocalizableText{QT_TRANSLATE_NOOP("Fault", "rubric %1, criterion %2, %3: %4"),
                                    {core::noted(rubric.id), core::noted(rule.id), core::noted(key), std::move(what)}});
}

core::Status checkNumber(const Rubric& rubric, const CriterionRule& rule, const char* key, double value, double least)
{
    if (std::isfinite(value) && value >= least && value <= kLargestRubricNumber)
        return {};
    return wrong(core::ErrorCode::OutOfRange, rubric, rule, key,
                 {QT_TRANSLATE_NOOP("Fault", "%1 %2 is not between %3 and %4"),
                  {core::noted(std::to_string(value)),
                   {rule.unit},
                   core::noted(std::to_string(least)),
                   core::noted(std::to_string(kLargestRubricNumber))}});
}

core::Status checkCriterion(const Rubric& rubric, const CriterionRule& rule)
{
    if (auto sound = checkNumber(rubric, rule, "target", rule.target, -kLargestRubricNumber); !sound)
        return sound;
    if (auto sound = checkNumber(rubric, rule, "tolerance", rule.tolerance, 0.0); !sound)
        return sound;
    if (auto sound = checkNumber(rubric, rule, "span", rule.span, 0.0); !sound)
        return sound;
    if (rule.allowance)
        if (auto sound = checkNumber(rubric, rule, "allowance", rule.allowance->each, 0.0); !sound)
            return sound;
    if (rule.once)
        if (auto sound = checkNumber(rubric, rule, "once", rule.once->reaches, -kLargestRubricNumber); !sound)
            return sound;
    if (rule.capTenths < 0 || rule.capTenths > kFullTenths || (rule.capTenths != 0 && !rule.critical))
        return wrong(
            core::ErrorCode::OutOfRange, rubric, rule, "caps_at",
            {QT_TRANSLATE_NOOP("Fault", "must lie between 0.1 and 100 points, at a criterion without weight")});
    if (rule.critical && rule.weightTenths != 0)
        return wrong(core::ErrorCode::BadStructure, rubric, rule, "weight",
                     {QT_TRANSLATE_NOOP("Fault", "a critical criterion has none; it limits the points of the whole "
                                                 "attempt")});
    if (!rule.critical && rule.weightTenths <= 0)
        return wrong(core::ErrorCode::OutOfRange, rubric, rule, "weight",
                     {QT_TRANSLATE_NOOP("Fault", "must be at least 0.1 points")});
    return {};
}

std::optional<double> valueOf(const std::string& measure, const Values& values)
{
    const auto found = values.find(measure);
    return found != values.end() && std::isfinite(found->second) ? std::optional(found->second) : std::nullopt;
}

double tolerated(const CriterionRule& rule, const Values& values)
{
    if (!rule.allowance)
        return rule.tolerance;
    const double scale = valueOf(rule.allowance->measure, values).value_or(0.0);
    return rule.tolerance + rule.allowance->each * std::max(0.0, scale);
}

/// Returns how far a value deviates from its target, in the direction that counts.
double offTarget(const CriterionRule& rule, double value)
{
    switch (rule.side) {
    case Side::Over:
        return std::max(0.0, value - rule.target);
    case Side::Under:
        return std::max(0.0, rule.target - value);
    case Side::Both:
        break;
    }
    return std::abs(value - rule.target);
}

/// Returns an error as a share of the span; 1 without a measured value, because only measured values earn points.
double shareOf(const Criterion& line)
{
    if (!line.measured)
        return 1.0;
    if (!(line.error > 0.0))
        return 0.0;
    return line.span > 0.0 ? std::min(1.0, line.error / line.span) : 1.0;
}

/// Returns the largest rounding error of numbers of this size.
double roundingOf(double sum)
{
    return std::max(kRoundingUnits, kRoundingShare * sum);
}

Criterion judge(const CriterionRule& rule, const Values& values)
{
    Criterion line;
    line.id = rule.id;
    line.title = rule.title;
    line.measure = rule.measure;
    line.unit = rule.unit;
    line.side = rule.side;
    line.target = rule.target;
    line.tolerance = tolerated(rule, values);
    line.span = rule.span;
    line.weightTenths = rule.weightTenths;
    line.critical = rule.critical;
    line.capTenths = rule.capTenths;
    line.once = rule.once;
    line.measured = valueOf(rule.measure, values);
    if (line.measured) {
        const double error = offTarget(rule, *line.measured) - line.tolerance;
        if (error > roundingOf(std::abs(*line.measured) + std::abs(rule.target) + line.tolerance))
            line.error = error;
    }
    if (rule.once) {
        line.onceMeasured = valueOf(rule.once->measure, values);
        line.isTooEarly =
            !line.onceMeasured || rule.once->reaches - *line.onceMeasured >
                                      roundingOf(std::abs(*line.onceMeasured) + std::abs(rule.once->reaches));
    }
    // Without the condition, a criterion earns no points yet, and a critical one has not failed yet.
    const double tooEarly = line.critical ? 0.0 : 1.0;
    line.share = line.isTooEarly ? tooEarly : shareOf(line);
    return line;
}

/// Limits the remaining points by the critical errors. The lowest limit takes all points above it.
int limited(int left, std::vector<Criterion>& lines)
{
    Criterion* lowest = nullptr;
    for (Criterion& line : lines)
        if (line.critical && line.share > 0.0 && (lowest == nullptr || line.capTenths < lowest->capTenths))
            lowest = &line;
    if (lowest == nullptr || lowest->capTenths >= left)
        return left;
    lowest->lostTenths = left - lowest->capTenths;
    return lowest->capTenths;
}

}  // namespace

Values valuesOf(const core::grading::Measured& measured)
{
    Values values;
    for (const core::grading::MeasureInfo& measure : core::grading::measureTable())
        if (const auto value = measure.value(measured))
            values.emplace(measure.id, *value);
    return values;
}

core::Status check(const Rubric& rubric)
{
    if (rubric.criteria.empty() || rubric.criteria.size() > kMostCriteria)
        return core::unexpected(
            core::ErrorCode::BadStructure,
            core::LocalizableText{QT_TRANSLATE_NOOP("Fault", "rubric %1, criteria: there are %2, it takes 1 to %3"),
                                  {core::noted(rubric.id), core::noted(std::to_string(rubric.criteria.size())),
                                   core::noted(std::to_string(kMostCriteria))}});
    if (rubric.passMarkTenths < 0 || rubric.passMarkTenths > kFullTenths)
        return core::unexpected(
            core::ErrorCode::OutOfRange,
            core::LocalizableText{QT_TRANSLATE_NOOP("Fault", "rubric %1, pass_mark: must lie between 0 and "
                                                             "100 points"),
                                  {core::noted(rubric.id)}});
    std::set<std::string> ids;
    int sum = 0;
    for (const CriterionRule& rule : rubric.criteria) {
        if (auto sound = checkCriterion(rubric, rule); !sound)
            return sound;
        if (!ids.insert(rule.id).second)
            return wrong(core::ErrorCode::BadStructure, rubric, rule, "id",
                         {QT_TRANSLATE_NOOP("Fault", "is there twice")});
        sum += rule.weightTenths;
    }
    if (sum != kFullTenths) {
        const std::string whole = std::to_string(sum / 10) + "." + std::to_string(sum % 10);
        return core::unexpected(
            core::ErrorCode::BadStructure,
            core::LocalizableText{QT_TRANSLATE_NOOP("Fault", "rubric %1, weight: those of all criteria make "
                                                             "%2 points; they must make 100"),
                                  {core::noted(rubric.id), core::noted(whole)}});
    }
    return {};
}

int lostAlone(const Criterion& line, Verdict verdict)
{
    const int stake = verdict == Verdict::SumOfErrors ? line.weightTenths : kFullTenths;
    return static_cast<int>(std::lround(stake * line.share));
}

int lostByError(const Criterion& line, Verdict verdict)
{
    Criterion alone = line;
    alone.share = shareOf(line);
    return lostAlone(alone, verdict);
}

ScoreSheet grade(const Rubric& rubric, const Values& values)
{
    ScoreSheet sheet;
    sheet.rubricId = rubric.id;
    sheet.rubricVersion = rubric.version;
    sheet.rubricHash = rubric.hash;
    sheet.rubricTitle = rubric.title;
    sheet.verdict = rubric.verdict;
    sheet.passMarkTenths = rubric.passMarkTenths;
    Criterion* worst = nullptr;
    for (const CriterionRule& rule : rubric.criteria)
        sheet.criteria.push_back(judge(rule, values));
    for (Criterion& line : sheet.criteria) {
        if (line.critical)
            continue;
        if (rubric.verdict == Verdict::SumOfErrors)
            line.lostTenths = lostAlone(line, rubric.verdict);
        else if (worst == nullptr || line.share > worst->share)
            worst = &line;
    }
    if (worst != nullptr)
        worst->lostTenths = lostAlone(*worst, rubric.verdict);
    int left = kFullTenths;
    for (const Criterion& line : sheet.criteria)
        left -= line.lostTenths;
    sheet.totalTenths = limited(left, sheet.criteria);
    return sheet;
}

}  // namespace lessons
