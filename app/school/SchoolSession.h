// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/Person.h"

namespace app {

class SchoolAccess;

/// The user who is logged in, and the access to the database of the school. Application owns the only object of this
/// type and shares it with its controllers. Ui thread.
struct SchoolSession
{
    SchoolAccess* service = nullptr;  ///< null: there is no database, and nothing is saved
    database::Login user;             ///< a guest while no user is logged in

    /// Returns whether a user is logged in to a database.
    [[nodiscard]] bool isLoggedIn() const { return service != nullptr && !user.isGuest(); }
};

}  // namespace app
