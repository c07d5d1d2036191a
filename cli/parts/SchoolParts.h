// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>

#include <QCommandLineParser>

#include "core/base/Result.h"
#include "database/sql/Database.h"
#include "database/sql/DatabaseContext.h"

/// What the commands about a school's data share.
namespace cli {

/// An open database with this station's key.
struct OpenSchool
{
    std::unique_ptr<database::sql::Database> database;
    std::unique_ptr<database::sql::DatabaseContext> school;
    bool hasStationKey = true;  ///< else one that is forgotten
};

/// Adds --db: the user's own file if not given.
void addDatabaseOption(QCommandLineParser& parser);
[[nodiscard]] core::Result<database::Address> databaseAddress(const QCommandLineParser& parser);
/// What a command may do to a database beside its own work.
enum class Opening {
    ToLook,   ///< FileMissing where no file is, OlderVersion where an older program wrote it; makes no key there
    AsItIs,   ///< the same; what is written is signed with the station's key, which is made if need be
    Migrate,  ///< bring it to the newest schema
    Create,   ///< where nothing is
    ToFill    ///< the same, by a copy: until that is whole nothing is there
};
/// Makes the user's own folder, if the database is to lie there; no other.
void makeDataFolder(const database::Address& address);
[[nodiscard]] core::Result<OpenSchool> openSchool(const database::Address& address, Opening how);
/// Of a file, what there is to go back to; empty: nothing.
[[nodiscard]] std::string wayBack(const database::Address& address);
/// The same behind what is the matter, where a file cannot be used any more.
[[nodiscard]] core::Error withWayBack(core::Error error, const database::Address& address);
/// Where the key lies that signs what is written there.
[[nodiscard]] QString stationKeyOf(const database::Address& address);

/// Adds --as: who does it. His password is asked for, or read from the first line of standard input.
void addPersonOption(QCommandLineParser& parser);
/// Says that somebody has to be named, and gives the exit code, where nobody is.
[[nodiscard]] std::optional<int> refuseNobody(const QCommandLineParser& parser);
[[nodiscard]] core::Result<database::Login> logIn(const QCommandLineParser& parser, const OpenSchool& school);

/// Asks on the terminal without showing what is typed; without a terminal, the next line of standard input. FileEmpty:
/// that ends before there is one, as by Ctrl+D.
[[nodiscard]] core::Result<std::string> askSecret(const char* question);

}  // namespace cli
