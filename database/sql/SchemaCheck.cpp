// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/sql/SchemaCheck.h"

#include <map>

#include <QScopeGuard>

#include "database/sql/Dialect.h"
#include "database/sql/Migrations.h"
#include "database/sql/Statement.h"

namespace database::sql {
namespace {

const std::string kDoing = "check it";
const QString kFresh = QStringLiteral("cusp-fresh-schema-%1");

/// By "trigger audit_no_update", the statement that made it; of a server an empty one.
using Schema = std::map<std::string, std::string>;

core::Result<Schema> schemaOf(const QSqlDatabase& db)
{
    // What a constraint brings along has no statement, or a name that ends so.
    const QString question =
        dialect::isPostgres(db)
            ? QStringLiteral("SELECT 'trigger', t.tgname, '' FROM pg_trigger t JOIN pg_class c ON c.oid = t.tgrelid "
                             "WHERE NOT t.tgisinternal AND t.tgenabled <> 'D' AND c.relnamespace = "
                             "current_schema()::regnamespace UNION ALL SELECT 'index', i.indexname, '' FROM pg_indexes "
                             "i WHERE i.schemaname = current_schema() UNION ALL SELECT 'table', t.tablename, '' FROM "
                             "pg_tables t WHERE t.schemaname = current_schema()")
            : QStringLiteral("SELECT type, name, sql FROM sqlite_master WHERE sql IS NOT NULL AND name NOT LIKE "
                             "'sqlite\\_%' ESCAPE '\\'");
    Schema schema;
    if (auto read = forEach(db, question, kDoing, {},
                            [&](const QSqlQuery& row) {
                                QString made = row.value(2).toString();
                                // ALTER TABLE writes them anew, each release of SQLite in its own way.
                                made.remove(u'"').remove(u' ').remove(u'\n').remove(u'\t');
                                schema[textOf(row, 0) + ' ' + textOf(row, 1)] = made.toStdString();
                            });
        !read)
        return tl::unexpected(read.error());
    return schema;
}

/// Of a file that the migrations have just made.
core::Result<Schema> freshSchema()
{
    const QString name = kFresh.arg(quintptr(&name));
    const auto remove = qScopeGuard([&name] { QSqlDatabase::removeDatabase(name); });
    QSqlDatabase db = QSqlDatabase::addDatabase(QStringLiteral("QSQLITE"), name);
    db.setDatabaseName(QStringLiteral(":memory:"));
    if (!db.open())
        return tl::unexpected(dialect::error(db, db.lastError(), kDoing));
    const auto steps = shippedMigrations();
    if (!steps)
        return tl::unexpected(steps.error());
    if (auto made = migrate(db, *steps); !made)
        return tl::unexpected(made.error());
    return schemaOf(db);
}

/// Two triggers of a file are one on a server, see dialect::expand().
Schema asOnServer(const Schema& schema)
{
    Schema there;
    for (const auto& [named, made] : schema) {
        const auto guard = named.rfind("_no_update");
        if (guard != std::string::npos)
            there[named.substr(0, guard) + "_no_change"] = {};
        else if (named.rfind("_no_delete") == std::string::npos)
            there[named] = {};
    }
    return there;
}

}  // namespace

core::Status checkSchema(const QSqlDatabase& db, const std::function<void(const std::string&)>& say)
{
    const bool onServer = dialect::isPostgres(db);
    auto expected = freshSchema();
    const auto found = schemaOf(db);
    if (!expected || !found)
        return tl::unexpected(expected ? found.error() : expected.error());
    if (onServer)
        expected = asOnServer(*expected);
    for (const auto& [named, made] : *expected)
        if (const auto there = found->find(named); there == found->end())
            say("the " + named + " is no longer there: what it guarded is not guarded any more");
        else if (there->second != made)
            say("the " + named + " is not as this program makes it");
    for (const auto& [named, made] : *found)
        // Tables and indexes of others do no harm to ours; a trigger may.
        if (expected->count(named) == 0 && named.rfind("trigger ", 0) == 0)
            say("the " + named + " is not from this program: it may change what is written");
    return {};
}

}  // namespace database::sql
