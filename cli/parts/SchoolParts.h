// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>

#include <QCommandLineParser>

#include "core/base/Result.h"
#include "database/Secret.h"
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
/// How a command opens a database.
enum class Opening {
    ToLook,   ///< FileMissing if there is no file, OlderVersion for an older schema; creates no key
    AsItIs,   ///< the same, but signs changes with the station's key, and creates the key if necessary
    Migrate,  ///< migrate to the newest schema
    Create,   ///< create one if there is none
    ToFill    ///< the same, for a copy: the database stays empty until that is complete
};
/// Creates the user's own data folder, if the database is in it. Creates no other folder.
void makeDataFolder(const database::Address& address);
[[nodiscard]] core::Result<OpenSchool> openSchool(const database::Address& address, Opening how);
/// Returns instructions for going back to an earlier state of a file; empty if that is not possible.
[[nodiscard]] std::string wayBack(const database::Address& address);
/// Adds those instructions to an error of an unusable file.
[[nodiscard]] core::Error withWayBack(core::Error error, const database::Address& address);
/// Returns the path of the key that signs changes to a database.
[[nodiscard]] QString stationKeyOf(const database::Address& address);

/// Adds --as: the username of the acting person. The command prompts for the password, or reads it from the first line
/// of standard input.
void addPersonOption(QCommandLineParser& parser);
/// Prints an error and returns an exit code if --as is missing.
[[nodiscard]] std::optional<int> refuseNobody(const QCommandLineParser& parser);
[[nodiscard]] core::Result<database::Login> logIn(const QCommandLineParser& parser, const OpenSchool& school);

/// Prompts for a secret on the terminal without echo. Without a terminal, reads the next line of standard input.
/// FileEmpty: end of input, for example by Ctrl+D.
[[nodiscard]] core::Result<database::Secret> askSecret(const char* question);

}  // namespace cli
