// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "database/Person.h"
#include "database/sql/DatabaseContext.h"

namespace database::sql {

using database::kMostRosterLines;

using KeepCodes = std::function<core::Status(const std::vector<RosterPerson>& people)>;

/// Creates new people of a class list, changes the names of known ones, and adds all to their classes. Does all or
/// nothing. Admins.
///
/// A class list is CSV whose first line names the columns username, given_name, family_name, role and class, in any
/// order. The role is optional (student), and several classes are separated by "|".
/// @param dryRun  returns the outcome without codes, and changes nothing
/// @param asSeen  the outcome of the dry run. If the import would now have another outcome, it does nothing
///                (ChangedSince). Null: there was no dry run
/// @param keepCodes  saves the codes of the new people. Called before the codes become valid; if it returns an error,
///                   the import changes nothing
[[nodiscard]] core::Result<RosterOutcome> importRoster(const DatabaseContext& school, const Login& session,
                                                       std::string_view csv, bool dryRun,
                                                       const RosterOutcome* asSeen = nullptr,
                                                       const KeepCodes& keepCodes = {});

}  // namespace database::sql
