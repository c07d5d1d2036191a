// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/sql/Dialect.h"

#include <QSqlQuery>
#include <QVariant>

namespace database::sql::dialect {
namespace {

// Primary result codes of SQLite (sqlite.org/rescode.html); the bits above the lowest eight only refine them.
constexpr int kBusy = 5;
constexpr int kLocked = 6;
constexpr int kReadOnly = 8;
constexpr int kIoError = 10;
constexpr int kCorrupt = 11;
constexpr int kFull = 13;
constexpr int kCannotOpen = 14;
constexpr int kConstraint = 19;
constexpr int kNotADatabase = 26;

}  // namespace

QString expand(QString sql)
{
    // AUTOINCREMENT: an id is never given out twice, not even after its row was deleted.
    return sql.replace("{row_id}", "INTEGER PRIMARY KEY AUTOINCREMENT")
        .replace("{int64}", "INTEGER")
        .replace("{table_options}", "STRICT");
}

QString beginWrite()
{
    return QStringLiteral("BEGIN IMMEDIATE");
}

core::Result<int> schemaVersion(QSqlDatabase& db)
{
    QSqlQuery query(db);
    if (!query.exec("PRAGMA user_version") || !query.next())
        return tl::unexpected(error(db, query.lastError(), "read the schema version"));
    return query.value(0).toInt();
}

core::Status setSchemaVersion(QSqlDatabase& db, int version)
{
    QSqlQuery query(db);
    if (!query.exec(QStringLiteral("PRAGMA user_version = %1").arg(version)))
        return tl::unexpected(error(db, query.lastError(), "note the schema version"));
    return {};
}

core::Error error(const QSqlDatabase& db, const QSqlError& error, const std::string& doing)
{
    const std::string head = "database " + db.databaseName().toStdString() + ": could not " + doing + ", ";
    switch (error.nativeErrorCode().toInt() & 0xFF) {
    case kBusy:
    case kLocked:
        return {core::ErrorCode::FileUnwritable,
                head + "another program is writing to it; close that program or try again in a moment"};
    case kReadOnly:
        return {core::ErrorCode::FileUnwritable,
                head + "the file or its folder is read-only; make it writable or choose another place"};
    case kFull:
        return {core::ErrorCode::FileUnwritable, head + "the disk is full; free some space and try again"};
    case kCannotOpen:
        return {core::ErrorCode::FileUnwritable,
                head + "the file cannot be opened or created there; choose a folder that exists and is writable"};
    case kCorrupt:
        return {core::ErrorCode::BadStructure, head + "the file is damaged; restore a backup of it"};
    case kNotADatabase:
        return {core::ErrorCode::WrongKind, head + "the file is not a database; choose another file"};
    case kIoError:
        return {core::ErrorCode::FileUnwritable,
                head + "the disk did not answer (" + error.databaseText().toStdString() + "); check the disk"};
    case kConstraint:
        return {core::ErrorCode::OutOfRange,
                head + "a value is not allowed (" + error.databaseText().toStdString() + "); correct it"};
    default:
        return {core::ErrorCode::BadStructure,
                head + "the database answered: " + error.text().toStdString() + "; restore a backup if it persists"};
    }
}

}  // namespace database::sql::dialect
