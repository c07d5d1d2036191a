// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/sql/Migrations.h"

#include <QDir>
#include <QFile>

#include "database/sql/Dialect.h"
#include "database/sql/Grants.h"
#include "database/sql/Statement.h"

/// The resources of a static library must be requested by name, outside any namespace.
static void useMigrationResources()
{
    Q_INIT_RESOURCE(migrations);
}

namespace database::sql {
namespace {

/// Runs one step inside a transaction that is already open.
core::Status apply(const QSqlDatabase& db, const Migration& step, const std::string& doing)
{
    auto version = dialect::schemaVersion(db);
    if (!version)
        return tl::unexpected(version.error());
    if (const QString lock = dialect::lockSchema(db, *version > 0); !lock.isEmpty())
        if (auto locked = execute(db, lock, doing); !locked)
            return locked;
    // Another program may have migrated the database before we got the lock.
    version = dialect::schemaVersion(db);
    if (!version)
        return tl::unexpected(version.error());
    if (*version >= step.number)
        return {};
    if (auto suspended = suspendGrants(db); !suspended)
        return suspended;
    for (const QString& statement : statementsOf(dialect::expand(db, step.sql)))
        if (auto done = execute(db, statement, doing); !done)
            return done;
    return dialect::setSchemaVersion(db, step.number);
}

}  // namespace

QStringList statementsOf(const QString& sql)
{
    QStringList statements;
    QString statement;
    bool isQuoted = false;
    for (const QString& line : sql.split('\n')) {
        if (line.trimmed().startsWith("--"))
            continue;
        statement += line + '\n';
        if (line.count(QStringLiteral("$$")) % 2 != 0)
            isQuoted = !isQuoted;
        if (!isQuoted && line.trimmed().endsWith(';')) {
            statements += statement.trimmed().chopped(1);
            statement.clear();
        }
    }
    if (!statement.trimmed().isEmpty())
        statements += statement.trimmed();
    return statements;
}

core::Result<std::vector<Migration>> shippedMigrations()
{
    useMigrationResources();
    std::vector<Migration> steps;
    const QDir folder(QStringLiteral(":/migrations"));
    for (const QString& name : folder.entryList({QStringLiteral("*.sql")}, QDir::Files, QDir::Name)) {
        QFile file(folder.filePath(name));
        const int number = name.section('_', 0, 0).toInt();
        if (!file.open(QIODevice::ReadOnly) || number != static_cast<int>(steps.size()) + 1)
            return core::unexpected(core::ErrorCode::BadStructure, "migration " + name.toStdString() +
                                                                       " inside this program is unreadable or out of "
                                                                       "order; install the program again");
        steps.push_back({number, QString::fromUtf8(file.readAll())});
    }
    return steps;
}

core::Status applyAll(const QSqlDatabase& db, std::span<const Migration> steps)
{
    for (const Migration& step : steps)
        if (auto done = apply(db, step, "make a schema"); !done)
            return done;
    return {};
}

core::Status migrate(const QSqlDatabase& db, std::span<const Migration> steps)
{
    const auto version = dialect::schemaVersion(db);
    if (!version)
        return tl::unexpected(version.error());
    const int newest = steps.empty() ? 0 : steps.back().number;
    if (*version > newest)
        return core::unexpected(core::ErrorCode::NewerVersion,
                                "database " + dialect::nameOf(db) + ": it was written by a later program (schema " +
                                    std::to_string(*version) + ", this program knows " + std::to_string(newest) +
                                    "); use that program, nothing was changed");
    for (const Migration& step : steps) {
        if (step.number <= *version)
            continue;
        const std::string doing = "bring it to schema " + std::to_string(step.number);
        if (auto done = inTransaction(db, doing, [&] { return apply(db, step, doing); }); !done)
            return done;
    }
    return renewGrants(db);
}

}  // namespace database::sql
