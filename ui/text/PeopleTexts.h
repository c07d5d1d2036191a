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

/// What attempts and people are called on the pages about them.
namespace ui::text {

/// What a lesson is called, by its id.
using LessonTitles = QHash<QString, QString>;

/// The title of a lesson; its id where nobody knows it any more; practice without a lesson by its tooth.
[[nodiscard]] QString lessonTitle(const LessonTitles& titles, const std::string& lessonId);
/// "20/11/2026 10:15", in the language's order and this computer's time zone; empty for none.
[[nodiscard]] QString when(const std::string& utc);
/// The same in few letters: "today", "yesterday", "Tue", "12 Nov", "Nov 2024".
[[nodiscard]] QString whenShort(const std::string& utc, const QDateTime& now);
/// The day until whose end something is to be done: "2 Feb", of another year than this "02/02/2027"; empty for none.
[[nodiscard]] QString dueShort(const std::string& dueUtc, const QDateTime& now);
[[nodiscard]] QDateTime momentOf(const std::string& utc);
/// The last second of a day of this computer's calendar, as what is due is kept: "2026-11-27T22:59:59Z".
[[nodiscard]] std::string endOfDay(QDate day);
/// The day here at whose end something is due; none for none.
[[nodiscard]] QDate dueDay(const std::string& dueUtc);
/// "12:07"; hours where there are: "1:12:07".
[[nodiscard]] QString clock(std::int64_t ms);

/// What the criteria of a lesson are called, by their ids.
using CriterionNames = std::map<std::string, QString>;
/// The name, or the id made readable.
[[nodiscard]] QString criterionName(const CriterionNames& names, const std::string& id);

}  // namespace ui::text
