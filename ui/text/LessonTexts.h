// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>

#include <QDateTime>
#include <QFontMetrics>
#include <QString>
#include <QStringList>

#include "lessons/Lesson.h"

/// What is said of a lesson, in the user's language.
namespace ui::text {

/// A text of the lesson's own in the language of the program.
[[nodiscard]] QString said(const ::lessons::LocalText& text);
/// The heading of a lesson's group: its course, or by its task "Removing decay". Exams have a group of their own,
/// whatever their course and task.
[[nodiscard]] QString groupName(const ::lessons::Lesson& lesson);
/// The order of the groups: easier work first, exams last. Two lessons are of one group where this is equal.
[[nodiscard]] std::pair<int, std::string> groupPlace(const ::lessons::Lesson& lesson);
/// "Lower left first molar (36)", "Practice block", a scan's file name.
[[nodiscard]] QString toothWords(const ::lessons::Lesson& lesson);
/// How the tooth lies: "buccal side towards the bur"; empty where it stands upright.
[[nodiscard]] QString lyingWords(const ::lessons::Lesson& lesson);
/// Those words where they are too long: the kind is cut short, and not the number behind it.
[[nodiscard]] QString shortTooth(const QString& words, const QFontMetrics& metrics, int widthPx);
/// "Pear, No. 330; round, No. 2", or that any may be taken.
[[nodiscard]] QString burWords(const ::lessons::Lesson& lesson);
/// The aids that are allowed; "none", "all".
[[nodiscard]] QString aidWords(const ::lessons::Aids& aids);
/// The aids that are not allowed.
[[nodiscard]] QStringList lockedAids(const ::lessons::Aids& aids);
/// "8 minutes", or that there is no limit.
[[nodiscard]] QString timeWords(const ::lessons::Lesson& lesson);
/// That no attempt is left to who has been given it.
[[nodiscard]] QString usedUpWords();
/// Why there is no expert's attempt to watch.
/// @param lesson  on the table; null: none
[[nodiscard]] QString noExpertWords(const ::lessons::Lesson* lesson, bool isExamRunning);
/// Why an exam counts as nothing.
[[nodiscard]] QString begunElsewhereWords();
/// When it is due, as one says it: "due today 17:00", "due Friday", "due 12/12/2026", "17 Nov, 3 days late". Local
/// time.
[[nodiscard]] QString dueWords(const QDateTime& due, const QDateTime& now);
/// Of what nobody waits for any more: "due 17 Nov". Local time.
[[nodiscard]] QString dueDayWords(const QDateTime& due, const QDateTime& now);
/// Each criterion with what it may cost: "Decay left: 60.0 points".
[[nodiscard]] QStringList criteriaWords(const ::lessons::Rubric& rubric);

/// What a rubric lets pass of what is drawn on the tooth: "outline 0.3 mm to either side; floor 0.25 mm up or down";
/// empty where it marks nothing of that.
[[nodiscard]] QString freeWords(const ::lessons::Rubric& rubric);
/// What a criterion asks, in a sentence: "Up to 0.3 mm costs nothing; from 1 mm on all 20.0 points are lost".
[[nodiscard]] QString ruleWords(const ::lessons::CriterionRule& rule);
/// Of a number of an ideal or a block, by its English name (core::NumberField::name), beginning with a capital.
[[nodiscard]] QString fieldName(const char* name);
/// "mm", "°"; empty for a plain number.
[[nodiscard]] QString fieldUnit(const char* unit);
/// The criterion's own title, or the name of its measure.
[[nodiscard]] QString titleOf(const ::lessons::CriterionRule& rule);

}  // namespace ui::text
