// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "database/Person.h"
#include "database/sql/DatabaseContext.h"

namespace database::sql {

using database::Entered;

class AuditBatch;

/// Returns the people that the user may access, by family name. Admins: all; instructors: those of their classes.
[[nodiscard]] core::Result<std::vector<Person>> listPeople(const DatabaseContext& school, const Login& session);

/// Checks a given or family name. OutOfRange if it is too long or has invisible characters.
[[nodiscard]] core::Status checkPersonName(const std::string& name);

/// Creates a person and puts them into these classes, in one transaction. Admins.
[[nodiscard]] core::Result<Entered> addPerson(const DatabaseContext& school, const Login& session, const NewPerson& who,
                                              const std::vector<ClassId>& classes = {});

/// Changes names, role, whether the person is disabled, and classes, in one transaction; the uid and the username stay.
/// Admins. NobodyLeft: the last admin who can log in cannot be disabled or get another role. ChangedSince: another user
/// has changed the same field to another value; nothing is changed.
/// @param asItWas  the person as shown to the user: a field that is equal to it keeps its value in the database, and a
/// class that is in both lists or in neither stays as it is. Empty: all fields are set, and classes stay.
/// @returns  the person after the change, with the wanted classes
[[nodiscard]] core::Result<Person> changePerson(const DatabaseContext& school, const Login& session,
                                                const Person& person, const std::optional<Person>& asItWas = {});

/// Returns the person with an id. UnknownName. Does not check permissions.
[[nodiscard]] core::Result<Person> readPerson(const DatabaseContext& school, PersonId id);

/// Fails with NobodyLeft if no admin but this person can log in.
[[nodiscard]] core::Status expectAnotherAdmin(const DatabaseContext& school, PersonId person);

/// Fails with ChangedSince if the person was erased.
[[nodiscard]] core::Status expectNotErased(const Person& person);

/// Replaces the password by a one-time code, valid for Logins::kCodeLife. Clears failed logins.
[[nodiscard]] core::Result<Entered> resetPassword(const DatabaseContext& school, const Login& session, PersonId person);

/// Returns the person with a username. UnknownName; admins.
[[nodiscard]] core::Result<Person> findPerson(const DatabaseContext& school, const Login& session,
                                              const std::string& username);

/// Returns the audit's digest of a person's names. It shows that the names were changed, without revealing them.
[[nodiscard]] std::string digestOfNames(const Person& person);

/// The stored hashes for a person's login; an empty one means that they cannot log in that way.
struct KeptLogin
{
    std::string passwordHash;
    std::string codeHash;
    std::string codeUntilUtc;
};
/// Returns the audit's digest of those hashes, which each change records. It shows that they were changed, but allows
/// no login.
[[nodiscard]] std::string digestOfLogin(const std::string& uid, const KeptLogin& kept);

/// How a new person logs in first: by a password, by a one-time code, or not yet.
struct FirstLogin
{
    std::string passwordHash;
    std::string code;
};
/// Creates a person, inside a transaction of the caller. The caller checks the permission.
/// @param audit  sealed by the caller
/// @param actor  uid, for the audit
[[nodiscard]] core::Result<Person> enter(const DatabaseContext& school, AuditBatch& audit, const std::string& actor,
                                         const NewPerson& who, const FirstLogin& login);

/// Records the digest of a person's login data, inside the transaction that has changed them.
[[nodiscard]] core::Status noteLogin(const DatabaseContext& school, const std::string& actor, const std::string& action,
                                     const std::string& uid, const KeptLogin& kept);

}  // namespace database::sql
