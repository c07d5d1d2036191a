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

/// Charts of one student's attempts.
namespace ui::scoring {

/// Medians over a class, from each student's best attempt at a lesson.
struct ClassMedians
{
    int people = 0;  ///< number of students; medians are shown from lessons::kFewestPeople on
    int tenths = 0;
    std::int64_t durationMs = 0;
    bool operator==(const ClassMedians&) const = default;
};

/// The data of the charts.
struct ChartedAttempts
{
    QList<database::AttemptRecord> newestFirst;
    bool isOneLesson = false;  ///< all attempts are at one lesson: joined by a line, compared with the class
    text::LessonTitles titles;
    std::map<std::string, text::CriterionNames> criteria;  ///< by lesson id
    std::vector<database::BandPoint> band;
    std::optional<ClassMedians> medians;
};

/// Number of attempts that the charts show. If there are more, the newest are shown and a note says so.
inline constexpr qsizetype kMostCharted = 300;

[[nodiscard]] charts::Chart scoreChart(const ChartedAttempts& attempts);
/// Returns a chart of the points lost at each criterion, averaged over the last attempts.
[[nodiscard]] charts::Chart criteriaChart(const ChartedAttempts& attempts);
[[nodiscard]] charts::Chart timeChart(const ChartedAttempts& attempts);
[[nodiscard]] charts::Chart forceChart(const ChartedAttempts& attempts);
/// Returns a chart of score against time, because both count. Time increases to the right, points upwards.
[[nodiscard]] charts::Chart speedChart(const ChartedAttempts& attempts);

/// Returns the class's band for a chart. Empty if it covers too few students.
[[nodiscard]] charts::Band bandOf(const std::vector<database::BandPoint>& points);

}  // namespace ui::scoring
