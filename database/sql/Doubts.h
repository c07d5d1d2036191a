// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include <QString>

#include "database/AttemptRecord.h"
#include "database/sql/DatabaseContext.h"

/// Which attempts count. An attempt in doubt (database/Doubt.h) stays in the database, but counts only when a teacher
/// gives it a score.
namespace database::sql {

class AuditBatch;

/// Returns the SQL condition that an attempt a counts.
[[nodiscard]] QString doesCount();
/// Returns the SQL condition that an attempt a is one at its lesson, and so uses up an attempt: it is not practice with
/// another version. It may be in doubt otherwise.
[[nodiscard]] QString isAtItsLesson();
/// Returns the SELECT of standings, computed from attempts a: person_id, lesson_id, attempts, best_tenths, passed,
/// last_utc. Append conditions that begin with AND, and then groupedByLesson().
[[nodiscard]] QString selectedStandings();
[[nodiscard]] QString groupedByLesson();

/// Computes the standing of a person in a lesson from their attempts. Call it inside a transaction.
[[nodiscard]] core::Status recount(const DatabaseContext& school, PersonId person, const std::string& lessonId);

/// Returns whether the classes of the person were assigned the lesson of an attempt, but never this version of it.
/// False if a class was assigned the lesson before versions were stored.
[[nodiscard]] core::Result<bool> isOfAnotherVersion(const DatabaseContext& school, const AttemptRecord& attempt);

/// Compares the earlier attempts of students at a lesson with the assigned versions. A version that no class was ever
/// assigned changes Doubt::None to Doubt::Version, and one that this class was assigned changes it back. Attempts from
/// before there were versions stay as they are. Call it inside a transaction after the assignment.
/// @param ofClass   the class whose students are compared
/// @param person    only this student; 0: all of them
/// @param lessonId  only this lesson; empty: all that the class was assigned
[[nodiscard]] core::Status compareVersions(const DatabaseContext& school, AuditBatch& audit, const std::string& actor,
                                           ClassId ofClass, PersonId person, const std::string& lessonId);

/// Returns the newest attempts of students that no teacher or admin has checked since checks exist, newest first.
[[nodiscard]] core::Result<std::vector<AttemptId>> attemptsToCheck(const DatabaseContext& school, const Login& session,
                                                                   int limit);
/// Records the result of checkAttempt() by a teacher or an admin. Doubt::None ends any doubt but Doubt::Version, and
/// that about a recording that another person delivered before.
[[nodiscard]] core::Status noteCheck(const DatabaseContext& school, const Login& session, AttemptId id, Doubt found);

}  // namespace database::sql
