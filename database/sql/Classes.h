// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <QByteArray>

#include "database/Person.h"
#include "database/sql/DatabaseContext.h"

namespace database::sql {

class AuditBatch;

/// Returns the name of a class as it is stored, without spaces around it. OutOfRange: it is empty, longer than 100
/// characters, has invisible characters, or has a "|", which separates classes in a class list.
[[nodiscard]] core::Result<std::string> checkClassName(const std::string& name);
/// Returns the classes that the user may access, by name.
[[nodiscard]] core::Result<std::vector<SchoolClass>> listClasses(const DatabaseContext& school, const Login& session);
[[nodiscard]] core::Result<ClassId> addClass(const DatabaseContext& school, const Login& session,
                                             const std::string& name);
[[nodiscard]] core::Status renameClass(const DatabaseContext& school, const Login& session, ClassId id,
                                       const std::string& name);
/// Adds a person to a class, or removes them from it. Does nothing if there is nothing to change.
[[nodiscard]] core::Status enrol(const DatabaseContext& school, const Login& session, ClassId id, PersonId person,
                                 bool belongs);

/// Returns the assignments of the classes that the user may access, by due date.
[[nodiscard]] core::Result<std::vector<ClassAssignment>> listAssignments(const DatabaseContext& school,
                                                                         const Login& session);
/// Assigns a lesson to a class, or changes due date, attempt limit or version of the assignment. Ignores the id.
/// @param before  the assignment as shown to the user; empty: there was none. ChangedSince: it differs from the stored
///                one
/// @param pack    of the version (lessons::packVersion()); empty if it is stored already, or none is named
[[nodiscard]] core::Status assign(const DatabaseContext& school, const Login& session,
                                  const ClassAssignment& assignment, const std::optional<ClassAssignment>& before = {},
                                  const QByteArray& pack = {});
/// Removes an assignment; its attempts stay. ChangedSince: the stored assignment differs. Does nothing if there is
/// none.
[[nodiscard]] core::Status unassign(const DatabaseContext& school, const Login& session, const ClassAssignment& before);

/// Returns how many attempts the user has left, for each lesson with a limit. If several classes were assigned the same
/// lesson, the highest limit counts. Empty for a guest.
[[nodiscard]] core::Result<std::map<std::string, int>> attemptsLeft(const DatabaseContext& school,
                                                                    const Login& session);
/// Returns the same for one lesson; empty: there is no limit.
[[nodiscard]] core::Result<std::optional<int>> attemptsLeft(const DatabaseContext& school, const Login& session,
                                                            const std::string& lessonId);

/// Returns the class of that name, and creates it if it does not exist. Call it inside a transaction; the caller checks
/// the permission and seals the audit.
[[nodiscard]] core::Result<ClassId> classNamed(const DatabaseContext& school, AuditBatch& audit,
                                               const std::string& actor, const std::string& name);
[[nodiscard]] core::Status putInto(const DatabaseContext& school, AuditBatch& audit, const std::string& actor,
                                   ClassId id, PersonId person);
/// Removes a person from a class, under the same conditions as putInto().
[[nodiscard]] core::Status takeOutOf(const DatabaseContext& school, AuditBatch& audit, const std::string& actor,
                                     ClassId id, PersonId person);

}  // namespace database::sql
