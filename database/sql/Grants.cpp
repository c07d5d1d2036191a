// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/sql/Grants.h"

#include <QFile>
#include <QRegularExpression>

#include "database/Passwords.h"
#include "database/sql/Attempts.h"
#include "database/sql/Doubts.h"
#include "database/sql/Migrations.h"
#include "database/sql/Statement.h"
#include "lessons/ClassStanding.h"

/// The resources of a static library must be requested by name, outside any namespace.
static void useGrantsResource()
{
    Q_INIT_RESOURCE(grants);
}

namespace database::sql {
namespace {

using core::ErrorCode;

const std::string kGrant = "grant the rights of stations";

/// Returns the text of grants.sql, with the account and the expressions that it shares with the program.
core::Result<QString> filled(const QString& station)
{
    static const QRegularExpression kName(QStringLiteral("^[A-Za-z_][A-Za-z0-9_]{0,62}$"));
    if (!kName.match(station).hasMatch())
        return core::unexpected(ErrorCode::OutOfRange, "the name of an account on the server has ASCII letters, digits "
                                                       "and _, at most 63; choose another one");
    useGrantsResource();
    QFile file(QStringLiteral(":/sql/grants.sql"));
    if (!file.open(QIODevice::ReadOnly))
        return core::unexpected(ErrorCode::BadStructure, "the grants inside this program are unreadable; install the "
                                                         "program again");
    QString sql = QString::fromUtf8(file.readAll());
    for (const auto& [name, text] :
         {std::pair("{station}", '"' + station + '"'), std::pair("{name}", station),
          std::pair("{standings}", selectedStandings()), std::pair("{by_lesson}", groupedByLesson()),
          std::pair("{counts}", doesCount()), std::pair("{device}", comparedDevice(QStringLiteral("a.device"))),
          std::pair("{own_device}", comparedDevice(QStringLiteral("own.device"))),
          std::pair("{most_kib}", QString::number(kMostMemoryBytes / 1024)),
          std::pair("{most_passes}", QString::number(kMostPasses)),
          std::pair("{fewest}", QString::number(lessons::kFewestPeople))})
        sql.replace(QLatin1String(name), text);
    return sql;
}

}  // namespace

core::Result<QString> grantsFor(const QString& station)
{
    return filled(station).map(
        [](const QString& sql) { return QString("\\set ON_ERROR_STOP on\nBEGIN;\n\n" + sql + "\nCOMMIT;\n"); });
}

core::Status applyGrants(const QSqlDatabase& db, const QString& station)
{
    if (!dialect::isPostgres(db))
        return core::unexpected(ErrorCode::WrongKind, "database " + dialect::nameOf(db) +
                                                          ": a file has no accounts; rights are granted on a server");
    const auto sql = filled(station);
    if (!sql)
        return tl::unexpected(sql.error());
    return inTransaction(db, kGrant, [&]() -> core::Status {
        for (const QString& statement : statementsOf(*sql))
            if (auto done = execute(db, statement, kGrant); !done)
                return done;
        return {};
    });
}

core::Status suspendGrants(const QSqlDatabase& db)
{
    if (!dialect::isPostgres(db))
        return {};
    return execute(db,
                   "DO $$ DECLARE line text; BEGIN FOR line IN SELECT format('DROP POLICY %I ON %I', policyname, "
                   "tablename) FROM pg_policies WHERE schemaname = current_schema() AND starts_with(policyname::text, "
                   "'cusp_') LOOP EXECUTE line; END LOOP; END $$",
                   kGrant);
}

core::Status renewGrants(const QSqlDatabase& db)
{
    if (!dialect::isPostgres(db) || dialect::isStation(db))
        return {};
    const auto exists = ask(db, "SELECT to_regclass('cusp_grants')", kGrant);
    if (!exists)
        return tl::unexpected(exists.error());
    if (exists->isNull() || exists->toString().isEmpty())
        return {};
    const auto station =
        ask(db, "SELECT station FROM cusp_grants WHERE schema <> (SELECT max(version) FROM cusp_schema)", kGrant);
    if (!station)
        return tl::unexpected(station.error());
    return station->isNull() ? core::Status() : applyGrants(db, station->toString());
}

core::Status expectOwner(const QSqlDatabase& db, const std::string& command)
{
    if (!dialect::isStation(db))
        return {};
    return core::unexpected(ErrorCode::ServerRefuses,
                            "database " + dialect::nameOf(db) +
                                ": the account of a station may not read everything; run \"" + command +
                                " --db postgresql://OWNER@HOST/NAME\" with the account that owns the tables");
}

}  // namespace database::sql
