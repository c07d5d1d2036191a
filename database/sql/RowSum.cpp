// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/sql/RowSum.h"

#include <cstring>

#include <QCryptographicHash>
#include <QSqlError>
#include <QSqlField>
#include <QSqlRecord>

#include "database/sql/Statement.h"

namespace database::sql {
void RowSum::add(const QSqlQuery& row, qsizetype columns)
{
    QCryptographicHash hash(QCryptographicHash::Blake2b_256);
    for (int k = 0; k < columns; ++k) {
        // The engines return different values for null.
        const QVariant value = row.value(k);
        const QByteArray bytes = row.isNull(k)                             ? QByteArray()
                                 : value.typeId() == QMetaType::QByteArray ? value.toByteArray()
                                                                           : value.toString().toUtf8();
        hash.addData(row.isNull(k) ? QByteArray("-") : QByteArray::number(bytes.size()) + ':');
        hash.addData(bytes);
    }
    const QByteArray digest = hash.result();
    for (std::size_t k = 0; k < m_parts.size(); ++k) {
        std::uint64_t part = 0;
        std::memcpy(&part, digest.constData() + k * sizeof part, sizeof part);
        m_parts.at(k) += part;
    }
    ++m_rows;
}

QStringList columnsOf(const QSqlDatabase& db, const QString& table)
{
    QStringList names;
    const QSqlRecord record = db.record(table);
    for (int k = 0; k < record.count(); ++k)
        names += record.fieldName(k);
    names.sort();
    return names;
}

core::Result<RowSum> sumOf(const QSqlDatabase& db, const QString& table)
{
    const QStringList columns = columnsOf(db, table);
    const std::string doing = "compare the table " + table.toStdString();
    auto rows = run(db, QStringLiteral("SELECT %1 FROM %2").arg(columns.join(u','), table), doing);
    if (!rows)
        return tl::unexpected(rows.error());
    RowSum sum;
    while (rows->next())
        sum.add(*rows, columns.size());
    if (rows->lastError().isValid())
        return tl::unexpected(dialect::error(db, rows->lastError(), doing));
    return sum;
}

}  // namespace database::sql
