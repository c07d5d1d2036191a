// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/sql/Statement.h"

#include <cassert>
#include <optional>

#include <QDeadlineTimer>
#include <QSqlDriver>
#include <QSqlError>
#include <QSqlRecord>
#include <QThread>

namespace database::sql {
namespace {

constexpr int kOutcomePatienceMs = 10'000;
constexpr unsigned long kOutcomeRestMs = 200;

/// Returns whether a transaction was committed, if the server was lost before it confirmed the commit (PostgreSQL's
/// manual, "Transaction ID and Snapshot Information Functions"). Empty if that is unknown.
std::optional<bool> wasKept(const QSqlDatabase& lost, const QVariant& transaction)
{
    const QString name = lost.connectionName() + QStringLiteral(", how it ended");
    std::optional<bool> kept;
    for (QDeadlineTimer patience(kOutcomePatienceMs); !kept && !patience.hasExpired();) {
        {
            QSqlDatabase db = QSqlDatabase::cloneDatabase(lost, name);
            const auto said = db.open() ? ask(db, QStringLiteral("SELECT txid_status(?)"), "ask", {transaction})
                                        : core::Result<QVariant>(QVariant());
            const QString how = said ? said->toString() : QString();
            if (how == u"committed" || how == u"aborted")  // otherwise it is still in progress
                kept = how == u"committed";
        }
        QSqlDatabase::removeDatabase(name);
        if (!kept)
            QThread::msleep(kOutcomeRestMs);
    }
    return kept;
}

}  // namespace

core::Result<QSqlQuery> run(const QSqlDatabase& db, const QString& sql, const std::string& doing,
                            const QVariantList& values)
{
    // On a closed connection, Qt would only print a warning.
    if (!db.isOpen())
        return tl::unexpected(dialect::error(db, QSqlError(), doing));
    assert(db.driver()->thread() == QThread::currentThread());
    QSqlQuery query(db);
    query.setForwardOnly(true);
    bool done = false;
    if (values.isEmpty()) {
        done = query.exec(sql);
    } else {
        done = query.prepare(sql);
        for (const QVariant& value : values)
            query.addBindValue(value);
        done = done && query.exec();
    }
    if (!done)
        return tl::unexpected(dialect::error(db, query.lastError(), doing));
    return query;
}

core::Status execute(const QSqlDatabase& db, const QString& sql, const std::string& doing, const QVariantList& values)
{
    const auto done = run(db, sql, doing, values);
    return done ? core::Status() : core::Status(tl::unexpected(done.error()));
}

core::Status commit(const QSqlDatabase& db, const std::string& doing)
{
    const QString end = QStringLiteral("COMMIT");
    if (!dialect::isPostgres(db))
        return execute(db, end, doing);
    const auto transaction = ask(db, QStringLiteral("SELECT txid_current_if_assigned()"), doing);
    if (!transaction)
        return tl::unexpected(transaction.error());
    core::Status done = execute(db, end, doing);
    if (done || done.error().code != core::ErrorCode::ConnectionLost || transaction->isNull())
        return done;
    const auto kept = wasKept(db, *transaction);
    if (!kept)
        return core::unexpected(core::ErrorCode::OutcomeUnknown,
                                done.error().detail + "; whether it was done nobody can say: look when the server "
                                                      "answers again, before you do it again");
    return *kept ? core::Status() : done;
}

core::Result<QVariant> ask(const QSqlDatabase& db, const QString& sql, const std::string& doing,
                           const QVariantList& values)
{
    auto query = run(db, sql, doing, values);
    if (!query)
        return tl::unexpected(query.error());
    if (query->next())
        return query->value(0);
    if (query->lastError().isValid())
        return tl::unexpected(dialect::error(db, query->lastError(), doing));
    return QVariant();
}

core::Status forEach(const QSqlDatabase& db, const QString& sql, const std::string& doing, const QVariantList& values,
                     const std::function<void(const QSqlQuery&)>& row)
{
    auto query = run(db, sql, doing, values);
    if (!query)
        return tl::unexpected(query.error());
    while (query->next())
        row(*query);
    if (query->lastError().isValid())
        return tl::unexpected(dialect::error(db, query->lastError(), doing));
    return {};
}

QVariant text(const std::string& utf8)
{
    return utf8.empty() ? QStringLiteral("") : QString::fromStdString(utf8);
}

std::string textOf(const QSqlQuery& row, int column)
{
    return row.value(column).toString().toStdString();
}

QVariantList valuesOf(const QSqlQuery& row, int first)
{
    QVariantList values;
    for (int column = first; column < row.record().count(); ++column)
        values += row.value(column);
    return values;
}

}  // namespace database::sql
