// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include <QSqlDatabase>
#include <QSqlQuery>
#include <QStringList>

#include "core/base/Result.h"

namespace database::sql {

/// Of a table's rows in any order: how many there are, and the sum of their hashes, 256 bits as four numbers. Two
/// tables with the same sum hold the same rows.
class RowSum
{
public:
    /// @param columns  how many of the row count, from the first on
    void add(const QSqlQuery& row, qsizetype columns);
    [[nodiscard]] std::int64_t rows() const { return m_rows; }
    bool operator==(const RowSum&) const = default;

private:
    std::array<std::uint64_t, 4> m_parts{};
    std::int64_t m_rows = 0;
};

/// By name: two engines, or two ages of a file, need not agree on the order.
[[nodiscard]] QStringList columnsOf(const QSqlDatabase& db, const QString& table);

[[nodiscard]] core::Result<RowSum> sumOf(const QSqlDatabase& db, const QString& table);

}  // namespace database::sql
