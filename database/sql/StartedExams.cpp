// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/sql/StartedExams.h"

#include <algorithm>
#include <map>
#include <utility>

#include "database/sql/Audit.h"
#include "database/sql/Doubts.h"
#include "database/sql/Statement.h"

namespace database::sql {
namespace {

const std::string kBegin = "note that the exam has begun";
const std::string kList = "list the exams that were begun";

using Pair = std::pair<std::int64_t, std::string>;  ///< a person and a lesson

/// Returns the starts that meet a condition and have no score, newest first for each person and lesson. Attempts are
/// matched in the order of their ends: each takes the latest unmatched start before its end. So both of two exams at
/// the same time, in two windows, are matched, in whichever order they end.
core::Result<std::map<Pair, std::vector<ExamStart>>> withoutScore(const DatabaseContext& school, const QString& where,
                                                                  const QVariantList& values)
{
    std::map<Pair, std::vector<ExamStart>> starts;
    if (auto read = forEach(school.db,
                            "SELECT s.person_id, s.lesson_id, s.uid, s.begun_utc FROM exam_starts s WHERE " + where +
                                " ORDER BY s.begun_utc DESC, s.uid DESC",
                            kList, values,
                            [&](const QSqlQuery& row) {
                                starts[{row.value(0).toLongLong(), textOf(row, 1)}].push_back(
                                    {textOf(row, 2), textOf(row, 1), textOf(row, 3)});
                            });
        !read)
        return tl::unexpected(read.error());
    if (starts.empty())
        return starts;
    if (auto read =
            forEach(school.db,
                    "SELECT a.person_id, a.lesson_id, a.finished_utc FROM attempts a JOIN (SELECT DISTINCT "
                    "s.person_id, s.lesson_id FROM exam_starts s WHERE " +
                        where + ") begun ON begun.person_id = a.person_id AND begun.lesson_id = a.lesson_id WHERE " +
                        isAtItsLesson() + " ORDER BY a.finished_utc",
                    kList, values,
                    [&](const QSqlQuery& row) {
                        std::vector<ExamStart>& left = starts[{row.value(0).toLongLong(), textOf(row, 1)}];
                        const std::string finishedUtc = textOf(row, 2);
                        const auto own = std::find_if(left.begin(), left.end(), [&](const ExamStart& start) {
                            return start.begunUtc <= finishedUtc;
                        });
                        if (own != left.end())
                            left.erase(own);
                    });
        !read)
        return tl::unexpected(read.error());
    return starts;
}

}  // namespace

core::Status deliverExam(const DatabaseContext& school, const std::string& personUid, const ExamStart& start)
{
    return inTurn(school, kBegin, [&]() -> core::Status {
        const auto person = ask(school.db, personByUid(school.db), kBegin, {text(personUid)});
        if (!person)
            return tl::unexpected(person.error());
        if (person->isNull())
            return core::unexpected(core::ErrorCode::UnknownName,
                                    "nobody here has the account that the exam was begun with");
        const auto added =
            ask(school.db,
                dialect::isStation(school.db)
                    ? "SELECT 1 WHERE cusp_deliver_exam(?, ?, ?, ?)"
                    : "INSERT INTO exam_starts (uid, person_id, lesson_id, begun_utc) VALUES (?, ?, ?, ?) ON CONFLICT "
                      "(uid) DO NOTHING RETURNING uid",
                kBegin, {text(start.uid), *person, text(start.lessonId), text(start.begunUtc)});
        if (!added)
            return tl::unexpected(added.error());
        if (added->isNull())
            return {};
        return note(
            school, personUid, "exam.begin", "exam:" + start.uid,
            {{"lesson", QString::fromStdString(start.lessonId)}, {"begun", QString::fromStdString(start.begunUtc)}});
    });
}

core::Result<std::vector<ExamStart>> examsWithoutScore(const DatabaseContext& school, const Login& session,
                                                       PersonId person)
{
    if (auto who = authorizeFor(school, session, Operation::ReadHistory, person); !who)
        return tl::unexpected(who.error());
    auto found = withoutScore(school, QStringLiteral("s.person_id = ?"), {number(person.value)});
    if (!found)
        return tl::unexpected(found.error());
    std::vector<ExamStart> starts;
    for (auto& [of, left] : *found)
        starts.insert(starts.end(), left.begin(), left.end());
    std::stable_sort(starts.begin(), starts.end(),
                     [](const ExamStart& one, const ExamStart& other) { return one.begunUtc > other.begunUtc; });
    return starts;
}

core::Result<std::vector<ExamStart>> examStarts(const DatabaseContext& school, const Login& session, PersonId person,
                                                const std::string& lessonId)
{
    if (auto who = authorizeFor(school, session, Operation::ReadHistory, person); !who)
        return tl::unexpected(who.error());
    std::vector<ExamStart> starts;
    if (auto read = forEach(school.db, "SELECT uid, begun_utc FROM exam_starts WHERE person_id = ? AND lesson_id = ?",
                            kList, {number(person.value), text(lessonId)},
                            [&](const QSqlQuery& row) {
                                starts.push_back({textOf(row, 0), lessonId, textOf(row, 1)});
                            });
        !read)
        return tl::unexpected(read.error());
    return starts;
}

core::Result<std::map<std::string, int>> countWithoutScore(const DatabaseContext& school, PersonId person)
{
    const auto found = withoutScore(school, QStringLiteral("s.person_id = ?"), {number(person.value)});
    if (!found)
        return tl::unexpected(found.error());
    std::map<std::string, int> counts;
    for (const auto& [of, left] : *found)
        counts[of.second] = static_cast<int>(left.size());
    return counts;
}

core::Status forEachWithoutScore(const DatabaseContext& school, ClassId ofClass,
                                 const std::function<void(const WithoutScore&)>& take)
{
    const auto found =
        withoutScore(school, QStringLiteral("s.person_id IN (SELECT person_id FROM enrolments WHERE class_id = ?)"),
                     {number(ofClass.value)});
    if (!found)
        return tl::unexpected(found.error());
    for (const auto& [of, left] : *found)
        if (!left.empty())
            take({{of.first}, of.second, static_cast<int>(left.size()), left.front().begunUtc});
    return {};
}

}  // namespace database::sql
