// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "database/Person.h"
#include "database/sql/DatabaseContext.h"

namespace database::sql {

class AuditBatch;

/// Returns the name of a class as it is stored, without spaces around it. OutOfRange: it is empty, longer than 100
/// characters, has invisible characters, or has a "|", which separates classes in a class list.
[[nodiscard]] core::Result<std::string> checkClassName(const std::string& name);
/// The classes within the login's reach, by name.
[[nodiscard]] core::Result<std::vector<SchoolClass>> listClasses(const DatabaseContext& school, const Login& session);
[[nodiscard]] core::Result<ClassId> addClass(const DatabaseContext& school, const Login& session,
                                             const std::string& name);
[[nodiscard]] core::Status renameClass(const DatabaseContext& school, const Login& session, ClassId id,
                                       const std::string& name);
/// Puts a person into a class, or removes them from it. Does nothing if that is so already.
[[nodiscard]] core::Status enrol(const DatabaseContext& school, const Login& session, ClassId id, PersonId person,
                                 bool belongs);

/// The assignments of the classes within the login's reach, by due date.
[[nodiscard]] core::Result<std::vector<ClassAssignment>> listAssignments(const DatabaseContext& school,
                                                                         const Login& session);
/// Gives a class a lesson to do, or changes when it is due and how often it may be tried. The id is ignored.
/// @param before  what there is, as whoever changes it has seen it; empty: nothing. ChangedSince: it is otherwise
[[nodiscard]] core::Status assign(const DatabaseContext& school, const Login& session,
                                  const ClassAssignment& assignment, const std::optional<ClassAssignment>& before = {});
/// Takes it back; attempts stay. ChangedSince: it is not as it was seen; where it is gone already nothing is done.
[[nodiscard]] core::Status unassign(const DatabaseContext& school, const Login& session, const ClassAssignment& before);

/// How many attempts the session's person has left at each lesson with a limit, by lesson. If several classes were
/// assigned a lesson, the most generous limit holds. Empty for a guest.
[[nodiscard]] core::Result<std::map<std::string, int>> attemptsLeft(const DatabaseContext& school,
                                                                    const Login& session);
/// The same for one lesson; empty: there is no limit.
[[nodiscard]] core::Result<std::optional<int>> attemptsLeft(const DatabaseContext& school, const Login& session,
                                                            const std::string& lessonId);

/// Inside a transaction of others, who have looked whether it is allowed, and seal the audit: the class of that name,
/// made if need be.
[[nodiscard]] core::Result<ClassId> classNamed(const DatabaseContext& school, AuditBatch& audit,
                                               const std::string& actor, const std::string& name);
[[nodiscard]] core::Status putInto(const DatabaseContext& school, AuditBatch& audit, const std::string& actor,
                                   ClassId id, PersonId person);
/// As putInto(): removes a person from a class.
[[nodiscard]] core::Status takeOutOf(const DatabaseContext& school, AuditBatch& audit, const std::string& actor,
                                     ClassId id, PersonId person);

}  // namespace database::sql
