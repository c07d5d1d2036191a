// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "database/Person.h"
#include "database/sql/DatabaseContext.h"

namespace database::sql {

class AuditBatch;

/// Everybody within the session's reach, by family name. Admins: all; instructors: those of their classes.
[[nodiscard]] core::Result<std::vector<Person>> listPeople(const DatabaseContext& school, const Login& session);

/// OutOfRange: a given or family name is too long, or holds what cannot be seen.
[[nodiscard]] core::Status checkPersonName(const std::string& name);

/// Who was entered, or has no password any more, and the one-time code that lets him in: it is kept nowhere in clear,
/// so tell it now.
struct Entered
{
    Person person;
    std::string code;
};
[[nodiscard]] core::Result<Entered> addPerson(const DatabaseContext& school, const Login& session,
                                              const NewPerson& who);

/// Names, role and whether disabled; the uid and the username stay. NobodyLeft: the last admin who can log in cannot be
/// disabled or made something else.
/// ChangedSince: others have set the same to something else, and nothing is changed.
/// @param asItWas  when the change was thought of: what is as it was then stays as others have set it since
/// @returns  as he is now
[[nodiscard]] core::Result<Person> changePerson(const DatabaseContext& school, const Login& session,
                                                const Person& person, const std::optional<Person>& asItWas = {});

/// Takes the password away and gives a one-time code in its place, good for Logins::kCodeLife. Failed logins are
/// forgiven.
[[nodiscard]] core::Result<Entered> resetPassword(const DatabaseContext& school, const Login& session, PersonId person);

/// By the name that is typed at the login. UnknownName; admins.
[[nodiscard]] core::Result<Person> findPerson(const DatabaseContext& school, const Login& session,
                                              const std::string& username);

/// What the audit notes of a person's names: it can tell that they were changed, and not what they are.
[[nodiscard]] std::string digestOfNames(const Person& person);

/// What lets a person in, as it is kept; empty: not that way.
struct KeptLogin
{
    std::string passwordHash;
    std::string codeHash;
    std::string codeUntilUtc;
};
/// What the audit notes of that, at each change of it: it can tell that it was changed, and lets nobody in.
[[nodiscard]] std::string digestOfLogin(const std::string& uid, const KeptLogin& kept);

/// How somebody new comes in: by a password, a one-time code, or not yet.
struct FirstLogin
{
    std::string passwordHash;
    std::string code;
};
/// Inside a transaction of others, who have looked whether it is allowed.
/// @param audit  which they seal
/// @param actor  uid, for the audit
[[nodiscard]] core::Result<Person> enter(const DatabaseContext& school, AuditBatch& audit, const std::string& actor,
                                         const NewPerson& who, const FirstLogin& login);

/// Inside the transaction that has changed what lets a person in: notes it as it is now.
[[nodiscard]] core::Status noteLogin(const DatabaseContext& school, const std::string& actor, const std::string& action,
                                     const std::string& uid);

}  // namespace database::sql
