// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include <QSqlDatabase>

#include "core/base/Result.h"
#include "database/Person.h"

/// Login with the account of a station (database/sql/Grants.h), which cannot read the hashes of passwords. The station
/// computes a proof, and the server compares it. A proof is the hash of the password, or of the one-time code.
namespace database::sql::station {

/// What a proof is computed with. For an unknown name it is as plausible as for a known one.
struct Salt
{
    std::string uid;       ///< of the person, for hashOfCode()
    std::string password;  ///< for hashWithSalt()
};

[[nodiscard]] core::Result<Salt> saltOf(const QSqlDatabase& db, const std::string& username);

/// Returns the person if the proof of the password is right and the person is not disabled. Otherwise the server takes
/// a second.
[[nodiscard]] core::Result<std::optional<Person>> personBy(const QSqlDatabase& db, const std::string& username,
                                                           const std::string& passwordHash);
/// Returns whether a one-time code is right and valid.
[[nodiscard]] core::Result<bool> isCode(const QSqlDatabase& db, const std::string& username,
                                        const std::string& codeHash);

/// Logs the person in on this connection and returns the token, with which other connections act for the person.
/// WrongLogin if the proof is not right any more.
/// @param dearer  a hash of the same password to store instead; empty: none
[[nodiscard]] core::Result<std::string> logIn(const QSqlDatabase& db, const std::string& username,
                                              const std::string& passwordHash, const std::string& dearer);
/// Uses up a one-time code, sets the password and logs the person in on this connection. WrongLogin as above.
[[nodiscard]] core::Status redeem(const QSqlDatabase& db, const std::string& username, const std::string& codeHash,
                                  const std::string& newHash);
/// Changes the password and ends the person's logins on other stations. WrongLogin as above.
[[nodiscard]] core::Status setPassword(const QSqlDatabase& db, const std::string& username,
                                       const std::string& passwordHash, const std::string& newHash);

/// Makes this connection act for the person who has a token. Returns false if nobody has it any more.
/// @param token  empty: for nobody
[[nodiscard]] core::Result<bool> resume(const QSqlDatabase& db, const std::string& token);
/// Ends the login of this connection.
[[nodiscard]] core::Status logOut(const QSqlDatabase& db);

}  // namespace database::sql::station
