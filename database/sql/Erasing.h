// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/Person.h"
#include "database/sql/DatabaseContext.h"

namespace database::sql {

using database::ErasedPerson;

/// Stands for an erased text. The migration that lets overrides be erased contains the same mark.
inline constexpr const char* kErasedText = "[…]";

/// Erases a person, in one transaction. A pseudonym replaces the username; names, password, one-time code, last login,
/// failed logins, own settings and classes go, and the account is disabled. A mark replaces the comments by the person
/// and on their attempts, and the reasons of overrides of their attempts. Attempts, score sheets, recordings and scores
/// stay. The audit gets a row of the person and one of each text. Rewrites an SQLite file afterwards, so that no unused
/// part of it contains what was erased.
///
/// Admins. NotAllowed: the account of a station on a server, which may not do that. NobodyLeft: the last admin who can
/// log in. NotAllowed: the user's own account. ChangedSince: erased already. UnknownName: there is no such person.
[[nodiscard]] core::Result<ErasedPerson> erasePerson(const DatabaseContext& school, const Login& session,
                                                     PersonId person);

}  // namespace database::sql
