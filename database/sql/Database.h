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

/// What SQLite puts beside a database's file.
inline constexpr std::array kBeside{"-journal", "-wal", "-shm"};
/// A database's file with them, itself last: what lies beside it is never alone there.
[[nodiscard]] QStringList wholeOf(const QString& file);

/// Whether a database may lie there: a readable file, or none yet in a folder that exists. Refused with one sentence: a
/// folder, a pipe, a device, a file of several names. The file itself is not opened.
[[nodiscard]] core::Status checkPlace(const QString& path);

/// Whether the file is there and who runs the program may not write it.
[[nodiscard]] bool isReadOnly(const QString& file);

/// One open SQLite file or PostgreSQL database, brought to the newest schema. Belongs to the thread that opened it;
/// close it before the QCoreApplication ends.
class Database
{
public:
    struct Options
    {
        /// How long to wait for another program's write.
        std::chrono::milliseconds patience = std::chrono::seconds(5);
        /// Bring an older schema to the newest. On a server that many stations share it is `cusp db migrate` that does.
        bool mayMigrate = true;
        /// Back a file up, verified, before its schema changes.
        bool savesFirst = true;
        /// Make a school where there is nothing, or an empty file.
        bool mayCreate = true;
        /// Where nothing is, leave it so: copySchool() makes the school there.
        bool isToBeFilled = false;
        /// Where the file lies; for tests. Servers are not asked.
        FileSystem (*fileSystemOf)(const QString& path) = &database::fileSystemOf;
    };

    /// Opens the database, or creates it where nothing is. SQLite: write-ahead log, full sync at each commit, foreign
    /// keys on, the file checked before it is used, a verified backup before its schema changes; on a network drive one
    /// program at a time, see notice(). Refused with one sentence and left untouched: a folder, a file that is no
    /// database or belongs to another program, a damaged one, one from a later program, a place that cannot be written,
    /// a server that does not answer.
    [[nodiscard]] static core::Result<std::unique_ptr<Database>> open(const Address& address, const Options& options);
    [[nodiscard]] static core::Result<std::unique_ptr<Database>> open(const Address& address);
    /// @param where  as Address::parse() reads it
    [[nodiscard]] static core::Result<std::unique_ptr<Database>>
    open(const QString& where, std::chrono::milliseconds patience = std::chrono::seconds(5));

    ~Database();
    Database(const Database&) = delete;
    Database& operator=(const Database&) = delete;

    [[nodiscard]] QSqlDatabase handle() const { return QSqlDatabase::database(m_connection, false); }
    [[nodiscard]] const Address& address() const { return m_address; }
    /// One sentence for who runs the place, such as that the file lies on a network drive; empty: nothing to say.
    [[nodiscard]] const std::string& notice() const { return m_notice; }
    /// False on a network drive: this connection keeps out every other one, those of this program too.
    [[nodiscard]] bool allowsOthers() const { return m_allowsOthers; }

    /// Of a file: whether it still is the one of that name. Who goes on in one that was moved or removed writes where
    /// nobody looks. core::ErrorCode::FileMissing: none is there; core::ErrorCode::WrongKind: another one is.
    [[nodiscard]] core::Status stillThere() const;

    /// Of a server: whether it answers, and on this connection: one that was started anew meanwhile does not.
    [[nodiscard]] bool answers() const;

    /// After core::ErrorCode::ConnectionLost: connects again. What was in a transaction is gone.
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
