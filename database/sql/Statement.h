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

/// Runs one statement with its values bound. `doing` goes into the sentence of a failure: "could not add the attempt".
[[nodiscard]] core::Result<QSqlQuery> run(const QSqlDatabase& db, const QString& sql, const std::string& doing,
                                          const QVariantList& values = {});
/// The same, where only success is of interest.
[[nodiscard]] core::Status execute(const QSqlDatabase& db, const QString& sql, const std::string& doing,
                                   const QVariantList& values = {});
/// The same, for one value: that of the first row, null without one.
[[nodiscard]] core::Result<QVariant> ask(const QSqlDatabase& db, const QString& sql, const std::string& doing,
                                         const QVariantList& values = {});
/// The same, for rows, one at a time. A damaged page must not look like a short list: it is an error.
[[nodiscard]] core::Status forEach(const QSqlDatabase& db, const QString& sql, const std::string& doing,
                                   const QVariantList& values, const std::function<void(const QSqlQuery&)>& row);

/// As it must be bound: an empty std::string is '', a null QString would be NULL.
[[nodiscard]] QVariant text(const std::string& utf8);
[[nodiscard]] inline QVariant number(std::int64_t value)
{
    return QVariant::fromValue<qlonglong>(value);
}
[[nodiscard]] std::string textOf(const QSqlQuery& row, int column);
/// From one column to the last.
[[nodiscard]] QVariantList valuesOf(const QSqlQuery& row, int first);

/// Ends a transaction so that it is kept. A server that goes away before it has answered is asked how it ended, as soon
/// as it is back: for some seconds, after which nobody knows (OutcomeUnknown). Where it was undone, ConnectionLost.
/// Afterwards the connection is lost in either case.
[[nodiscard]] core::Status commit(const QSqlDatabase& db, const std::string& doing);

/// Runs `work` inside a transaction that writes, which ends with it: kept if it succeeds, undone if not.
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
    // The first failure is the one to tell; a failed rollback ends with the connection anyway.
    if (!done)
        static_cast<void>(execute(db, QStringLiteral("ROLLBACK"), doing));
    return done;
}

}  // namespace database::sql
