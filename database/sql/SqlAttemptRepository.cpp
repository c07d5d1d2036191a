// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/sql/SqlAttemptRepository.h"

#include <algorithm>

#include <QSqlQuery>
#include <QVariant>

#include "database/sql/Dialect.h"

namespace database::sql {
namespace {

QString text(const std::string& utf8)
{
    // An empty std::string must stay '', a null QString would be bound as NULL.
    return utf8.empty() ? QStringLiteral("") : QString::fromStdString(utf8);
}

}  // namespace

core::Result<std::int64_t> SqlAttemptRepository::add(const AttemptRecord& attempt)
{
    QSqlQuery query(m_db);
    const bool done = query.prepare("INSERT INTO attempts (finished_utc, tooth, score_points, duration_ms, "
                                    "score_sheet_json, state_hash, recording_file) VALUES (?, ?, ?, ?, ?, ?, ?) "
                                    "RETURNING id") &&
                      [&] {
                          query.addBindValue(text(attempt.finishedUtc));
                          query.addBindValue(text(attempt.tooth));
                          query.addBindValue(attempt.score);
                          query.addBindValue(static_cast<qlonglong>(attempt.durationMs));
                          query.addBindValue(text(attempt.scoreSheetJson));
                          query.addBindValue(text(attempt.stateHash));
                          query.addBindValue(text(attempt.recordingFile));
                          return query.exec() && query.next();
                      }();
    if (!done)
        return tl::unexpected(dialect::error(m_db, query.lastError(), "add the attempt"));
    const auto id = static_cast<std::int64_t>(query.value(0).toLongLong());
    // An INSERT ... RETURNING is committed when it has been read to its end.
    if (query.next() || query.lastError().isValid())
        return tl::unexpected(dialect::error(m_db, query.lastError(), "add the attempt"));
    return id;
}

core::Result<std::vector<AttemptRecord>> SqlAttemptRepository::select(const QString& rest, const std::string* tooth,
                                                                      int limit)
{
    QSqlQuery query(m_db);
    query.setForwardOnly(true);
    bool done = query.prepare("SELECT id, finished_utc, tooth, score_points, duration_ms, score_sheet_json, "
                              "state_hash, recording_file FROM attempts " +
                              rest + " LIMIT ?");
    if (done) {
        if (tooth != nullptr)
            query.addBindValue(text(*tooth));
        query.addBindValue(std::max(0, limit));
        done = query.exec();
    }
    std::vector<AttemptRecord> found;
    while (done && query.next()) {
        AttemptRecord record;
        record.id = query.value(0).toLongLong();
        record.finishedUtc = query.value(1).toString().toStdString();
        record.tooth = query.value(2).toString().toStdString();
        record.score = query.value(3).toInt();
        record.durationMs = query.value(4).toLongLong();
        record.scoreSheetJson = query.value(5).toString().toStdString();
        record.stateHash = query.value(6).toString().toStdString();
        record.recordingFile = query.value(7).toString().toStdString();
        found.push_back(std::move(record));
    }
    // next() also ends on an error: a damaged page must not look like a short history.
    if (!done || query.lastError().isValid())
        return tl::unexpected(dialect::error(m_db, query.lastError(), "read the attempts"));
    return found;
}

core::Result<std::vector<AttemptRecord>> SqlAttemptRepository::byTooth(const std::string& tooth, int limit)
{
    return select("WHERE tooth = ? ORDER BY finished_utc DESC, id DESC", &tooth, limit);
}

core::Result<std::vector<AttemptRecord>> SqlAttemptRepository::recent(int limit)
{
    return select("ORDER BY finished_utc DESC, id DESC", nullptr, limit);
}

core::Result<std::optional<AttemptRecord>> SqlAttemptRepository::best(const std::string& tooth)
{
    auto found = select("WHERE tooth = ? ORDER BY score_points DESC, finished_utc, id", &tooth, 1);
    if (!found)
        return tl::unexpected(found.error());
    return found->empty() ? std::optional<AttemptRecord>() : std::move(found->front());
}

}  // namespace database::sql
