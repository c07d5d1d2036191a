// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSqlDatabase>

#include "database/AttemptRepository.h"

namespace database::sql {

/// Attempts in an SQL database that migrate() has prepared.
class SqlAttemptRepository final : public AttemptRepository
{
public:
    /// @param db  open, and outliving the repository
    explicit SqlAttemptRepository(const QSqlDatabase& db) : m_db(db) {}

    [[nodiscard]] core::Result<std::int64_t> add(const AttemptRecord& attempt) override;
    [[nodiscard]] core::Result<std::vector<AttemptRecord>> byTooth(const std::string& tooth, int limit) override;
    [[nodiscard]] core::Result<std::vector<AttemptRecord>> byLesson(const std::string& lessonId, int limit) override;
    [[nodiscard]] core::Result<std::vector<LessonStanding>> standings() override;
    [[nodiscard]] core::Result<std::vector<AttemptRecord>> recent(int limit) override;
    [[nodiscard]] core::Result<std::optional<AttemptRecord>> best(const std::string& tooth) override;

private:
    [[nodiscard]] core::Result<std::vector<AttemptRecord>> select(const QString& rest, const std::string* value,
                                                                  int limit);

    QSqlDatabase m_db;
};

}  // namespace database::sql
