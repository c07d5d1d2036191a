// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace ui::people {

/// What the login page asks for.
enum class Door {
    Login,
    NewPassword,  ///< after a one-time code: choose a password
    OwnPassword,  ///< change the password of the logged-in user
    NewSchool,    ///< the database has no users
    Locked        ///< the user locked the window: unlock it, or switch user
};

}  // namespace ui::people
