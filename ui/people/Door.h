// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace ui::people {

/// What the login page asks for.
enum class Door {
    Login,
    NewPassword,  ///< the one-time code was right
    OwnPassword,  ///< who is logged in changes his
    NewSchool,    ///< nobody has been entered yet
    Locked        ///< somebody has left his place: he comes back, or another logs in
};

}  // namespace ui::people
