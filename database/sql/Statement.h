// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include <QSqlDatabase>
#include <QSqlQuery>
#include <QString>
#include <QVariant>

#include "core/base/Result.h"
#include "database/sql/Dialect.h"

namespace database::sql {

/// Runs a statement with bound values. The error contains `doing`: "could not add the attempt".
[[nodiscard]] core::Result<QSqlQuery> run(const QSqlDatabase& db, const QString& sql, const std::string& doing,
                                          const QVariantList& values = {});
/// Runs a statement without a result.
[[nodiscard]] core::Status execute(const QSqlDatabase& db, const QString& sql, const std::string& doing,
                                   const QVariantList& values = {});
/// Runs a statement and returns the first value of the first row; null if there is no row.
[[nodiscard]] core::Result<QVariant> ask(const QSqlDatabase& db, const QString& sql, const std::string& doing,
                                         const QVariantList& values = {});
/// Runs a statement and calls `row` for each row. A damaged page is reported as an error, not as the end of the rows.
[[nodiscard]] core::Status forEach(const QSqlDatabase& db, const QString& sql, const std::string& doing,
                                   const QVariantList& values, const std::function<void(const QSqlQuery&)>& row);

/// Returns a text in the form in which it must be bound: an empty std::string becomes '', but a null QString would
/// become NULL.
[[nodiscard]] QVariant text(const std::string& utf8);
[[nodiscard]] inline QVariant number(std::int64_t value)
{
    return QVariant::fromValue<qlonglong>(value);
}
[[nodiscard]] std::string textOf(const QSqlQuery& row, int column);
/// Returns the values from a column to the last one.
[[nodiscard]] QVariantList valuesOf(const QSqlQuery& row, int first);

/// Commits a transaction. If the server is lost before it confirms the commit, queries the outcome on new connections,
/// for ten seconds at most; if it stays unknown, returns OutcomeUnknown. ConnectionLost if it was rolled back. This
/// connection is lost in either case.
[[nodiscard]] core::Status commit(const QSqlDatabase& db, const std::string& doing);

/// Runs `work` inside a writing transaction. Commits it if `work` succeeds, and rolls it back otherwise.
/// @param work  returns a core::Result or core::Status
template <class Work>
auto inTransaction(const QSqlDatabase& db, const std::string& doing, Work work) -> decltype(work())
{
    if (auto begun = execute(db, dialect::beginWrite(db), doing); !begun)
        return tl::unexpected(begun.error());
    auto done = work();
    if (done) {
        if (auto kept = commit(db, doing); !kept)
            done = tl::unexpected(kept.error());
    }
    // Returns the first error. If the rollback fails, the connection is lost anyway.
    if (!done)
        static_cast<void>(execute(db, QStringLiteral("ROLLBACK"), doing));
    return done;
}

}  // namespace database::sql
