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
    const bool done = query.prepare("INSERT INTO attempts (finished_utc, tooth, score_tenths, duration_ms, "
                                    "score_sheet_json, state_hash, recording_file, passed, lesson_id, lesson_hash, "
                                    "rubric_hash, expected_tenths) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?) "
                                    "RETURNING id") &&
                      [&] {
                          query.addBindValue(text(attempt.finishedUtc));
                          query.addBindValue(text(attempt.tooth));
                          query.addBindValue(attempt.scoreTenths);
                          query.addBindValue(static_cast<qlonglong>(attempt.durationMs));
                          query.addBindValue(text(attempt.scoreSheetJson));
                          query.addBindValue(text(attempt.stateHash));
                          query.addBindValue(text(attempt.recordingFile));
                          query.addBindValue(attempt.passed ? 1 : 0);
                          query.addBindValue(text(attempt.lessonId));
                          query.addBindValue(text(attempt.lessonHash));
                          query.addBindValue(text(attempt.rubricHash));
                          query.addBindValue(attempt.expectedTenths ? QVariant(*attempt.expectedTenths) : QVariant());
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

core::Result<std::vector<AttemptRecord>> SqlAttemptRepository::select(const QString& rest, const std::string* value,
                                                                      int limit)
{
    QSqlQuery query(m_db);
    query.setForwardOnly(true);
    bool done = query.prepare("SELECT id, finished_utc, tooth, score_tenths, duration_ms, score_sheet_json, "
                              "state_hash, recording_file, passed, lesson_id, lesson_hash, rubric_hash, "
                              "expected_tenths FROM attempts " +
                              rest + " LIMIT ?");
    if (done) {
        if (value != nullptr)
            query.addBindValue(text(*value));
        query.addBindValue(std::max(0, limit));
        done = query.exec();
    }
    std::vector<AttemptRecord> found;
    while (done && query.next()) {
        AttemptRecord record;
        record.id = query.value(0).toLongLong();
        record.finishedUtc = query.value(1).toString().toStdString();
        record.tooth = query.value(2).toString().toStdString();
        record.scoreTenths = query.value(3).toInt();
        record.durationMs = query.value(4).toLongLong();
        record.scoreSheetJson = query.value(5).toString().toStdString();
        record.stateHash = query.value(6).toString().toStdString();
        record.recordingFile = query.value(7).toString().toStdString();
        record.passed = query.value(8).toInt() != 0;
        record.lessonId = query.value(9).toString().toStdString();
        record.lessonHash = query.value(10).toString().toStdString();
        record.rubricHash = query.value(11).toString().toStdString();
        if (!query.isNull(12))
            record.expectedTenths = query.value(12).toInt();
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

core::Result<std::vector<AttemptRecord>> SqlAttemptRepository::byLesson(const std::string& lessonId, int limit)
{
    return select("WHERE lesson_id = ? ORDER BY finished_utc DESC, id DESC", &lessonId, limit);
}

core::Result<std::vector<LessonStanding>> SqlAttemptRepository::standings()
{
    QSqlQuery query(m_db);
    query.setForwardOnly(true);
    const bool done = query.exec("SELECT lesson_id, COUNT(*), MAX(score_tenths), MAX(passed) FROM attempts "
                                 "WHERE lesson_id <> '' GROUP BY lesson_id ORDER BY lesson_id");
    std::vector<LessonStanding> found;
    while (done && query.next())
        found.push_back({query.value(0).toString().toStdString(), query.value(1).toInt(), query.value(2).toInt(),
                         query.value(3).toInt() != 0});
    if (!done || query.lastError().isValid())
        return tl::unexpected(dialect::error(m_db, query.lastError(), "read the attempts"));
    return found;
}

core::Result<std::vector<AttemptRecord>> SqlAttemptRepository::recent(int limit)
{
    return select("ORDER BY finished_utc DESC, id DESC", nullptr, limit);
}

core::Result<std::optional<AttemptRecord>> SqlAttemptRepository::best(const std::string& tooth)
{
    auto found = select("WHERE tooth = ? ORDER BY score_tenths DESC, finished_utc, id", &tooth, 1);
    if (!found)
        return tl::unexpected(found.error());
    return found->empty() ? std::optional<AttemptRecord>() : std::move(found->front());
}

}  // namespace database::sql
