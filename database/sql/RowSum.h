// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include <QSqlDatabase>
#include <QSqlQuery>
#include <QStringList>

#include "core/base/Result.h"

namespace database::sql {

/// Computes the number of rows of a table and the sum of their hashes, independent of their order: 256 bits as four
/// numbers. Two tables with the same sum have the same rows.
class RowSum
{
public:
    /// @param columns  number of columns to include, from the first
    void add(const QSqlQuery& row, qsizetype columns);
    [[nodiscard]] std::int64_t rows() const { return m_rows; }
    bool operator==(const RowSum&) const = default;

private:
    std::array<std::uint64_t, 4> m_parts{};
    std::int64_t m_rows = 0;
};

/// Returns the columns of a table sorted by name, because their order may differ between engines or between files.
[[nodiscard]] QStringList columnsOf(const QSqlDatabase& db, const QString& table);

[[nodiscard]] core::Result<RowSum> sumOf(const QSqlDatabase& db, const QString& table);

}  // namespace database::sql
