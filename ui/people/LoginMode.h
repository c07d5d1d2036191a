// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace ui::people {

/// The question that the login page asks.
enum class LoginMode {
    Login,
    NewPassword,  ///< after a one-time code: choose a password
    OwnPassword,  ///< change the password of the logged-in user
    Welcome,      ///< the database has no users: practise, or set up the school
    NewSchool,    ///< name the first user of a school, its admin
    Locked        ///< the user locked the window: unlock it, or switch user
};

}  // namespace ui::people
