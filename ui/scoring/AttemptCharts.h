// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <QList>
#include <QString>

#include "database/AttemptRecord.h"
#include "database/ClassOverview.h"
#include "ui/charts/Chart.h"
#include "ui/text/PeopleTexts.h"

/// Charts of one person's attempts.
namespace ui::scoring {

/// Medians of a class over each person's best attempt at a lesson.
struct ClassMedians
{
    int people = 0;  ///< shown from lessons::kFewestPeople on
    int tenths = 0;
    std::int64_t durationMs = 0;
    bool operator==(const ClassMedians&) const = default;
};

/// The data of the charts.
struct ChartedAttempts
{
    QList<database::AttemptRecord> newestFirst;
    bool isOneLesson = false;  ///< attempts of one lesson are joined by a line and compared with the class
    text::LessonTitles titles;
    std::map<std::string, text::CriterionNames> criteria;  ///< by lesson id
    std::vector<database::BandPoint> band;
    std::optional<ClassMedians> medians;
};

/// Number of attempts that the charts show. If there are more, the newest are shown and a note says so.
inline constexpr qsizetype kMostCharted = 300;

[[nodiscard]] charts::Chart scoreChart(const ChartedAttempts& attempts);
/// Charts the points that each criterion cost, on average over the last attempts.
[[nodiscard]] charts::Chart criteriaChart(const ChartedAttempts& attempts);
[[nodiscard]] charts::Chart timeChart(const ChartedAttempts& attempts);
[[nodiscard]] charts::Chart forceChart(const ChartedAttempts& attempts);
/// Charts score against time, because both count: time to the right, points upwards.
[[nodiscard]] charts::Chart speedChart(const ChartedAttempts& attempts);

/// Returns the band of a class for a chart; empty if it covers too few people.
[[nodiscard]] charts::Band bandOf(const std::vector<database::BandPoint>& points);

}  // namespace ui::scoring
