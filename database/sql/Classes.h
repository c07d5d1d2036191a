// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "database/Person.h"
#include "database/sql/DatabaseContext.h"

namespace database::sql {

class AuditBatch;

/// Returns the name of a class as it is stored. OutOfRange if it is empty, longer than 100 characters, has invisible
/// characters, or has a "|", which separates classes in a class list.
[[nodiscard]] core::Result<std::string> checkClassName(const std::string& name);
/// Returns the classes that the user may access, by name.
[[nodiscard]] core::Result<std::vector<SchoolClass>> listClasses(const DatabaseContext& school, const Login& session);
[[nodiscard]] core::Result<ClassId> addClass(const DatabaseContext& school, const Login& session,
                                             const std::string& name);
[[nodiscard]] core::Status renameClass(const DatabaseContext& school, const Login& session, ClassId id,
                                       const std::string& name);
/// Adds a person to a class, or removes the person. Does nothing if that is already so.
[[nodiscard]] core::Status enrol(const DatabaseContext& school, const Login& session, ClassId id, PersonId person,
                                 bool belongs);

/// Returns the assignments of the classes that the user may access, by due date.
[[nodiscard]] core::Result<std::vector<ClassAssignment>> listAssignments(const DatabaseContext& school,
                                                                         const Login& session);
/// Assigns a lesson to a class, or changes its due date and attempt limit. The id is ignored.
/// @param before  the assignment as the user has seen it; empty: none. ChangedSince: it is different
[[nodiscard]] core::Status assign(const DatabaseContext& school, const Login& session,
                                  const ClassAssignment& assignment, const std::optional<ClassAssignment>& before = {});
/// Removes an assignment; attempts stay. ChangedSince: it is not as the user has seen it. Does nothing if it is removed
/// already.
[[nodiscard]] core::Status unassign(const DatabaseContext& school, const Login& session, const ClassAssignment& before);

/// Returns the number of attempts at a lesson that the user has left; empty: no limit. Of several classes the highest
/// limit applies.
[[nodiscard]] core::Result<std::optional<int>> attemptsLeft(const DatabaseContext& school, const Login& session,
                                                            const std::string& lessonId);

/// Returns the class of that name and creates it if necessary. Inside a transaction of the caller, which has checked
/// the permission and seals the audit.
[[nodiscard]] core::Result<ClassId> classNamed(const DatabaseContext& school, AuditBatch& audit,
                                               const std::string& actor, const std::string& name);
[[nodiscard]] core::Status putInto(const DatabaseContext& school, AuditBatch& audit, const std::string& actor,
                                   ClassId id, PersonId person);
/// As putInto(): removes a person from a class.
[[nodiscard]] core::Status takeOutOf(const DatabaseContext& school, AuditBatch& audit, const std::string& actor,
                                     ClassId id, PersonId person);

}  // namespace database::sql
