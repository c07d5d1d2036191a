// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/sql/Doubts.h"

#include <vector>

#include "database/sql/Audit.h"
#include "database/sql/Statement.h"

namespace database::sql {
namespace {

const std::string kCountStanding = "count the standing";
const std::string kCheckAttempt = "check the attempt";
const std::string kCompareVersions = "compare the attempts with the assigned versions";

}  // namespace

QString doesCount()
{
    return QStringLiteral("(a.doubt = '' OR a.given_tenths IS NOT NULL)");
}

QString isAtItsLesson()
{
    return QStringLiteral("(a.doubt <> 'version' OR a.given_tenths IS NOT NULL)");
}

QString selectedStandings()
{
    return QStringLiteral("SELECT a.person_id, a.lesson_id, COUNT(*) AS attempts, MAX(CASE WHEN %1 THEN "
                          "COALESCE(a.given_tenths, a.score_tenths) ELSE 0 END) AS best_tenths, MAX(CASE WHEN NOT %1 "
                          "THEN 0 WHEN a.given_tenths IS NULL THEN a.passed WHEN a.given_tenths >= a.pass_mark_tenths "
                          "THEN 1 ELSE 0 END) AS passed, MAX(a.finished_utc) AS last_utc FROM attempts a WHERE "
                          "a.person_id IS NOT NULL AND %2")
        .arg(doesCount(), isAtItsLesson());
}

QString groupedByLesson()
{
    return QStringLiteral(" GROUP BY a.person_id, a.lesson_id");
}

core::Status recount(const DatabaseContext& school, PersonId person, const std::string& lessonId)
{
    const QVariantList which{number(person.value), text(lessonId)};
    if (dialect::isStation(school.db))
        return execute(school.db, "SELECT cusp_recount(?, ?)", kCountStanding, which);
    if (auto gone =
            execute(school.db, "DELETE FROM standings WHERE person_id = ? AND lesson_id = ?", kCountStanding, which);
        !gone)
        return gone;
    return execute(school.db,
                   "INSERT INTO standings (person_id, lesson_id, attempts, best_tenths, passed, last_utc) " +
                       selectedStandings() + " AND a.person_id = ? AND a.lesson_id = ?" + groupedByLesson(),
                   kCountStanding, which);
}

core::Result<bool> isOfAnotherVersion(const DatabaseContext& school, const AttemptRecord& attempt)
{
    if (attempt.lessonId.empty())
        return false;
    bool isAssigned = false;
    bool isSame = false;
    if (auto read = forEach(school.db,
                            "SELECT s.lesson_hash, v.lesson_hash FROM assignments s JOIN enrolments e ON e.class_id = "
                            "s.class_id JOIN people p ON p.id = e.person_id LEFT JOIN assigned_versions v ON "
                            "v.class_id = s.class_id AND v.lesson_id = s.lesson_id WHERE e.person_id = ? AND p.role = "
                            "'student' AND s.lesson_id = ?",
                            kCompareVersions, {number(attempt.person.value), text(attempt.lessonId)},
                            [&](const QSqlQuery& row) {
                                isAssigned = true;
                                isSame = isSame || textOf(row, 0).empty() || textOf(row, 1) == attempt.lessonHash;
                            });
        !read)
        return tl::unexpected(read.error());
    return isAssigned && !isSame;
}

core::Status compareVersions(const DatabaseContext& school, AuditBatch& audit, const std::string& actor,
                             ClassId ofClass, PersonId person, const std::string& lessonId)
{
    struct Changed
    {
        std::int64_t id = 0;
        std::string uid;
        PersonId person;
        std::string lessonId;
        Doubt doubt = Doubt::None;
    };
    std::vector<Changed> changed;
    QString where;
    QVariantList values{number(ofClass.value), number(ofClass.value)};
    if (person.value != 0) {
        where += QStringLiteral(" AND a.person_id = ?");
        values += number(person.value);
    }
    if (!lessonId.empty()) {
        where += QStringLiteral(" AND a.lesson_id = ?");
        values += text(lessonId);
    }
    if (auto read = forEach(
            school.db,
            "SELECT a.id, a.uid, a.person_id, a.lesson_id, a.doubt, CASE WHEN EXISTS (SELECT 1 FROM assigned_versions "
            "v WHERE v.lesson_id = a.lesson_id AND v.lesson_hash = a.lesson_hash AND (v.class_id = e.class_id OR "
            "a.doubt = '')) THEN '' ELSE 'version' END FROM attempts a JOIN enrolments e ON e.person_id = a.person_id "
            "JOIN people p ON p.id = a.person_id WHERE e.class_id = ? AND p.role = 'student' AND a.checked <> 2 AND "
            "a.doubt IN ('', 'version') AND a.lesson_id IN (SELECT s.lesson_id FROM assignments s WHERE s.class_id = ? "
            "AND s.lesson_hash <> '')" +
                where,
            kCompareVersions, values,
            [&](const QSqlQuery& row) {
                if (textOf(row, 4) != textOf(row, 5))
                    changed.push_back({row.value(0).toLongLong(),
                                       textOf(row, 1),
                                       {row.value(2).toLongLong()},
                                       textOf(row, 3),
                                       doubtNamed(textOf(row, 5))});
            });
        !read)
        return read;
    for (const Changed& one : changed) {
        if (auto set = execute(school.db, "UPDATE attempts SET doubt = ? WHERE id = ?", kCompareVersions,
                               {text(doubtId(one.doubt)), number(one.id)});
            !set)
            return set;
        if (auto counted = recount(school, one.person, one.lessonId); !counted)
            return counted;
        if (auto noted = audit.note(actor, "attempt.doubt", "attempt:" + one.uid,
                                    {{"doubt", QString::fromStdString(doubtId(one.doubt))}});
            !noted)
            return noted;
    }
    return {};
}

core::Result<std::vector<AttemptId>> attemptsToCheck(const DatabaseContext& school, const Login& session, int limit)
{
    const auto who = authorize(school, session, Operation::CheckAttempt);
    if (!who)
        return tl::unexpected(who.error());
    QString whose;
    QVariantList values;
    if (who->reach != Reach::All) {
        whose = QStringLiteral(" AND a.person_id IN %1").arg(classmates());
        values += number(session.person().value);
    }
    values += limit;
    std::vector<AttemptId> found;
    if (auto read =
            forEach(school.db,
                    "SELECT a.id FROM attempts a JOIN people p ON p.id = a.person_id WHERE a.checked = 0 AND "
                    "p.role = 'student'" +
                        whose + " ORDER BY a.id DESC LIMIT ?",
                    kCheckAttempt, values, [&](const QSqlQuery& row) { found.push_back({row.value(0).toLongLong()}); });
        !read)
        return tl::unexpected(read.error());
    return found;
}

core::Status noteCheck(const DatabaseContext& school, const Login& session, AttemptId id, Doubt found)
{
    if (auto who = authorize(school, session, Operation::CheckAttempt); !who)
        return tl::unexpected(who.error());
    return inTurn(school, kCheckAttempt, [&]() -> core::Status {
        std::string uid;
        PersonId person;
        std::string lessonId;
        Doubt before = Doubt::None;
        if (auto read = forEach(school.db, "SELECT uid, person_id, lesson_id, doubt FROM attempts WHERE id = ?",
                                kCheckAttempt, {number(id.value)},
                                [&](const QSqlQuery& row) {
                                    uid = textOf(row, 0);
                                    person = {row.value(1).toLongLong()};
                                    lessonId = textOf(row, 2);
                                    before = doubtNamed(textOf(row, 3));
                                });
            !read)
            return read;
        if (uid.empty())
            return core::unexpected(core::ErrorCode::UnknownName, "there is no such attempt");
        if (auto who = authorizeFor(school, session, Operation::CheckAttempt, person); !who)
            return tl::unexpected(who.error());
        const auto isCopied =
            ask(school.db,
                dialect::isStation(school.db)
                    ? "SELECT 1 FROM attempts a WHERE a.id = ? AND cusp_is_copied(a.recording_hash, a.person_id, a.id)"
                    : "SELECT 1 FROM attempts a JOIN attempts b ON b.recording_hash = a.recording_hash AND "
                      "b.recording_hash <> '' WHERE a.id = ? AND b.id < a.id AND b.person_id <> a.person_id",
                kCheckAttempt, {number(id.value)});
        if (!isCopied)
            return tl::unexpected(isCopied.error());
        if (!isCopied->isNull())
            found = Doubt::Recording;
        const Doubt now = found == Doubt::None && before == Doubt::Version ? before : found;
        if (auto set = execute(school.db, "UPDATE attempts SET doubt = ?, checked = 1 WHERE id = ?", kCheckAttempt,
                               {text(doubtId(now)), number(id.value)});
            !set)
            return set;
        if (now != before)
            if (auto counted = recount(school, person, lessonId); !counted)
                return counted;
        return note(school, session.uid(), "attempt.check", "attempt:" + uid,
                    {{"doubt", QString::fromStdString(doubtId(now))}});
    });
}

}  // namespace database::sql
