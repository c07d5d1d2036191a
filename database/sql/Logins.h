// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <string>

#include "database/Passwords.h"
#include "database/Person.h"
#include "database/sql/DatabaseContext.h"

namespace database::sql {

/// Authentication. Most calls hash a password: do not call them on the ui thread. A class, because only it may create a
/// Login.
class Logins
{
public:
    /// Number of failures without a delay. After more failures in a row the next attempt has to wait one second, then
    /// two, four, up to kLongestWait.
    static constexpr int kFreeFailures = 3;
    static constexpr std::chrono::seconds kLongestWait = std::chrono::minutes(15);
    /// Number of names with failed logins beyond which those are removed that have not been tried for a day.
    static constexpr int kMostFailedNames = 10'000;
    /// Validity of a one-time code.
    static constexpr std::chrono::hours kCodeLife = std::chrono::hours(72);

    /// Whether the school has no people yet: the first user creates the account of the admin.
    [[nodiscard]] static core::Result<bool> isNew(const DatabaseContext& school);

    /// Checks a new password: checkPassword(), and that it does not look like a one-time code.
    [[nodiscard]] static core::Status checkNewPassword(const std::string& password, const std::string& username);

    /// Enters the first person, an admin, and stores the cost of passwords. NotAllowed if there is already a person.
    [[nodiscard]] static core::Result<Login> createFirstAdmin(const DatabaseContext& school, const NewPerson& who,
                                                              const std::string& password, const PasswordCost& cost);

    /// Logs a person in. WrongLogin, with the same text and after the same time: unknown name, wrong password, disabled
    /// account. TooSoon: after failures, also by others at the same time. NewPassword: a valid one-time code, for
    /// redeem().
    [[nodiscard]] static core::Result<Login> login(const DatabaseContext& school, const std::string& username,
                                                   const std::string& password);

    /// Uses up a one-time code and sets the password. Errors as for login() and checkPassword().
    [[nodiscard]] static core::Result<Login> redeem(const DatabaseContext& school, const std::string& username,
                                                    const std::string& code, const std::string& newPassword);

    /// Notes in the audit that a person has logged out.
    [[nodiscard]] static core::Status logout(const DatabaseContext& school, const Login& session);

    /// Changes the user's password. WrongLogin if the current password is not `old`.
    [[nodiscard]] static core::Status changePassword(const DatabaseContext& school, const Login& session,
                                                     const std::string& old, const std::string& newPassword);

    /// Returns the hash of the user's password (database::fits()), for unlocking the window when the database is
    /// unavailable.
    [[nodiscard]] static core::Result<std::string> ownHash(const DatabaseContext& school, const Login& session);
};

/// Returns the cost of passwords in this school, never less than DatabaseContext::leastCost.
[[nodiscard]] core::Result<PasswordCost> passwordCost(const DatabaseContext& school);

/// Raises the cost of passwords, if it at least doubles: each hash is renewed at the owner's next login. Never lowers
/// it. Admins; computes one hash.
[[nodiscard]] core::Status raisePasswordCost(const DatabaseContext& school, const Login& session,
                                             const PasswordCost& cost);

}  // namespace database::sql
