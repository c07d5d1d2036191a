// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string_view>

#include "database/Person.h"
#include "database/sql/DatabaseContext.h"

namespace database::sql {

/// Of a class list, that of the columns included.
constexpr std::size_t kMostRosterLines = 20'000;

/// A class list is CSV whose first line names the columns username, given_name, family_name, role and class, in any
/// order; role may be left out (student), and several classes are parted by "|".
/// Enters who is new, changes the names of who is known, and puts all into their classes, all or nothing. Admins.
/// @param dryRun  says what it would do, codes left out, and does nothing
/// @param asSeen  what that said: where it would do anything else by now it does nothing (ChangedSince); null: nobody
/// has looked
[[nodiscard]] core::Result<RosterOutcome> importRoster(const DatabaseContext& school, const Login& session,
                                                       std::string_view csv, bool dryRun,
                                                       const RosterOutcome* asSeen = nullptr);

}  // namespace database::sql
