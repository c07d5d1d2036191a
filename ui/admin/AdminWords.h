// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

#include <QString>

#include "database/AttemptRecord.h"
#include "database/IntegrityIssue.h"
#include "database/Login.h"
#include "database/Person.h"
#include "ui/text/PeopleTexts.h"

/// What an admin's page calls things.
namespace ui::admin {

/// "student", as a person's role is told.
[[nodiscard]] QString roleWord(database::Role role);
/// "has entered a person"; what is not known is told as it is noted.
[[nodiscard]] QString actionWords(const std::string& action);
/// What is wrong with a line of a class list.
[[nodiscard]] QString rosterFaultWords(const database::RosterFault& fault);
/// Full names by uid, those of classes by "class:5".
using NamesByUid = std::map<std::string, QString>;
/// Who did it, and to what, by name where there is one.
[[nodiscard]] QString actorWords(const database::AuditRow& row, const NamesByUid& names);
/// What else was noted, in a line; without what only the check reads.
[[nodiscard]] QString detailWords(const database::AuditRow& row, const NamesByUid& names,
                                  const text::LessonTitles& titles);
[[nodiscard]] QString objectWords(const database::AuditRow& row, const NamesByUid& names);
/// What a check found, people, classes and lessons by name.
[[nodiscard]] QString findingWords(const database::IntegrityIssue& finding, const NamesByUid& names,
                                   const text::LessonTitles& titles);

}  // namespace ui::admin
