// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "database/Person.h"
#include "database/sql/DatabaseContext.h"

namespace database::sql {

using database::kMostRosterLines;

/// A class list is CSV whose first line names the columns username, given_name, family_name, role and class, in any
/// order; role is optional (student), and several classes are separated by "|".
/// Enters new people, changes the names of known ones, and adds all to their classes, all or nothing. Admins.
/// @param dryRun  returns what would be done, without codes, and changes nothing
/// @param asSeen  the outcome of the dry run: if the import would now do anything else, it does nothing (ChangedSince);
///                null: no dry run
[[nodiscard]] core::Result<RosterOutcome> importRoster(const DatabaseContext& school, const Login& session,
                                                       std::string_view csv, bool dryRun,
                                                       const RosterOutcome* asSeen = nullptr);

}  // namespace database::sql
