// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/sql/Feedback.h"

#include <set>

#include "database/sql/Settings.h"
#include "database/sql/Statement.h"

namespace database::sql {
namespace {

/// Prefix of a setting, followed by the attempt's uid: the time up to which the person has seen its feedback.
const QString kSeen = QStringLiteral("feedback.");

/// Returns the SQL for comments or for overrides on attempts.
QString saidIn(const char* table, const char* when)
{
    return QStringLiteral("SELECT a.id, a.uid, a.lesson_id, COALESCE(NULLIF(TRIM(p.given_name || ' ' || "
                          "p.family_name), ''), p.username) AS author, t.%2 "
                          "AS said_utc FROM attempts a JOIN %1 t ON t.attempt_id = a.id JOIN people p ON p.id = "
                          "t.author_id WHERE a.person_id = ? AND t.author_id <> a.person_id")
        .arg(QLatin1String(table), QLatin1String(when));
}

}  // namespace

core::Result<std::vector<Feedback>> feedbackFor(const DatabaseContext& school, const Login& session, PersonId person)
{
    if (auto who = authorizeFor(school, session, Operation::ReadHistory, person); !who)
        return tl::unexpected(who.error());
    std::vector<Feedback> found;
    std::set<std::int64_t> known;
    if (auto read = forEach(school.db,
                            "SELECT f.id, f.lesson_id, f.author, f.said_utc, COALESCE(s.value, '') FROM (" +
                                saidIn("comments", "written_utc") + " AND t.withdrawn_utc IS NULL UNION ALL " +
                                saidIn("overrides", "given_utc") +
                                ") f LEFT JOIN settings s ON s.owner = (SELECT uid FROM people WHERE id = ?) AND "
                                "s.name = ? || f.uid ORDER BY f.said_utc DESC, f.id DESC",
                            "see what was said of the attempts",
                            {number(person.value), number(person.value), number(person.value), kSeen},
                            [&](const QSqlQuery& row) {
                                if (!known.insert(row.value(0).toLongLong()).second)
                                    return;
                                found.push_back({{row.value(0).toLongLong()},
                                                 textOf(row, 1),
                                                 textOf(row, 2),
                                                 textOf(row, 3),
                                                 textOf(row, 3) > textOf(row, 4)});
                            });
        !read)
        return tl::unexpected(read.error());
    return found;
}

core::Status seeFeedback(const DatabaseContext& school, const Login& session, const AttemptRecord& attempt)
{
    return changeOwnSetting(school, session, kSeen.toStdString() + attempt.uid, school.now());
}

}  // namespace database::sql
