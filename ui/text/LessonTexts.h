// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>

#include <QDateTime>
#include <QFontMetrics>
#include <QString>
#include <QStringList>

#include "lessons/Lesson.h"

/// Texts about lessons in the user's language.
namespace ui::text {

/// Returns a text of a lesson in the current language.
[[nodiscard]] QString said(const ::lessons::LocalText& text);
/// Returns the heading of a lesson's group: its course, or its task such as "Removing decay". Exams have their own
/// group, whatever their course and task.
[[nodiscard]] QString groupName(const ::lessons::Lesson& lesson);
/// Returns the sort key of a lesson's group: easier work first, exams last. Lessons with equal keys belong to one
/// group.
[[nodiscard]] std::pair<int, std::string> groupPlace(const ::lessons::Lesson& lesson);
/// Returns the tooth of a lesson: "Lower left first molar (36)", "Practice block", or the file name of a scan.
[[nodiscard]] QString toothWords(const ::lessons::Lesson& lesson);
/// Returns the orientation of the tooth, such as "buccal side towards the bur"; empty if it is upright.
[[nodiscard]] QString lyingWords(const ::lessons::Lesson& lesson);
/// Elides toothWords() to a width. Shortens the name and keeps the number after it.
[[nodiscard]] QString shortTooth(const QString& words, const QFontMetrics& metrics, int widthPx);
/// Returns the burs of a lesson, such as "Pear, No. 330; round, No. 2", or that any may be used.
[[nodiscard]] QString burWords(const ::lessons::Lesson& lesson);
/// Returns the allowed aids, or "none" or "all".
[[nodiscard]] QString aidWords(const ::lessons::Aids& aids);
/// Returns the aids that are not allowed.
[[nodiscard]] QStringList lockedAids(const ::lessons::Aids& aids);
/// Returns the time of a lesson, such as "8 minutes", or that there is no limit.
[[nodiscard]] QString timeWords(const ::lessons::Lesson& lesson);
/// Returns the sentence that no attempt is left.
[[nodiscard]] QString usedUpWords();
/// Returns why there is no expert's recording to play.
/// @param lesson  the current lesson; null: none
[[nodiscard]] QString noExpertWords(const ::lessons::Lesson* lesson, bool isExamRunning);
/// Returns why the result of an exam does not count.
[[nodiscard]] QString begunElsewhereWords();
/// Returns the due date relative to now: "due today 17:00", "due Friday", "due 12/12/2026", "17 Nov, 3 days late".
/// Local time.
[[nodiscard]] QString dueWords(const QDateTime& due, const QDateTime& now);
/// Returns the due date without relation to now, for completed lessons: "due 17 Nov". Local time.
[[nodiscard]] QString dueDayWords(const QDateTime& due, const QDateTime& now);
/// Returns each criterion with the points it may cost: "Decay left: 60.0 points".
[[nodiscard]] QStringList criteriaWords(const ::lessons::Rubric& rubric);

/// Returns the tolerances of a rubric that are drawn on the tooth: "outline 0.3 mm to either side; floor 0.25 mm up or
/// down". Empty if it has none.
[[nodiscard]] QString freeWords(const ::lessons::Rubric& rubric);
/// Returns the rule of a criterion in a sentence: "Up to 0.3 mm costs nothing; from 1 mm on all 20.0 points are lost".
[[nodiscard]] QString ruleWords(const ::lessons::CriterionRule& rule);
/// Returns the capitalised name of a number of an ideal or a block, by its English name (core::NumberField::name).
[[nodiscard]] QString fieldName(const char* name);
/// Returns the unit: "mm", "°"; empty for a plain number.
[[nodiscard]] QString fieldUnit(const char* unit);
/// Returns the criterion's own title, or the name of its measure.
[[nodiscard]] QString titleOf(const ::lessons::CriterionRule& rule);

}  // namespace ui::text
