// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/sql/Database.h"

#include <atomic>

#include <QFile>
#include <QFileInfo>
#include <QSqlQuery>
#include <QVariant>

#include "database/sql/Dialect.h"
#include "database/sql/Migrations.h"

namespace database::sql {
namespace {

using core::ErrorCode;

std::string head(const QString& path)
{
    return "database " + path.toStdString() + ": ";
}

/// What can be said about the path without SQLite, which would only say that it "cannot open" it.
core::Status inspect(const QString& path)
{
    const QFileInfo info(path);
    if (info.isDir())
        return core::unexpected(ErrorCode::FileUnreadable, head(path) + "this is a folder; name a file inside it");
    if (!info.exists()) {
        if (!QFileInfo(info.absolutePath()).isDir())
            return core::unexpected(ErrorCode::FileMissing,
                                    head(path) + "the folder does not exist; create it or choose another place");
        return {};
    }
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return core::unexpected(ErrorCode::FileUnreadable, head(path) + "it cannot be read (" +
                                                               file.errorString().toStdString() +
                                                               "); check who may read it");
    const QByteArray start = file.read(16);
    if (!start.isEmpty() && start != QByteArray("SQLite format 3", 16))
        return core::unexpected(ErrorCode::WrongKind, head(path) + "the file is not a database; choose another file");
    return {};
}

core::Result<QVariant> ask(QSqlDatabase& db, const QString& sql, const std::string& doing)
{
    QSqlQuery query(db);
    if (!query.exec(sql))
        return tl::unexpected(dialect::error(db, query.lastError(), doing));
    return query.next() ? query.value(0) : QVariant();
}

/// Checks whose file this is and that it is whole, before anything is written to it.
core::Status examine(QSqlDatabase& db)
{
    const std::string doing = "open it";
    const auto application = ask(db, "PRAGMA application_id", doing);
    if (!application)
        return tl::unexpected(application.error());
    const auto tables = ask(db, "SELECT count(*) FROM sqlite_master", doing);
    if (!tables)
        return tl::unexpected(tables.error());
    const bool ours = application->toInt() == dialect::kApplicationId;
    const bool blank = application->toInt() == 0 && tables->toInt() == 0;
    if (!ours && !blank)
        return core::unexpected(ErrorCode::WrongKind,
                                head(db.databaseName()) +
                                    "this database belongs to another program; choose another file");
    const auto whole = ask(db, "PRAGMA quick_check(1)", doing);
    if (!whole)
        return tl::unexpected(whole.error());
    if (whole->toString() != "ok")
        return core::unexpected(ErrorCode::BadStructure, head(db.databaseName()) + "the file is damaged (" +
                                                             whole->toString().toStdString() +
                                                             "); restore a backup of it");
    return {};
}

core::Status configure(QSqlDatabase& db)
{
    // synchronous=FULL: with a write-ahead log NORMAL may lose the last commits when the power fails.
    const QStringList settings{"PRAGMA journal_mode = WAL",
                               "PRAGMA synchronous = FULL",
                               "PRAGMA foreign_keys = ON",
                               "PRAGMA trusted_schema = OFF",
                               "PRAGMA cell_size_check = ON",
                               "PRAGMA secure_delete = ON",
                               QStringLiteral("PRAGMA application_id = %1").arg(dialect::kApplicationId)};
    for (const QString& setting : settings)
        if (const auto done = ask(db, setting, "set it up"); !done)
            return tl::unexpected(done.error());
    return {};
}

}  // namespace

core::Result<std::unique_ptr<Database>> Database::open(const QString& path, std::chrono::milliseconds patience)
{
    if (auto fit = inspect(path); !fit)
        return tl::unexpected(fit.error());

    static std::atomic<int> opened{0};
    const QString connection = QStringLiteral("cusp-%1").arg(opened.fetch_add(1));
    std::unique_ptr<Database> database(new Database(connection));
    QSqlDatabase db = QSqlDatabase::addDatabase("QSQLITE", connection);
    db.setDatabaseName(path);
    db.setConnectOptions(QStringLiteral("QSQLITE_BUSY_TIMEOUT=%1").arg(patience.count()));
    if (!db.open())
        return tl::unexpected(dialect::error(db, db.lastError(), "open it"));
    if (auto fit = examine(db); !fit)
        return tl::unexpected(fit.error());
    const auto steps = shippedMigrations();
    if (!steps)
        return tl::unexpected(steps.error());
    const auto version = dialect::schemaVersion(db);
    if (!version)
        return tl::unexpected(version.error());
    // A file from the future is refused before its settings are touched.
    if (*version <= static_cast<int>(steps->size()))
        if (auto set = configure(db); !set)
            return tl::unexpected(set.error());
    if (auto current = migrate(db, *steps); !current)
        return tl::unexpected(current.error());
    return database;
}

Database::~Database()
{
    handle().close();
    QSqlDatabase::removeDatabase(m_connection);
}

}  // namespace database::sql
