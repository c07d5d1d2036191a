// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/sql/ExamStarts.h"

#include "database/sql/Audit.h"
#include "database/sql/Statement.h"

namespace database::sql {
namespace {

const std::string kBegin = "note that the exam has begun";
const std::string kList = "list the exams that were begun";

/// An attempt belongs to the last start before it ended; of two in one second, to that with the larger uid.
const QString kWithoutScore = QStringLiteral(
    " FROM exam_starts s WHERE NOT EXISTS (SELECT 1 FROM attempts a WHERE a.person_id = "
    "s.person_id AND a.lesson_id = s.lesson_id AND a.finished_utc >= s.begun_utc AND NOT EXISTS (SELECT 1 FROM "
    "exam_starts n WHERE n.person_id = s.person_id AND n.lesson_id = s.lesson_id AND (n.begun_utc > "
    "s.begun_utc OR (n.begun_utc = s.begun_utc AND n.uid > s.uid)) AND n.begun_utc <= a.finished_utc))");

}  // namespace

core::Status deliverExam(const School& school, const std::string& personUid, const ExamStart& start)
{
    return inTurn(school, kBegin, [&]() -> core::Status {
        const auto person = ask(school.db, "SELECT id FROM people WHERE uid = ?", kBegin, {text(personUid)});
        if (!person)
            return tl::unexpected(person.error());
        if (person->isNull())
            return core::unexpected(core::ErrorCode::UnknownName,
                                    "nobody here has the account that the exam was begun with");
        const auto added =
            ask(school.db,
                "INSERT INTO exam_starts (uid, person_id, lesson_id, begun_utc) VALUES (?, ?, ?, ?) ON CONFLICT (uid) "
                "DO NOTHING RETURNING uid",
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

core::Result<std::vector<ExamStart>> examsWithoutScore(const School& school, const Session& session, PersonId person)
{
    if (auto who = admitTo(school, session, Operation::ReadHistory, person); !who)
        return tl::unexpected(who.error());
    std::vector<ExamStart> starts;
    if (auto read = forEach(school.db,
                            "SELECT s.uid, s.lesson_id, s.begun_utc" + kWithoutScore +
                                " AND s.person_id = ? ORDER BY s.begun_utc DESC",
                            kList, {number(person.value)},
                            [&](const QSqlQuery& row) {
                                starts.push_back({textOf(row, 0), textOf(row, 1), textOf(row, 2)});
                            });
        !read)
        return tl::unexpected(read.error());
    return starts;
}

core::Result<int> countWithoutScore(const School& school, PersonId person, const std::string& lessonId)
{
    const auto count = ask(school.db, "SELECT COUNT(*)" + kWithoutScore + " AND s.person_id = ? AND s.lesson_id = ?",
                           kList, {number(person.value), text(lessonId)});
    if (!count)
        return tl::unexpected(count.error());
    return count->toInt();
}

core::Status forEachWithoutScore(const School& school, ClassId ofClass,
                                 const std::function<void(const WithoutScore&)>& take)
{
    return forEach(school.db,
                   "SELECT s.person_id, s.lesson_id, COUNT(*), MAX(s.begun_utc)" + kWithoutScore +
                       " AND s.person_id IN (SELECT person_id FROM enrolments WHERE class_id = ?) GROUP BY "
                       "s.person_id, s.lesson_id",
                   kList, {number(ofClass.value)}, [&take](const QSqlQuery& row) {
                       take({{row.value(0).toLongLong()}, textOf(row, 1), row.value(2).toInt(), textOf(row, 3)});
                   });
}

}  // namespace database::sql
