// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/sql/Statement.h"

#include <QSqlError>
#include <QSqlRecord>

namespace database::sql {

core::Result<QSqlQuery> run(const QSqlDatabase& db, const QString& sql, const std::string& doing,
                            const QVariantList& values)
{
    // Qt would warn of it, and say no more.
    if (!db.isOpen())
        return tl::unexpected(dialect::error(db, QSqlError(), doing));
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
