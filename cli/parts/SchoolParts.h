// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>

#include <QCommandLineParser>

#include "core/base/Result.h"
#include "database/sql/Database.h"
#include "database/sql/DatabaseContext.h"

/// Functions for the commands on a school's database.
namespace cli {

/// An open database with this station's key.
struct OpenSchool
{
    std::unique_ptr<database::sql::Database> database;
    std::unique_ptr<database::sql::DatabaseContext> school;
    bool hasStationKey = true;  ///< otherwise a temporary key
};

/// Adds --db; the default is the user's own file.
void addDatabaseOption(QCommandLineParser& parser);
[[nodiscard]] core::Result<database::Address> databaseAddress(const QCommandLineParser& parser);
/// What a command may do to a database besides its own work.
enum class Opening {
    ToLook,   ///< FileMissing if there is no file, OlderVersion for an older schema; creates no key
    AsItIs,   ///< the same; changes are signed with the station's key, which is created if necessary
    Migrate,  ///< migrate to the newest schema
    Create,   ///< create one if there is none
    ToFill    ///< the same, for a copy: the database stays empty until that is complete
};
/// Creates the user's own data folder if the database is in it; no other folder.
void makeDataFolder(const database::Address& address);
[[nodiscard]] core::Result<OpenSchool> openSchool(const database::Address& address, Opening how);
/// Returns how to get back to an earlier state of a file; empty: not possible.
[[nodiscard]] std::string wayBack(const database::Address& address);
/// Adds that to an error if a file is not usable.
[[nodiscard]] core::Error withWayBack(core::Error error, const database::Address& address);
/// Returns the path of the key that signs changes to a database.
[[nodiscard]] QString stationKeyOf(const database::Address& address);

/// Adds --as: the person who acts. The password is asked for, or read from the first line of standard input.
void addPersonOption(QCommandLineParser& parser);
/// Prints an error and returns an exit code if no person is named.
[[nodiscard]] std::optional<int> refuseNobody(const QCommandLineParser& parser);
[[nodiscard]] core::Result<database::Login> logIn(const QCommandLineParser& parser, const OpenSchool& school);

/// Asks for a secret on the terminal without echo; without a terminal, reads the next line of standard input.
/// FileEmpty: end of input, for example by Ctrl+D.
[[nodiscard]] core::Result<std::string> askSecret(const char* question);

}  // namespace cli
