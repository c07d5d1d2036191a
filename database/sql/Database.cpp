// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/sql/Database.h"

#include <atomic>

#include <QFile>
#include <QFileInfo>
#include <QSqlDriver>
#include <QVariant>
#include <fcntl.h>
#include <sqlite3.h>
#include <sys/stat.h>
#include <unistd.h>

#include "database/sql/Backups.h"
#include "database/sql/Dialect.h"
#include "database/sql/Migrations.h"
#include "database/sql/Statement.h"

namespace database::sql {
namespace {

using core::ErrorCode;

constexpr int kConnectTimeoutS = 5;

std::string head(const QString& path)
{
    return "database " + path.toStdString() + ": ";
}

core::Error foreign(const QSqlDatabase& db)
{
    return {ErrorCode::WrongKind,
            "database " + dialect::nameOf(db) + ": this database belongs to another program; choose another one"};
}

/// Checks, before the file is written to, that it belongs to this program and is not damaged.
core::Status examine(const QSqlDatabase& db)
{
    const auto application = ask(db, "PRAGMA application_id", "open it");
    if (!application)
        return tl::unexpected(application.error());
    const auto tables = dialect::countTables(db);
    if (!tables)
        return tl::unexpected(tables.error());
    const bool ours = application->toInt() == dialect::kApplicationId;
    const bool blank = application->toInt() == 0 && *tables == 0;
    if (!ours && !blank)
        return tl::unexpected(foreign(db));
    const auto whole = ask(db, "PRAGMA quick_check(1)", "check it");
    if (!whole)
        return tl::unexpected(whole.error());
    // This program never writes such a row, and a damaged disk does not cause this error.
    constexpr QLatin1String kRefused("CHECK constraint failed in ");
    if (const QString said = whole->toString(); said.startsWith(kRefused))
        return core::unexpected(ErrorCode::BadStructure,
                                head(dialect::fileOf(db)) + "a row of the table " +
                                    said.mid(kRefused.size()).toStdString() +
                                    " holds what this program never writes, so that another must have put it there; "
                                    "restore a backup of the file");
    if (whole->toString() != "ok")
        return core::unexpected(ErrorCode::BadStructure, head(dialect::fileOf(db)) + "the file is damaged (" +
                                                             whole->toString().simplified().toStdString() +
                                                             "); restore a backup of it");
    return {};
}

/// Gives the files beside a writable database its permissions if they are read-only. SQLite created them while the
/// database was read-only, and they would make it read-only again.
void freeBesides(const QString& path)
{
    if (isReadOnly(path))
        return;
    for (const char* end : kBeside)
        if (const QString beside = path + QLatin1String(end); !QFileInfo(beside).isSymLink() && isReadOnly(beside))
            QFile::setPermissions(beside, QFile::permissions(path));
}

core::Status set(const QSqlDatabase& db, const QStringList& settings)
{
    for (const QString& setting : settings)
        if (auto done = execute(db, setting, "set it up"); !done)
            return done;
    return {};
}

core::Status configure(const QSqlDatabase& db, FileSystem fileSystem)
{
    // synchronous=FULL, because with a write-ahead log NORMAL may lose the last commits in a power failure.
    const QStringList settings{
        fileSystem == FileSystem::Network ? "PRAGMA locking_mode = EXCLUSIVE" : "PRAGMA locking_mode = NORMAL",
        fileSystem == FileSystem::Network ? "PRAGMA journal_mode = DELETE" : "PRAGMA journal_mode = WAL",
        "PRAGMA synchronous = FULL", "PRAGMA secure_delete = ON"};
    if (auto done = set(db, settings); !done)
        return done;
    // If two programs shared a read lock, neither could ever write. So one program locks the file, or opening it fails.
    if (fileSystem == FileSystem::Network)
        if (auto alone = set(db, {"BEGIN EXCLUSIVE", "COMMIT"}); !alone)
            return alone;
    if (auto done = set(db, {"PRAGMA foreign_keys = ON", "PRAGMA trusted_schema = OFF", "PRAGMA cell_size_check = ON"});
        !done)
        return done;
    // Setting the id is a write. A program that only reads must not wait for one that is writing.
    const auto application = ask(db, "PRAGMA application_id", "set it up");
    if (!application)
        return tl::unexpected(application.error());
    if (application->toInt() == dialect::kApplicationId)
        return {};
    return execute(db, QStringLiteral("PRAGMA application_id = %1").arg(dialect::kApplicationId), "set it up");
}

/// Returns whether this process may write a file, by its effective user.
bool mayWrite(const QString& path)
{
    return faccessat(AT_FDCWD, QFile::encodeName(path).constData(), W_OK, AT_EACCESS) == 0;
}

/// Returns whether the file exists, but it or its folder is read-only. SQLite would only report that it "cannot open"
/// it.
bool isWhereNothingIsKept(const QString& path)
{
    const QFileInfo file(path);
    return file.isFile() && !(mayWrite(path) && mayWrite(file.absolutePath()));
}

/// Returns the reason why a file cannot be created in a missing folder.
core::Error noFolder(const QString& path)
{
    QString above = QFileInfo(path).absolutePath();
    while (!QFileInfo::exists(above))
        above = QFileInfo(above).absolutePath();
    if (mayWrite(above))
        return {ErrorCode::FileMissing, head(path) + "the folder does not exist; create it or choose another place"};
    return {ErrorCode::FileUnwritable, head(path) + "the folder does not exist, and none can be created in " +
                                           above.toStdString() +
                                           "; choose another place, or see that this folder can be written"};
}

/// Returns the options of libpq for encryption. Certificates that vouch for the server are those in libpq's own file
/// (~/.postgresql/root.crt) or, where there is none, those that the computer trusts, as for a web site.
QString sslOptions(const Address& address)
{
    const QString mode = address.sslModeInForce();
    QString options = mode.isEmpty() ? QString() : QStringLiteral(";sslmode=") + mode;
    QString certificates = address.sslRootCert;
    if (certificates.isEmpty() && mode.startsWith(QStringLiteral("verify")) &&
        !qEnvironmentVariableIsSet("PGSSLROOTCERT") &&
        !QFileInfo::exists(QDir::home().filePath(QStringLiteral(".postgresql/root.crt"))))
        certificates = QStringLiteral("/etc/ssl/certs/ca-certificates.crt");
    if (!certificates.isEmpty())
        options += QStringLiteral(";sslrootcert='%1'").arg(certificates);
    return options;
}

}  // namespace

bool isReadOnly(const QString& file)
{
    return QFileInfo(file).isFile() && !mayWrite(file);
}

QStringList wholeOf(const QString& file)
{
    QStringList files;
    for (const char* end : kBeside)
        files += file + QLatin1String(end);
    return files << file;
}

/// Checks a path without SQLite, which would only report that it "cannot open" it. Does not open the file itself:
/// closing it would release the locks of this program's other connections. Another program would then remove the
/// write-ahead log while they use it (sqlite.org/howtocorrupt.html, 2.2).
core::Status checkPlace(const QString& path)
{
    const QFileInfo info(path);
    if (info.isDir())
        return core::unexpected(ErrorCode::FileUnreadable, head(path) + "this is a folder; name a file inside it");
    if (!info.exists()) {
        if (!QFileInfo(info.absolutePath()).isDir())
            return tl::unexpected(noFolder(path));
        return {};
    }
    if (!info.isFile())
        return core::unexpected(ErrorCode::WrongKind,
                                head(path) + "this is no file but a device or a pipe; name a file");
    if (!info.isReadable())
        return core::unexpected(ErrorCode::FileUnreadable, head(path) + "it cannot be read; check who may read it");
    // The -wal file is beside the name. Two programs that open the file by two names would each use their own -wal
    // file, and overwrite each other's changes (sqlite.org/howtocorrupt.html, 2.5).
    struct stat there
    {};
    if (stat(QFile::encodeName(path).constData(), &there) == 0 && there.st_nlink > 1)
        return core::unexpected(ErrorCode::FileUnreadable,
                                head(path) + "it has " + std::to_string(there.st_nlink) +
                                    " names (hard links), by which two programs would spoil it; remove all names but "
                                    "one (\"find FOLDER -samefile FILE\" lists them), and try again");
    return {};
}

core::Result<std::unique_ptr<Database>> Database::open(const Address& address)
{
    return open(address, Options{});
}

core::Result<std::unique_ptr<Database>> Database::open(const QString& where, std::chrono::milliseconds patience)
{
    const auto address = Address::parse(where);
    if (!address)
        return tl::unexpected(address.error());
    Options options;
    options.patience = patience;
    return open(*address, options);
}

core::Result<std::unique_ptr<Database>> Database::open(const Address& address, const Options& options)
{
    if (!address.isServer()) {
        if (auto fit = checkPlace(address.file); !fit)
            return tl::unexpected(fit.error());
        freeBesides(address.file);
    }
    // Creates the file for its owner only, because it will contain names and scores. SQLite would let everybody read
    // it, and gives the files beside it the same permissions. Changing permissions later would be too late for programs
    // that have opened it. If the file cannot be created, SQLite reports the reason.
    if (QFile file(address.file);
        options.mayCreate && !address.isServer() && !file.exists() &&
        file.open(QIODevice::WriteOnly | QIODevice::NewOnly, QFile::ReadOwner | QFile::WriteOwner))
        file.close();
    static std::atomic<int> opened{0};
    std::unique_ptr<Database> database(new Database(address, QStringLiteral("cusp-%1").arg(opened.fetch_add(1))));
    database->m_patience = options.patience;
    auto ready = database->connect();
    if (ready)
        ready = address.isServer() ? database->prepareServer() : database->prepareFile(options);
    if (ready)
        ready = database->bringToNewest(options);
    if (!ready && !address.isServer() && ready.error().code == ErrorCode::FileUnwritable &&
        isWhereNothingIsKept(address.file))
        return core::unexpected(ErrorCode::FileUnwritable,
                                head(address.file) +
                                    "the file or its folder is read-only; make it writable, or copy it, with what lies "
                                    "beside it, to another place and choose it there");
    if (!ready)
        return tl::unexpected(ready.error());
    return database;
}

core::Status Database::connect()
{
    if (m_address.isServer() && !QSqlDatabase::isDriverAvailable(QStringLiteral("QPSQL")))
        return core::unexpected(ErrorCode::ConnectionLost,
                                "database " + m_address.shown().toStdString() +
                                    ": this computer cannot speak with PostgreSQL; install libqt6sql6-psql");
    QSqlDatabase db = QSqlDatabase::addDatabase(
        m_address.isServer() ? QStringLiteral("QPSQL") : QStringLiteral("QSQLITE"), m_connection);
    const auto patience = static_cast<long long>(m_patience.count());
    if (m_address.isServer()) {
        db.setHostName(m_address.host);
        db.setDatabaseName(m_address.name);
        db.setUserName(m_address.user);
        if (m_address.port > 0)
            db.setPort(m_address.port);
        // Detects a lost connection within about ten seconds instead of two hours.
        db.setConnectOptions(QStringLiteral("connect_timeout=%1;keepalives_idle=5;keepalives_interval=2;"
                                            "keepalives_count=3;tcp_user_timeout=10000;application_name=cusp%2")
                                 .arg(kConnectTimeoutS)
                                 .arg(sslOptions(m_address)));
        if (!m_address.isProtected())
            m_notice = "database " + m_address.shown().toStdString() +
                       ": the connection is not protected (sslmode=" + m_address.sslMode.toStdString() +
                       "): who is on the network can read or change names and marks; docs/security.md shows how to "
                       "set up verify-full";
    } else {
        db.setDatabaseName(m_address.file);
        db.setConnectOptions(QStringLiteral("QSQLITE_BUSY_TIMEOUT=%1").arg(patience));
    }
    return reconnect();
}

core::Status Database::stillThere() const
{
    const QVariant connection = handle().driver()->handle();
    if (!connection.isValid() || qstrcmp(connection.typeName(), "sqlite3*") != 0)
        return {};
    int hasMoved = 0;
    auto* const file = *static_cast<sqlite3* const*>(connection.data());
    if (sqlite3_file_control(file, "main", SQLITE_FCNTL_HAS_MOVED, &hasMoved) != SQLITE_OK || hasMoved == 0)
        return {};
    if (!QFileInfo::exists(m_address.file))
        return core::unexpected(ErrorCode::FileMissing, head(m_address.file) +
                                                            "it was moved or removed while it was open; put it back, "
                                                            "or start again");
    return core::unexpected(ErrorCode::WrongKind, head(m_address.file) + "another file has taken its place");
}

core::Status Database::prepareFile(const Options& options)
{
    const FileSystem fileSystem = options.fileSystemOf(m_address.file);
    m_allowsOthers = fileSystem == FileSystem::Local;
    if (m_allowsOthers)
        return prepareFileOn(fileSystem);
    m_notice = head(m_address.file) +
               "it lies on a network drive, where only one station at a time can use it and speed is that of the "
               "network; for several stations keep the data on a PostgreSQL server";
    core::Status ready = prepareFileOn(fileSystem);
    if (!ready && ready.error().code == ErrorCode::Busy)
        return core::unexpected(
            ErrorCode::OpenElsewhere,
            head(m_address.file) +
                "it lies on a network drive, where only one program at a time can use it, and another "
                "has it open, here or at another station; close that one, and for several stations "
                "keep the data on a PostgreSQL server");
    return ready;
}

core::Status Database::prepareFileOn(FileSystem fileSystem)
{
    const QSqlDatabase db = handle();
    if (auto fit = examine(db); !fit)
        return fit;
    const auto steps = shippedMigrations();
    if (!steps)
        return tl::unexpected(steps.error());
    const auto version = dialect::schemaVersion(db);
    if (!version)
        return tl::unexpected(version.error());
    // The settings of a database from a newer program must not be changed.
    if (*version > static_cast<int>(steps->size()))
        return {};
    return configure(db, fileSystem);
}

core::Status Database::prepareServer()
{
    const QSqlDatabase db = handle();
    const auto letters = ask(db, "SHOW server_encoding", "look into it");
    if (!letters)
        return tl::unexpected(letters.error());
    if (letters->toString() != u"UTF8")
        return core::unexpected(ErrorCode::WrongKind,
                                "database " + dialect::nameOf(db) + ": it keeps texts as " +
                                    letters->toString().toStdString() +
                                    ", which has not all letters; create it with \"createdb --encoding=UTF8 "
                                    "--template=template0\"");
    // The tables are counted before the version is read, because another program may be creating the schema.
    const auto tables = dialect::countTables(db);
    if (!tables)
        return tl::unexpected(tables.error());
    const auto version = dialect::schemaVersion(db);
    if (!version)
        return tl::unexpected(version.error());
    if (*version > 0)
        return {};
    return *tables == 0 ? core::Status() : core::Status(tl::unexpected(foreign(db)));
}

core::Status Database::bringToNewest(const Options& options)
{
    const QSqlDatabase db = handle();
    const auto steps = shippedMigrations();
    if (!steps)
        return tl::unexpected(steps.error());
    const auto version = dialect::schemaVersion(db);
    if (!version)
        return tl::unexpected(version.error());
    if (*version == 0 && !options.mayCreate)
        return core::unexpected(ErrorCode::BadStructure, "database " + dialect::nameOf(db) +
                                                             ": it is empty, there is no school in it; restore a "
                                                             "backup, or \"cusp db init\" creates a school");
    if (*version == 0 && options.isToBeFilled)
        return {};
    const bool isOlder = *version > 0 && *version < static_cast<int>(steps->size());
    if (isOlder && !options.mayMigrate)
        return core::unexpected(ErrorCode::OlderVersion,
                                "database " + dialect::nameOf(db) + ": an older program wrote it (schema " +
                                    std::to_string(*version) + ", this program needs " + std::to_string(steps->size()) +
                                    "); let its administrator run \"cusp db migrate\"");
    QString saved;
    if (isOlder && options.savesFirst && !m_address.isServer()) {
        auto made = saveBeforeMigration(db, *version);
        if (!made)
            return tl::unexpected(made.error());
        saved = *made;
    }
    auto done = migrate(db, *steps);
    // If nothing was migrated, the backup is not needed. Otherwise each new trial would leave one.
    if (!done && !saved.isEmpty() && dialect::schemaVersion(db).value_or(0) == *version)
        QFile::remove(saved);
    return done;
}

core::Status Database::reconnect()
{
    QSqlDatabase db = handle();
    db.close();
    if (!db.open())
        return tl::unexpected(dialect::error(db, db.lastError(), "open it"));
    if (!m_address.isServer())
        return {};
    if (auto pinned = dialect::pinSearchPath(db); !pinned)
        return pinned;
    if (auto recognized = dialect::recognizeStation(db); !recognized)
        return recognized;
    // Waiting for a lock ends with an error after this time, as in SQLite. With the keep-alive settings the server
    // detects a lost connection within about ten seconds, and releases the locks of the station; they have no effect on
    // a local socket. The outbox removes a file after the commit, so commits must be synchronous. Notices of the server
    // would be mixed with the sentences of Cusp.
    return execute(db,
                   QStringLiteral("SELECT set_config('lock_timeout', '%1', false), "
                                  "set_config('client_min_messages', 'error', false), "
                                  "set_config('tcp_keepalives_idle', '5', false), "
                                  "set_config('tcp_keepalives_interval', '2', false), "
                                  "set_config('tcp_keepalives_count', '3', false), "
                                  "set_config('tcp_user_timeout', '10000', false), "
                                  "set_config('synchronous_commit', replace(current_setting('synchronous_commit'), "
                                  "'off', 'on'), false)")
                       .arg(m_patience.count()),
                   "set it up");
}

bool Database::answers() const
{
    return !m_address.isServer() || (handle().isOpen() && ask(handle(), "SELECT 1", "ask it").has_value());
}

Database::~Database()
{
    {
        QSqlDatabase db = handle();
        db.close();
    }
    QSqlDatabase::removeDatabase(m_connection);
}

}  // namespace database::sql
