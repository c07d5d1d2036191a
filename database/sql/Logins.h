// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <string>

#include "database/Passwords.h"
#include "database/Person.h"
#include "database/sql/DatabaseContext.h"

namespace database::sql {

/// Authentication. Most functions hash a password: do not call them in the ui thread. It is a class because only a
/// friend of Login may create one.
class Logins
{
public:
    /// Number of failures of a name on one station without a delay. After more failures in a row, the next attempt has
    /// to wait one second, then two, four and so on, up to kLongestWait. If the last failure was more than a day ago,
    /// they count from 1 again.
    static constexpr int kFreeFailures = 3;
    static constexpr std::chrono::seconds kLongestWait = std::chrono::minutes(15);
    /// The same for the failures of a name on all stations together. The short wait slows down somebody who guesses
    /// with many keys of stations, and does not keep the person out.
    static constexpr int kFreeFailuresAnywhere = 30;
    static constexpr std::chrono::seconds kLongestWaitAnywhere{8};
    /// If more names than this have failed logins, those that have not been tried for a day are removed.
    static constexpr int kMostFailedNames = 10'000;
    /// Validity of a one-time code.
    static constexpr std::chrono::hours kCodeLife = std::chrono::hours(72);

    /// Returns whether the database has no people yet. The first user then creates the account of the admin.
    [[nodiscard]] static core::Result<bool> isNew(const DatabaseContext& school);

    /// Checks a new password by checkPassword(), and that it does not look like a one-time code.
    [[nodiscard]] static core::Status checkNewPassword(const std::string& password, const std::string& username);

    /// Creates the first person, an admin, and stores the cost of passwords. NotAllowed if there is a person already.
    [[nodiscard]] static core::Result<Login> createFirstAdmin(const DatabaseContext& school, const NewPerson& who,
                                                              const std::string& password, const PasswordCost& cost);

    /// Logs a person in. WrongLogin: unknown name, wrong password or disabled account, always with the same text and
    /// after the same time. TooSoon: the name has to wait after failures, also those on other stations at the same
    /// time. NewPassword: the password is a valid one-time code; call redeem().
    [[nodiscard]] static core::Result<Login> login(const DatabaseContext& school, const std::string& username,
                                                   const std::string& password);

    /// Uses up a one-time code and sets the password. Errors as for login() and checkPassword().
    [[nodiscard]] static core::Result<Login> redeem(const DatabaseContext& school, const std::string& username,
                                                    const std::string& code, const std::string& newPassword);

    /// Records in the audit that a person has logged out.
    [[nodiscard]] static core::Status logout(const DatabaseContext& school, const Login& session);

    /// Changes the user's password. WrongLogin if the current password is not `old`.
    [[nodiscard]] static core::Status changePassword(const DatabaseContext& school, const Login& session,
                                                     const std::string& old, const std::string& newPassword);

    /// Returns the hash of the user's password (database::fits()), for unlocking the window when the database is
    /// unavailable.
    [[nodiscard]] static core::Result<std::string> ownHash(const DatabaseContext& school, const Login& session);

    /// Returns what identifies the user to a server where this station's account may not read passwords
    /// (database/sql/Grants.h); otherwise empty.
    [[nodiscard]] static std::string tokenOf(const Login& session);
};

/// Returns the cost of passwords in this school, never less than DatabaseContext::leastCost.
[[nodiscard]] core::Result<PasswordCost> passwordCost(const DatabaseContext& school);

/// Raises the cost of passwords, if it at least doubles. Each hash is renewed at its owner's next login. Never lowers
/// the cost. Computes one hash. Admins.
[[nodiscard]] core::Status raisePasswordCost(const DatabaseContext& school, const Login& session,
                                             const PasswordCost& cost);

}  // namespace database::sql
