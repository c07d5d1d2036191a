// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <memory>

#include <QSqlDatabase>
#include <QString>

#include "core/base/Result.h"

namespace database::sql {

/// One open SQLite file, brought to the newest schema. Belongs to the thread that opened it; close it before the
/// QCoreApplication ends.
class Database
{
public:
    /// Opens or creates `path`. Write-ahead log, full sync at each commit, foreign keys on; the file is checked before
    /// it is used. Refused with one sentence and left untouched: a directory, a file that is no database or belongs to
    /// another program, a damaged one, one from a later program, a place that cannot be written.
    /// @param patience  how long to wait for another program's write
    [[nodiscard]] static core::Result<std::unique_ptr<Database>>
    open(const QString& path, std::chrono::milliseconds patience = std::chrono::seconds(5));

    ~Database();
    Database(const Database&) = delete;
    Database& operator=(const Database&) = delete;

    [[nodiscard]] QSqlDatabase handle() const { return QSqlDatabase::database(m_connection, false); }

private:
    explicit Database(QString connection) : m_connection(std::move(connection)) {}

    QString m_connection;
};

}  // namespace database::sql
