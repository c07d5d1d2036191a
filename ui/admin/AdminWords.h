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
/// Returns an action in words, such as "has entered a person". Returns an unknown action as stored.
[[nodiscard]] QString actionWords(const std::string& action);
/// Returns the error in a line of a class list, in words.
[[nodiscard]] QString rosterFaultWords(const database::RosterFault& fault);
/// Full names of people by uid, and names of classes by keys such as "class:5".
using NamesByUid = std::map<std::string, QString>;
/// Return the actor and the object of an action, by name if known.
[[nodiscard]] QString actorWords(const database::AuditRow& row, const NamesByUid& names);
/// Returns the other details of an audit row in one line. Omits those that only the integrity check uses.
[[nodiscard]] QString detailWords(const database::AuditRow& row, const NamesByUid& names,
                                  const text::LessonTitles& titles);
[[nodiscard]] QString objectWords(const database::AuditRow& row, const NamesByUid& names);
/// Returns an integrity issue in words, with people, classes and lessons by name.
[[nodiscard]] QString findingWords(const database::IntegrityIssue& finding, const NamesByUid& names,
                                   const text::LessonTitles& titles);

}  // namespace ui::admin
