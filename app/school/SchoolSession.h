// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/Person.h"

namespace app {

class SchoolAccess;

/// The user who works at this window, and the database of the school. Application owns the one object of it, and its
/// controllers share it. Ui thread.
struct SchoolSession
{
    SchoolAccess* service = nullptr;  ///< null: there is no database, and nothing is saved
    database::Login user;             ///< a guest until somebody logs in

    /// Whether somebody is logged in to a database.
    [[nodiscard]] bool isLoggedIn() const { return service != nullptr && !user.isGuest(); }
};

}  // namespace app
