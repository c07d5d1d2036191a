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

/// Texts for the admin's pages.
namespace ui::admin {

/// Returns the name of a role, such as "student".
[[nodiscard]] QString roleWord(database::Role role);
/// Returns what was done, such as "has entered a person". An unknown action is returned as stored.
[[nodiscard]] QString actionWords(const std::string& action);
/// Returns what is wrong with a line of a class list.
[[nodiscard]] QString rosterFaultWords(const database::RosterFault& fault);
/// Full names by uid; those of classes by keys such as "class:5".
using NamesByUid = std::map<std::string, QString>;
/// Return who did something, and what it was done to, by name if there is one.
[[nodiscard]] QString actorWords(const database::AuditRow& row, const NamesByUid& names);
/// Returns the other details of an audit row in one line, without those that only the integrity check uses.
[[nodiscard]] QString detailWords(const database::AuditRow& row, const NamesByUid& names,
                                  const text::LessonTitles& titles);
[[nodiscard]] QString objectWords(const database::AuditRow& row, const NamesByUid& names);
/// Returns an issue that a check found, with people, classes and lessons by name.
[[nodiscard]] QString findingWords(const database::IntegrityIssue& finding, const NamesByUid& names,
                                   const text::LessonTitles& titles);

}  // namespace ui::admin
