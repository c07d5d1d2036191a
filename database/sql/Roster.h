// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "database/people.h"
#include "database/sql/School.h"

namespace database::sql {

/// A class list: CSV whose first line names the columns username, given_name, family_name, role and class, in any
/// order; role may be left out (student), and several classes are parted by "|".
struct RosterFault
{
    int line = 0;        ///< of the file, from 1
    std::string column;  ///< its name; empty: the whole line
    std::string what;
};
struct RosterPerson
{
    std::string username;
    std::string fullName;
    bool isNew = false;
    std::string code;  ///< of a new one: it lets him in once, and is kept nowhere else
};
struct RosterOutcome
{
    std::vector<RosterFault> faults;  ///< any: nothing was entered
    std::vector<RosterPerson> people;
};

/// Enters who is new, changes the names of who is known, and puts all into their classes, all or nothing. Admins.
/// @param dryRun  says what it would do, codes left out, and does nothing
[[nodiscard]] core::Result<RosterOutcome> importRoster(const School& school, const Session& session,
                                                       std::string_view csv, bool dryRun);

}  // namespace database::sql
