// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/sql/Dialect.h"

#include <QFileInfo>
#include <QRegularExpression>
#include <QSqlDriver>
#include <QSqlQuery>
#include <QUrl>
#include <QVariant>

#include "database/Address.h"
#include "database/sql/Statement.h"

namespace database::sql::dialect {
namespace {

using core::ErrorCode;

// Primary result codes of SQLite (sqlite.org/rescode.html). They are in the lowest eight bits.
constexpr int kBusy = 5;
constexpr int kLocked = 6;
constexpr int kReadOnly = 8;
constexpr int kIoError = 10;
constexpr int kCorrupt = 11;
constexpr int kFull = 13;
constexpr int kCannotOpen = 14;
constexpr int kConstraint = 19;
constexpr int kNotADatabase = 26;
constexpr int kNoRoomForShm = 4874;  // SQLITE_IOERR_SHMSIZE

const std::string kNumber = "go on with its numbers";

/// Number of the lock for migrations, "CUSP": unlikely to be used by any other program.
constexpr int kSchemaLock = kApplicationId;

core::Error sqliteError(const std::string& head, const QSqlError& error)
{
    // Qt adds texts without information.
    QString words = error.databaseText();
    words.remove(QStringLiteral("Unable to execute statement")).remove(QStringLiteral("Unable to fetch row"));
    const std::string said = words.simplified().toStdString();
    const int code = error.nativeErrorCode().toInt();
    // The disk is full: SQLite cannot extend the shared-memory file (sqlite.org/rescode.html, 4874).
    if (code == kNoRoomForShm)
        return {ErrorCode::FileUnwritable, head + "the disk is full; free some space and try again"};
    switch (code & 0xFF) {
    case kBusy:
    case kLocked:
        return {ErrorCode::Busy,
                head + "another program is writing to it; close that program or try again in a moment"};
    case kReadOnly:
        return {ErrorCode::FileUnwritable,
                head +
                    "the file or its folder is read-only; make it writable, or copy it, with what lies beside it, to "
                    "another place and choose it there"};
    case kFull:
        return {ErrorCode::FileUnwritable, head + "the disk is full; free some space and try again"};
    case kCannotOpen:
        return {ErrorCode::FileUnwritable,
                head + "the file cannot be opened or created there; choose a folder that exists and is writable"};
    case kCorrupt:
        return {ErrorCode::BadStructure, head + "the file is damaged; restore a backup of it"};
    case kNotADatabase:
        return {ErrorCode::WrongKind, head + "the file is not a database; choose another file"};
    case kIoError:
        return {ErrorCode::FileUnwritable, head + "the disk did not answer (" + said + "); check the disk"};
    case kConstraint:
        return {ErrorCode::OutOfRange, head + "a value is not allowed (" + said + "); correct it"};
    default:
        return {ErrorCode::BadStructure, head + "the database answered: " + said + "; restore a backup if it persists"};
    }
}

/// Returns the error for a code of PostgreSQL's manual, appendix A: two characters for the class, three for the case.
core::Error postgresError(const std::string& head, const QSqlError& error, bool isOpen)
{
    const QString code = error.nativeErrorCode();
    // Qt appends the code to the text.
    QString words = error.databaseText().simplified();
    if (const QString end = '(' + code + ')'; words.endsWith(end))
        words.chop(end.size());
    // Where in a function of the server it happened says nothing to a user.
    const std::string said = words.section(QStringLiteral(" CONTEXT: "), 0, 0).trimmed().toStdString();
    const bool isConnecting = error.type() == QSqlError::ConnectionError;
    const auto is = [&code](const char* begin) { return code.startsWith(QLatin1String(begin)); };
    if (said.find("role \"") != std::string::npos && said.find("does not exist") != std::string::npos)
        return {ErrorCode::ServerRefuses,
                head + "the server knows no such user; create it with createuser, or correct the name"};
    if (is("57P03") || said.find("starting up") != std::string::npos ||
        said.find("shutting down") != std::string::npos || said.find("recovery mode") != std::string::npos)
        return {ErrorCode::ConnectionLost, head + "the server is starting or stopping; try again in a moment"};
    if (is("28") || said.find("password authentication failed") != std::string::npos ||
        said.find("no password supplied") != std::string::npos)
        return {ErrorCode::ServerRefuses,
                head + "the server does not let this user in (" + said + "); check the user and ~/.pgpass"};
    if (is("3D") || (said.find("database \"") != std::string::npos && said.find("does not exist") != std::string::npos))
        return {ErrorCode::ServerRefuses,
                head + "the server has no such database; create it with createdb, or correct the name"};
    if (isConnecting &&
        (said.find("too many c") != std::string::npos || said.find("connection slots") != std::string::npos))
        return {ErrorCode::ServerRefuses, head + "the server has no connection left (" + said +
                                              "); try again in a moment, or let its administrator allow more"};
    // libpq, not the server, has ended the connection.
    if (isConnecting && said.find("FATAL") == std::string::npos &&
        (said.find("SSL") != std::string::npos || said.find("certificate") != std::string::npos))
        return {ErrorCode::ServerUnknown,
                head + "the server cannot prove that it is the right one, or cannot encrypt the connection (" + said +
                    "); set up its certificate as docs/security.md shows, or ask for less with ?sslmode="};
    // The server has refused the connection. On an existing connection, it only reports that it terminates.
    if (isConnecting && said.find("FATAL") != std::string::npos &&
        said.find("terminating connection") == std::string::npos)
        return {ErrorCode::ServerRefuses,
                head + "the server refuses the connection (" + said + "); let its administrator allow it"};
    // An error without a code comes from libpq, not from the server: the connection is lost or was never made. 25P03:
    // this station was idle for too long in a transaction.
    if (code.isEmpty() || is("08") || is("57P") || is("25P03") || !isOpen)
        return {ErrorCode::ConnectionLost, head + "the server does not answer" +
                                               (isConnecting && !said.empty() ? " (" + said + ")" : std::string()) +
                                               "; check the network and that the server runs"};
    if (is("23") || is("22") || is("54"))
        return {ErrorCode::OutOfRange, head + "a value is not allowed (" + said + "); correct it"};
    if (is("42501") || is("25006"))
        return {ErrorCode::ServerRefuses, head + "this user of the server may not do that there (" + said +
                                              "); let the server's administrator grant it"};
    if (is("53"))
        return {ErrorCode::ServerRefuses,
                head + "the server has no room left (" + said + "); free some disk there and try again"};
    // The administrator of the server, or a time limit, has cancelled the query.
    if (is("57014"))
        return {ErrorCode::Busy,
                head + "the server has stopped it (" + said + "); try again, or let its administrator allow more time"};
    if (is("55P03") || is("40"))
        return {ErrorCode::Busy, head + "another station is writing to it; try again in a moment, and if it stays so, "
                                        "let the server's administrator see who has locked it (pg_locks)"};
    if (is("XX"))
        return {ErrorCode::ServerRefuses, head + "the server found damage (" + said + "); restore a backup of it"};
    return {ErrorCode::ServerRefuses,
            head + "the server answered: " + said + "; let the server's administrator look at it"};
}

/// Returns the SQL of triggers that make UPDATE, DELETE and TRUNCATE fail.
QString appendOnly(bool postgres, const QString& table)
{
    if (!postgres)
        return QStringLiteral("CREATE TRIGGER %1_no_update BEFORE UPDATE ON %1 BEGIN SELECT "
                              "RAISE(ABORT, '%1 is append-only'); END;\n"
                              "CREATE TRIGGER %1_no_delete BEFORE DELETE ON %1 BEGIN SELECT "
                              "RAISE(ABORT, '%1 is append-only'); END;")
            .arg(table);
    return QStringLiteral(
               "CREATE FUNCTION %1_is_append_only() RETURNS trigger LANGUAGE plpgsql AS "
               "$$ BEGIN RAISE EXCEPTION '%1 is append-only' USING ERRCODE = 'integrity_constraint_violation'; "
               "END $$;\n"
               "CREATE TRIGGER %1_no_change BEFORE UPDATE OR DELETE OR TRUNCATE ON %1 "
               "FOR EACH STATEMENT EXECUTE FUNCTION %1_is_append_only();")
        .arg(table);
}

/// Returns SQL that replaces the triggers of appendOnly() by ones that let rows change if a condition is met.
QString letChange(bool postgres, const QString& table, const QString& condition)
{
    if (!postgres)
        return QStringLiteral("DROP TRIGGER %1_no_update;\n"
                              "CREATE TRIGGER %1_no_update BEFORE UPDATE ON %1 WHEN NOT (%2) BEGIN SELECT "
                              "RAISE(ABORT, '%1 is append-only'); END;")
            .arg(table, condition);
    return QStringLiteral("DROP TRIGGER %1_no_change ON %1;\n"
                          "CREATE TRIGGER %1_no_change BEFORE DELETE OR TRUNCATE ON %1 FOR EACH STATEMENT EXECUTE "
                          "FUNCTION %1_is_append_only();\n"
                          "CREATE FUNCTION %1_may_change() RETURNS trigger LANGUAGE plpgsql AS $$ BEGIN IF %2 THEN "
                          "RETURN new; END IF; RAISE EXCEPTION '%1 is append-only' USING ERRCODE = "
                          "'integrity_constraint_violation'; END $$;\n"
                          "CREATE TRIGGER %1_no_update BEFORE UPDATE ON %1 FOR EACH ROW EXECUTE FUNCTION "
                          "%1_may_change();")
        .arg(table, condition);
}

/// Returns a statement that takes a lock until the transaction ends. Unlike with a row lock, stations get it in the
/// order in which they asked. A station that stops while it has the lock (a closed laptop) loses the lock and its
/// connection before the others time out.
QString lockAsProgram(const QSqlDatabase& db, const QString& lock)
{
    constexpr int kLongestPauseMs = 3000;
    // One statement, because Qt reports only the error of the first of several.
    return isPostgres(db) ? QStringLiteral("DO $$ BEGIN PERFORM set_config('idle_in_transaction_session_timeout', "
                                           "'%1', true); %2; END $$")
                                .arg(kLongestPauseMs)
                                .arg(lock)
                          : QString();
}

/// Returns a statement that locks a table but lets others read and write it. Anyone who may connect could take a lock
/// on a number, but users with read permission only cannot lock a table.
QString lockTable(const char* table)
{
    return QStringLiteral("LOCK TABLE %1 IN SHARE UPDATE EXCLUSIVE MODE").arg(QLatin1String(table));
}

/// Property of the driver of a connection.
constexpr const char* kIsStation = "cuspIsStation";

}  // namespace

bool isPostgres(const QSqlDatabase& db)
{
    return db.driverName() == u"QPSQL";
}

QString expand(const QSqlDatabase& db, QString sql)
{
    const bool postgres = isPostgres(db);
    // AUTOINCREMENT never assigns an id twice, not even after its row was deleted.
    sql.replace("{row_id}",
                postgres ? "BIGINT GENERATED BY DEFAULT AS IDENTITY PRIMARY KEY" : "INTEGER PRIMARY KEY AUTOINCREMENT")
        .replace("{int64}", postgres ? "BIGINT" : "INTEGER")
        .replace("{blob}", postgres ? "BYTEA" : "BLOB")
        .replace(" {table_options}", postgres ? "" : " STRICT");
    static const QRegularExpression kAppendOnly(QStringLiteral(R"(\{append_only (\w+)\};)"));
    for (auto found = kAppendOnly.match(sql); found.hasMatch(); found = kAppendOnly.match(sql))
        sql.replace(found.capturedStart(), found.capturedLength(), appendOnly(postgres, found.captured(1)));
    static const QRegularExpression kLetChange(QStringLiteral(R"(\{let_change (\w+): ([^}]+)\};)"));
    for (auto found = kLetChange.match(sql); found.hasMatch(); found = kLetChange.match(sql))
        sql.replace(found.capturedStart(), found.capturedLength(),
                    letChange(postgres, found.captured(1), found.captured(2).simplified()));
    return sql;
}

QString beginWrite(const QSqlDatabase& db)
{
    return isPostgres(db) ? QStringLiteral("BEGIN") : QStringLiteral("BEGIN IMMEDIATE");
}

QString beginRead(const QSqlDatabase& db)
{
    return isPostgres(db) ? QStringLiteral("BEGIN ISOLATION LEVEL REPEATABLE READ READ ONLY") : QStringLiteral("BEGIN");
}

QString forUpdate(const QSqlDatabase& db)
{
    return isPostgres(db) ? QStringLiteral(" FOR UPDATE") : QString();
}

QString lockSchema(const QSqlDatabase& db, bool isThere)
{
    return lockAsProgram(db, isThere ? lockTable("cusp_schema")
                                     : QStringLiteral("PERFORM pg_advisory_xact_lock(%1)").arg(kSchemaLock));
}

QString lockTurn(const QSqlDatabase& db)
{
    return lockAsProgram(db, lockTable("audit_seal"));
}

core::Status pinSearchPath(const QSqlDatabase& db)
{
    const std::string doing = "set it up";
    // Until the path is set, all names and operators need their schema, even those that compare. PostgreSQL searches
    // pg_catalog first unless the path names it; pg_temp, for temporary objects, comes last.
    if (auto pinned = execute(
            db,
            "SELECT pg_catalog.set_config('search_path', COALESCE(COALESCE((SELECT pg_catalog.quote_ident(n.nspname) "
            "FROM pg_catalog.pg_class c JOIN pg_catalog.pg_namespace n ON n.oid OPERATOR(pg_catalog.=) c.relnamespace "
            "WHERE c.relname OPERATOR(pg_catalog.=) 'cusp_schema' AND pg_catalog.pg_table_is_visible(c.oid)), "
            "pg_catalog.quote_ident(pg_catalog.current_schema())) OPERATOR(pg_catalog.||) ', pg_temp', ''), false)",
            doing);
        !pinned)
        return pinned;
    const auto first = ask(db, "SELECT (pg_catalog.current_schemas(true))[1]", doing);
    if (!first)
        return tl::unexpected(first.error());
    if (first->toString() == u"pg_catalog")
        return {};
    return core::unexpected(ErrorCode::WrongKind,
                            "database " + nameOf(db) + ": the server looks for its own functions in " +
                                first->toString().toStdString() + " first; let its administrator look at search_path");
}

core::Status recognizeStation(const QSqlDatabase& db)
{
    const auto found =
        ask(db,
            "SELECT CASE WHEN EXISTS (SELECT 1 FROM pg_proc WHERE proname = 'cusp_person' AND pronamespace = "
            "c.relnamespace) AND NOT pg_has_role(c.relowner, 'USAGE') THEN 1 ELSE 0 END FROM pg_class c JOIN "
            "pg_namespace n ON n.oid = c.relnamespace WHERE c.relname = 'people' AND n.nspname = current_schema()",
            "see what this account may do");
    if (!found)
        return tl::unexpected(found.error());
    db.driver()->setProperty(kIsStation, found->toInt() == 1);
    return {};
}

bool isStation(const QSqlDatabase& db)
{
    return db.driver()->property(kIsStation).toBool();
}

core::Result<int> schemaVersion(const QSqlDatabase& db)
{
    const std::string doing = "read the schema version";
    if (isPostgres(db)) {
        // Reads the catalogue, because to_regclass() may return a cached result from before another program created the
        // table.
        const auto marked =
            ask(db,
                "SELECT 1 FROM pg_catalog.pg_class c JOIN pg_catalog.pg_namespace n ON n.oid = "
                "c.relnamespace WHERE c.relname = 'cusp_schema' AND n.nspname = ANY (current_schemas(false))",
                doing);
        if (!marked)
            return tl::unexpected(marked.error());
        if (marked->isNull())
            return 0;
    }
    const auto version =
        ask(db, isPostgres(db) ? "SELECT max(version) FROM cusp_schema" : "PRAGMA user_version", doing);
    if (!version)
        return tl::unexpected(version.error());
    return version->toInt();
}

core::Status setSchemaVersion(const QSqlDatabase& db, int version)
{
    const std::string doing = "note the schema version";
    if (!isPostgres(db))
        return execute(db, QStringLiteral("PRAGMA user_version = %1").arg(version), doing);
    if (auto made = execute(db, "CREATE TABLE IF NOT EXISTS cusp_schema (version INTEGER NOT NULL UNIQUE)", doing);
        !made)
        return made;
    return execute(db, "INSERT INTO cusp_schema VALUES (?)", doing, {version});
}

core::Result<int> countTables(const QSqlDatabase& db)
{
    const auto count = ask(db,
                           isPostgres(db) ? "SELECT count(*) FROM pg_tables WHERE schemaname = current_schema()"
                                          : "SELECT count(*) FROM sqlite_master",
                           "open it");
    if (!count)
        return tl::unexpected(count.error());
    return count->toInt();
}

core::Status continueIds(const QSqlDatabase& db, const QString& table)
{
    const QString goOn =
        isPostgres(db) ? QStringLiteral("SELECT setval(pg_get_serial_sequence('%1', 'id'), greatest(1, max(id)), "
                                        "max(id) IS NOT NULL) FROM %1")
                       : QStringLiteral("UPDATE sqlite_sequence SET seq = (SELECT COALESCE(MAX(id), 0) FROM %1) WHERE "
                                        "name = '%1'");
    return execute(db, goOn.arg(table), kNumber);
}

core::Status overwriteUnused(const QSqlDatabase& db)
{
    const std::string doing = "overwrite its unused parts";
    if (isPostgres(db))
        return {};
    // secure_delete overwrites a deleted row, but not the copies that stay behind when rows move to another page.
    if (auto done = execute(db, "VACUUM", doing); !done)
        return done;
    const auto isBusy = ask(db, "PRAGMA wal_checkpoint(TRUNCATE)", doing);
    if (!isBusy)
        return tl::unexpected(isBusy.error());
    if (isBusy->toInt() != 0)
        return core::unexpected(ErrorCode::Busy, "database " + nameOf(db) + ": could not " + doing +
                                                     ", another program is reading it; close that program");
    return {};
}

QString uriOf(const QString& file, bool isImmutable)
{
    QUrl url = QUrl::fromLocalFile(QFileInfo(file).absoluteFilePath());
    if (isImmutable)
        url.setQuery(QStringLiteral("immutable=1"));
    return url.toString(QUrl::FullyEncoded);
}

QString fileOf(const QSqlDatabase& db)
{
    const QString name = db.databaseName();
    return name.startsWith(QStringLiteral("file:")) ? QUrl(name).toLocalFile() : name;
}

std::string nameOf(const QSqlDatabase& db)
{
    if (!isPostgres(db))
        return fileOf(db).toStdString();
    Address address;
    address.host = db.hostName();
    address.port = db.port();
    address.user = db.userName();
    address.name = db.databaseName();
    return address.shown().toStdString();
}

core::Error error(const QSqlDatabase& db, const QSqlError& error, const std::string& doing)
{
    const std::string head = "database " + nameOf(db) + ": could not " + doing + ", ";
    return isPostgres(db) ? postgresError(head, error, db.isOpen()) : sqliteError(head, error);
}

}  // namespace database::sql::dialect
