// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include <QDateTime>
#include <QHash>
#include <QList>
#include <QString>

#include "database/AttemptRecord.h"

/// Texts about attempts and people.
namespace ui::text {

/// Titles of lessons by id.
using LessonTitles = QHash<QString, QString>;

/// Returns the title of a lesson. Returns its id if the lesson is unknown, and the name of the tooth for practice
/// without a lesson.
[[nodiscard]] QString lessonTitle(const LessonTitles& titles, const std::string& lessonId);
/// Returns why an attempt does not count, in a sentence or two. Empty for Doubt::None.
[[nodiscard]] QString doubtWords(database::Doubt doubt);
/// Returns a local date and time, "20/11/2026 10:15", in the format of the language. Empty for an empty string.
[[nodiscard]] QString when(const std::string& utc);
/// Returns a short date: "today", "yesterday", "Tue", "12 Nov", "Nov 2024".
[[nodiscard]] QString whenShort(const std::string& utc, const QDateTime& now);
/// Returns the due day: "2 Feb", or "02/02/2027" in another year. Empty if there is none.
[[nodiscard]] QString dueShort(const std::string& dueUtc, const QDateTime& now);
[[nodiscard]] QDateTime momentOf(const std::string& utc);
/// Returns the last second of a local day in UTC, which is how due dates are stored: "2026-11-27T22:59:59Z".
[[nodiscard]] std::string endOfDay(QDate day);
/// Returns the local day at whose end something is due. Invalid if there is no due date.
[[nodiscard]] QDate dueDay(const std::string& dueUtc);
/// Returns a duration: "12:07", or "1:12:07" from one hour on.
[[nodiscard]] QString clock(std::int64_t ms);

/// Names of the criteria of a lesson, by id.
using CriterionNames = std::map<std::string, QString>;
/// Returns the name of a criterion. If it has none, returns its id in readable form.
[[nodiscard]] QString criterionName(const CriterionNames& names, const std::string& id);

}  // namespace ui::text
