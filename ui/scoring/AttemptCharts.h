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

/// The attempts of one person as charts.
namespace ui::scoring {

/// What half of a class is below, of everybody's best attempt at a lesson.
struct ClassMedians
{
    int people = 0;  ///< shown from lessons::kFewestPeople on
    int tenths = 0;
    std::int64_t durationMs = 0;
    bool operator==(const ClassMedians&) const = default;
};

/// What the charts are made from.
struct ChartedAttempts
{
    QList<database::AttemptRecord> newestFirst;
    bool isOneLesson = false;  ///< the attempts are then joined by a line and compared with the class
    text::LessonTitles titles;
    std::map<std::string, text::CriterionNames> criteria;  ///< by lesson
    std::vector<database::BandPoint> band;
    std::optional<ClassMedians> medians;
};

/// More than these are not told apart: the newest are shown, and the note says so.
inline constexpr qsizetype kMostCharted = 300;

[[nodiscard]] charts::Chart scoreChart(const ChartedAttempts& attempts);
/// What each criterion took of its weight on the average of the last attempts.
[[nodiscard]] charts::Chart criteriaChart(const ChartedAttempts& attempts);
[[nodiscard]] charts::Chart timeChart(const ChartedAttempts& attempts);
[[nodiscard]] charts::Chart forceChart(const ChartedAttempts& attempts);
/// Both count: time to the right, points upwards.
[[nodiscard]] charts::Chart speedChart(const ChartedAttempts& attempts);

/// The band of a class as a chart has it; empty where it tells of too few people.
[[nodiscard]] charts::Band bandOf(const std::vector<database::BandPoint>& points);

}  // namespace ui::scoring
