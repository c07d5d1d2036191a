// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <string>

#include "database/Passwords.h"
#include "database/Person.h"
#include "database/sql/DatabaseContext.h"

namespace database::sql {

/// How one comes in. Each call hashes a password: keep it off the ui thread. A class only because nobody else makes a
/// Session.
class Logins
{
public:
    /// After this many failures in a row the next try has to wait a second, then two, four, up to a quarter of an hour.
    static constexpr int kFreeFailures = 3;
    static constexpr std::chrono::seconds kLongestWait = std::chrono::minutes(15);
    /// Beyond so many names that logins have failed with, those are forgotten that nobody has tried for a day.
    static constexpr int kMostFailedNames = 10'000;
    /// How long a one-time code is good for.
    static constexpr std::chrono::hours kCodeLife = std::chrono::hours(72);

    /// What the audit calls the name of a login that failed, behind "name:": whatever was typed, it stands nowhere.
    [[nodiscard]] static std::string nameInAudit(const std::string& username);

    /// Whether nobody has been entered yet: the first may make himself the admin.
    [[nodiscard]] static core::Result<bool> isNew(const DatabaseContext& school);

    /// checkPassword(), and it must not look like a one-time code.
    [[nodiscard]] static core::Status checkNewPassword(const std::string& password, const std::string& username);

    /// Enters the first person, an admin, and keeps what passwords cost here. NotAllowed when there is somebody.
    [[nodiscard]] static core::Result<Login> createFirstAdmin(const DatabaseContext& school, const NewPerson& who,
                                                              const std::string& password, const PasswordCost& cost);

    /// Lets a person in. WrongLogin, with the same words and after the same time: no such name, a wrong password, a
    /// disabled account. TooSoon: after failures, also of others at the same moment. NewPassword: a one-time code was
    /// right, which redeem() takes.
    [[nodiscard]] static core::Result<Login> login(const DatabaseContext& school, const std::string& username,
                                                   const std::string& password);

    /// Takes a one-time code, which is then used up, and sets the password. Failures as of login(), and of
    /// checkPassword().
    [[nodiscard]] static core::Result<Login> redeem(const DatabaseContext& school, const std::string& username,
                                                    const std::string& code, const std::string& newPassword);

    /// Tells the audit that a person has gone.
    [[nodiscard]] static core::Status logout(const DatabaseContext& school, const Login& session);

    /// WrongLogin if the present password is not `old`.
    [[nodiscard]] static core::Status changePassword(const DatabaseContext& school, const Login& session,
                                                     const std::string& old, const std::string& newPassword);

    /// What one's own password is compared with (database::fits), for where the database is away when a place that was
    /// left is unlocked.
    [[nodiscard]] static core::Result<std::string> ownHash(const DatabaseContext& school, const Login& session);
};

/// What passwords cost in this school, never less than DatabaseContext::leastCost.
[[nodiscard]] core::Result<PasswordCost> passwordCost(const DatabaseContext& school);

/// From now on passwords cost as much, if that is at least twice what they do: each hash is made anew when its owner
/// logs in next. Never less. Admins; hashes once.
[[nodiscard]] core::Status raisePasswordCost(const DatabaseContext& school, const Login& session,
                                             const PasswordCost& cost);

}  // namespace database::sql
