// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <chrono>
#include <memory>
#include <string>

#include <QSqlDatabase>
#include <QString>
#include <QStringList>

#include "core/base/Result.h"
#include "database/Address.h"
#include "database/FileSystem.h"

namespace database::sql {

/// Suffixes of the files that SQLite creates beside a database.
inline constexpr std::array kBeside{"-journal", "-wal", "-shm"};
/// Returns the paths of those files, then of the database itself. Moving or removing them in this order never leaves
/// them without the database.
[[nodiscard]] QStringList wholeOf(const QString& file);

/// Checks whether a database can be at a path: a readable file, or no file in an existing folder. Returns an error of
/// one sentence for a folder, a pipe, a device, or a file with several hard links. Does not open the file.
[[nodiscard]] core::Status checkPlace(const QString& path);

/// Returns whether the file exists and this process may not write it.
[[nodiscard]] bool isReadOnly(const QString& file);

/// An open SQLite file or PostgreSQL database with the newest schema. Belongs to the thread that opened it; close it
/// before the QCoreApplication ends.
class Database
{
public:
    struct Options
    {
        /// Time to wait for another program's write.
        std::chrono::milliseconds patience = std::chrono::seconds(5);
        /// Migrate an older schema. On a server shared by many stations, `cusp db migrate` does that.
        bool mayMigrate = true;
        /// Write a verified backup of a file before its schema changes.
        bool savesFirst = true;
        /// Create a school if there is no file, or an empty one.
        bool mayCreate = true;
        /// Leave an empty database empty: copySchool() creates the school.
        bool isToBeFilled = false;
        /// Determines the kind of drive; for tests. Not used for servers.
        FileSystem (*fileSystemOf)(const QString& path) = &database::fileSystemOf;
    };

    /// Opens a database, or creates it if there is none. SQLite: write-ahead log, full sync at each commit, foreign
    /// keys on. The file is checked first, and backed up before its schema changes. On a network drive only one program
    /// at a time can open it, see notice(). Each error is one sentence and changes nothing: a folder, a file that is no
    /// database or belongs to another program, a damaged file, a database of a newer program, a location that cannot be
    /// written, a server that does not respond.
    [[nodiscard]] static core::Result<std::unique_ptr<Database>> open(const Address& address, const Options& options);
    [[nodiscard]] static core::Result<std::unique_ptr<Database>> open(const Address& address);
    /// @param where  as for Address::parse()
    [[nodiscard]] static core::Result<std::unique_ptr<Database>>
    open(const QString& where, std::chrono::milliseconds patience = std::chrono::seconds(5));

    ~Database();
    Database(const Database&) = delete;
    Database& operator=(const Database&) = delete;

    [[nodiscard]] QSqlDatabase handle() const { return QSqlDatabase::database(m_connection, false); }
    [[nodiscard]] const Address& address() const { return m_address; }
    /// Returns one sentence for the administrator, such as that the file is on a network drive; empty: none.
    [[nodiscard]] const std::string& notice() const { return m_notice; }
    /// Returns false on a network drive, where this connection excludes all others, also those of this program.
    [[nodiscard]] bool allowsOthers() const { return m_allowsOthers; }

    /// For a file: checks that the path still refers to the open file, because data written to a moved or removed file
    /// would be lost. core::ErrorCode::FileMissing: there is no file at the path. core::ErrorCode::WrongKind: there is
    /// another file.
    [[nodiscard]] core::Status stillThere() const;

    /// For a server: returns whether it responds on this connection. After a restart of the server, it does not.
    [[nodiscard]] bool answers() const;

    /// Connects again after core::ErrorCode::ConnectionLost. An open transaction is lost.
    [[nodiscard]] core::Status reconnect();

private:
    Database(Address address, QString connection) : m_address(std::move(address)), m_connection(std::move(connection))
    {}
    [[nodiscard]] core::Status connect();
    [[nodiscard]] core::Status prepareFile(const Options& options);
    [[nodiscard]] core::Status prepareFileOn(FileSystem fileSystem);
    [[nodiscard]] core::Status prepareServer();
    [[nodiscard]] core::Status bringToNewest(const Options& options);

    Address m_address;
    QString m_connection;
    std::string m_notice;
    bool m_allowsOthers = true;
    std::chrono::milliseconds m_patience{};
};

}  // namespace database::sql
