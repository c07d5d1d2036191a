// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/sql/Classes.h"

#include <algorithm>
#include <cassert>

#include "database/NameOrder.h"
#include "database/Usernames.h"
#include "database/sql/Audit.h"
#include "database/sql/Doubts.h"
#include "database/sql/LessonVersions.h"
#include "database/sql/StartedExams.h"
#include "database/sql/Statement.h"

namespace database::sql {
namespace {

using core::ErrorCode;

const std::string kListClasses = "list the classes";
const std::string kChange = "change the class";
constexpr qsizetype kLongestName = 100;

/// Returns the SQL condition that limits a query over classes c to those that the user may access.
QString within(const AuthorizedUser& who)
{
    return who.reach == Reach::All ? QString()
                                   : QStringLiteral(" WHERE c.id IN (SELECT class_id FROM enrolments WHERE "
                                                    "person_id = ?)");
}

QVariantList valuesOf(const AuthorizedUser& who, const Login& session)
{
    return who.reach == Reach::All ? QVariantList() : QVariantList{number(session.person().value)};
}

std::string objectOf(ClassId id)
{
    return "class:" + std::to_string(id.value);
}

core::Status expectFreeName(const DatabaseContext& school, const std::string& name, ClassId except)
{
    const auto taken =
        ask(school.db, "SELECT 1 FROM classes WHERE name = ? AND id <> ?", kChange, {text(name), number(except.value)});
    if (!taken)
        return tl::unexpected(taken.error());
    if (!taken->isNull())
        return core::unexpected(ErrorCode::OutOfRange,
                                "there is a class \"" + name + "\" already; choose another name");
    return {};
}

core::Result<std::optional<ClassAssignment>> assignmentNow(const DatabaseContext& school, ClassId id,
                                                           const std::string& lessonId)
{
    std::optional<ClassAssignment> now;
    if (auto read = forEach(
            school.db,
            "SELECT id, due_utc, attempt_limit, lesson_hash FROM assignments WHERE class_id = ? AND "
            "lesson_id = ?",
            "look what the class was given", {number(id.value), text(lessonId)},
            [&](const QSqlQuery& row) {
                now = ClassAssignment{
                    row.value(0).toLongLong(), id, lessonId, textOf(row, 1), row.value(2).toInt(), textOf(row, 3)};
            });
        !read)
        return tl::unexpected(read.error());
    return now;
}

/// Returns whether two assignments of the same lesson to the same class are equal. Ids are not compared.
bool isSame(const std::optional<ClassAssignment>& one, const std::optional<ClassAssignment>& other)
{
    return one.has_value() == other.has_value() &&
           (!one || (one->dueUtc == other->dueUtc && one->attemptLimit == other->attemptLimit &&
                     one->lessonHash == other->lessonHash));
}

/// Stores the version that a class is assigned, and that it was.
core::Status keepAssignedVersion(const DatabaseContext& school, const ClassAssignment& assignment,
                                 const QByteArray& pack)
{
    if (assignment.lessonHash.empty())
        return {};
    if (auto put = putVersion(school, assignment.lessonId, assignment.lessonHash, pack); !put)
        return put;
    return execute(school.db,
                   "INSERT INTO assigned_versions (class_id, lesson_id, lesson_hash) VALUES (?, ?, ?) ON CONFLICT DO "
                   "NOTHING",
                   "assign the lesson",
                   {number(assignment.classId.value), text(assignment.lessonId), text(assignment.lessonHash)});
}

/// Excludes the attempts of a class at a lesson from every comparison of versions.
core::Status keepUncompared(const DatabaseContext& school, const ClassAssignment& assignment)
{
    return execute(
        school.db,
        "UPDATE attempts SET checked = 2 WHERE checked = 0 AND doubt = '' AND lesson_id = ? AND person_id IN "
        "(SELECT person_id FROM enrolments WHERE class_id = ?)",
        "assign the lesson", {text(assignment.lessonId), number(assignment.classId.value)});
}

core::Status changedSince()
{
    return core::unexpected(core::ErrorCode::ChangedSince,
                            "somebody else has changed what the class was given; look at it, and change it again");
}

}  // namespace

core::Result<std::string> checkClassName(const std::string& name)
{
    const QString trimmed = QString::fromStdString(name).simplified();
    if (trimmed.isEmpty() || trimmed.toUcs4().size() > kLongestName || !canBeSeen(trimmed.toStdString()))
        return core::unexpected(ErrorCode::OutOfRange,
                                "the name of a class has 1 to 100 characters that can be seen; correct it");
    if (trimmed.contains(u'|'))
        return core::unexpected(ErrorCode::OutOfRange,
                                "the name of a class has no |, which parts classes in a class list; use another sign");
    return trimmed.toStdString();
}

core::Result<std::vector<SchoolClass>> listClasses(const DatabaseContext& school, const Login& session)
{
    const auto who = authorize(school, session, Operation::ListClasses);
    if (!who)
        return tl::unexpected(who.error());
    std::vector<SchoolClass> classes;
    if (auto read =
            forEach(school.db,
                    "SELECT c.id, c.name, COUNT(CASE WHEN p.role = 'student' AND p.disabled = 0 THEN 1 END), "
                    "COUNT(CASE WHEN p.role = 'instructor' AND p.disabled = 0 THEN 1 END) FROM classes c "
                    "LEFT JOIN enrolments e ON e.class_id = c.id LEFT JOIN people p ON p.id = e.person_id" +
                        within(*who) + " GROUP BY c.id, c.name",
                    kListClasses, valuesOf(*who, session),
                    [&](const QSqlQuery& row) {
                        classes.push_back(
                            {{row.value(0).toLongLong()}, textOf(row, 1), row.value(2).toInt(), row.value(3).toInt()});
                    });
        !read)
        return tl::unexpected(read.error());
    std::sort(classes.begin(), classes.end(),
              [order = NameOrder()](const SchoolClass& a, const SchoolClass& b) { return order(a.name, b.name); });
    return classes;
}

core::Result<ClassId> classNamed(const DatabaseContext& school, AuditBatch& audit, const std::string& actor,
                                 const std::string& name)
{
    const auto checked = checkClassName(name);
    if (!checked)
        return tl::unexpected(checked.error());
    const auto found = ask(school.db, "SELECT id FROM classes WHERE name = ?", kChange, {text(*checked)});
    if (!found)
        return tl::unexpected(found.error());
    if (!found->isNull())
        return ClassId{found->toLongLong()};
    const auto made = ask(school.db, "INSERT INTO classes (name) VALUES (?) RETURNING id", kChange, {text(*checked)});
    if (!made)
        return tl::unexpected(made.error());
    const ClassId id{made->toLongLong()};
    if (auto noted = audit.note(actor, "class.add", objectOf(id), {{"name", QString::fromStdString(*checked)}}); !noted)
        return tl::unexpected(noted.error());
    return id;
}

core::Status putInto(const DatabaseContext& school, AuditBatch& audit, const std::string& actor, ClassId id,
                     PersonId person)
{
    assert(id.value > 0 && person.value > 0);
    const auto is = ask(school.db, "SELECT 1 FROM enrolments WHERE class_id = ? AND person_id = ?", kChange,
                        {number(id.value), number(person.value)});
    if (!is)
        return tl::unexpected(is.error());
    if (!is->isNull())
        return {};
    if (auto put = execute(school.db, "INSERT INTO enrolments (class_id, person_id) VALUES (?, ?)", kChange,
                           {number(id.value), number(person.value)});
        !put)
        return put;
    const auto uid = ask(school.db, "SELECT uid FROM people WHERE id = ?", kChange, {number(person.value)});
    if (!uid)
        return tl::unexpected(uid.error());
    if (auto noted = audit.note(actor, "class.enrol", objectOf(id), {{"person", uid->toString()}}); !noted)
        return noted;
    return compareVersions(school, audit, actor, id, person, {});
}

core::Status takeOutOf(const DatabaseContext& school, AuditBatch& audit, const std::string& actor, ClassId id,
                       PersonId person)
{
    assert(id.value > 0 && person.value > 0);
    const auto uid = ask(school.db,
                         "DELETE FROM enrolments WHERE class_id = ? AND person_id = ? RETURNING "
                         "(SELECT uid FROM people WHERE people.id = person_id)",
                         kChange, {number(id.value), number(person.value)});
    if (!uid)
        return tl::unexpected(uid.error());
    if (uid->isNull())
        return {};
    return audit.note(actor, "class.leave", objectOf(id), {{"person", uid->toString()}});
}

core::Result<ClassId> addClass(const DatabaseContext& school, const Login& session, const std::string& name)
{
    if (auto who = authorize(school, session, Operation::ChangeClasses); !who)
        return tl::unexpected(who.error());
    return inTurn(school, kChange, [&]() -> core::Result<ClassId> {
        const auto checked = checkClassName(name);
        if (!checked)
            return tl::unexpected(checked.error());
        if (auto is = expectFreeName(school, *checked, {}); !is)
            return tl::unexpected(is.error());
        AuditBatch audit(school);
        auto made = classNamed(school, audit, session.uid(), *checked);
        if (!made)
            return made;
        if (auto sealed = audit.seal(); !sealed)
            return tl::unexpected(sealed.error());
        return made;
    });
}

core::Status renameClass(const DatabaseContext& school, const Login& session, ClassId id, const std::string& name)
{
    if (auto who = authorize(school, session, Operation::ChangeClasses); !who)
        return tl::unexpected(who.error());
    const auto checked = checkClassName(name);
    if (!checked)
        return tl::unexpected(checked.error());
    return inTurn(school, kChange, [&]() -> core::Status {
        if (auto is = expectFreeName(school, *checked, id); !is)
            return is;
        if (auto renamed = execute(school.db, "UPDATE classes SET name = ? WHERE id = ?", kChange,
                                   {text(*checked), number(id.value)});
            !renamed)
            return renamed;
        return note(school, session.uid(), "class.rename", objectOf(id), {{"name", QString::fromStdString(*checked)}});
    });
}

core::Status enrol(const DatabaseContext& school, const Login& session, ClassId id, PersonId person, bool belongs)
{
    if (auto who = authorize(school, session, Operation::ChangeClasses); !who)
        return tl::unexpected(who.error());
    return inTurn(school, kChange, [&]() -> core::Status {
        AuditBatch audit(school);
        const auto change = belongs ? putInto : takeOutOf;
        if (auto done = change(school, audit, session.uid(), id, person); !done)
            return done;
        return audit.seal();
    });
}

core::Result<std::vector<ClassAssignment>> listAssignments(const DatabaseContext& school, const Login& session)
{
    const auto who = authorize(school, session, Operation::ListAssignments);
    if (!who)
        return tl::unexpected(who.error());
    std::vector<ClassAssignment> assignments;
    if (auto read = forEach(school.db,
                            "SELECT a.id, a.class_id, a.lesson_id, a.due_utc, a.attempt_limit, a.lesson_hash, "
                            "COALESCE(v.version, 0) FROM assignments a JOIN classes c ON c.id = a.class_id LEFT JOIN "
                            "lesson_versions v ON v.hash = a.lesson_hash" +
                                within(*who) + " ORDER BY a.due_utc = '', a.due_utc, a.id",
                            "list what is to be done", valuesOf(*who, session),
                            [&](const QSqlQuery& row) {
                                assignments.push_back({row.value(0).toLongLong(),
                                                       {row.value(1).toLongLong()},
                                                       textOf(row, 2),
                                                       textOf(row, 3),
                                                       row.value(4).toInt(),
                                                       textOf(row, 5),
                                                       row.value(6).toInt()});
                            });
        !read)
        return tl::unexpected(read.error());
    return assignments;
}

core::Status assign(const DatabaseContext& school, const Login& session, const ClassAssignment& assignment,
                    const std::optional<ClassAssignment>& before, const QByteArray& pack)
{
    if (auto who = authorizeForClass(school, session, Operation::Assign, assignment.classId); !who)
        return tl::unexpected(who.error());
    const std::string doing = "assign the lesson";
    return inTurn(school, doing, [&]() -> core::Status {
        const auto now = assignmentNow(school, assignment.classId, assignment.lessonId);
        if (!now)
            return tl::unexpected(now.error());
        if (!isSame(*now, before))
            return changedSince();
        if (auto kept = keepAssignedVersion(school, assignment, pack); !kept)
            return kept;
        if (auto put = execute(school.db,
                               "INSERT INTO assignments (class_id, lesson_id, due_utc, attempt_limit, lesson_hash, "
                               "created_by, created_utc) VALUES (?, ?, ?, ?, ?, ?, ?) ON CONFLICT (class_id, "
                               "lesson_id) DO UPDATE SET due_utc = excluded.due_utc, attempt_limit = "
                               "excluded.attempt_limit, lesson_hash = excluded.lesson_hash",
                               doing,
                               {number(assignment.classId.value), text(assignment.lessonId), text(assignment.dueUtc),
                                assignment.attemptLimit, text(assignment.lessonHash), number(session.person().value),
                                text(school.now())});
            !put)
            return put;
        AuditBatch audit(school);
        if (auto noted = audit.note(session.uid(), "lesson.assign", objectOf(assignment.classId),
                                    {{"lesson", QString::fromStdString(assignment.lessonId)},
                                     {"due", QString::fromStdString(assignment.dueUtc)},
                                     {"limit", assignment.attemptLimit},
                                     {"hash", QString::fromStdString(assignment.lessonHash)}});
            !noted)
            return noted;
        // Attempts at an assignment from before versions were stored count as they did.
        if (*now && (*now)->lessonHash.empty())
            if (auto kept = keepUncompared(school, assignment); !kept)
                return kept;
        if (auto compared = compareVersions(school, audit, session.uid(), assignment.classId, {}, assignment.lessonId);
            !compared)
            return compared;
        return audit.seal();
    });
}

core::Status unassign(const DatabaseContext& school, const Login& session, const ClassAssignment& before)
{
    if (auto who = authorizeForClass(school, session, Operation::Assign, before.classId); !who)
        return tl::unexpected(who.error());
    const std::string doing = "take the lesson back";
    return inTurn(school, doing, [&]() -> core::Status {
        const auto now = assignmentNow(school, before.classId, before.lessonId);
        if (!now)
            return tl::unexpected(now.error());
        if (!*now)
            return {};
        if (!isSame(*now, before))
            return changedSince();
        if (auto gone = execute(school.db, "DELETE FROM assignments WHERE class_id = ? AND lesson_id = ?", doing,
                                {number(before.classId.value), text(before.lessonId)});
            !gone)
            return gone;
        return note(school, session.uid(), "lesson.unassign", objectOf(before.classId),
                    {{"lesson", QString::fromStdString(before.lessonId)}});
    });
}

core::Result<std::map<std::string, int>> attemptsLeft(const DatabaseContext& school, const Login& session)
{
    std::map<std::string, int> left;
    if (session.isGuest())
        return left;
    if (auto who = authorize(school, session, Operation::ListAssignments); !who)
        return tl::unexpected(who.error());
    const auto withoutScore = countWithoutScore(school, session.person());
    if (!withoutScore)
        return tl::unexpected(withoutScore.error());
    // No limit in one of the classes counts as the highest limit.
    if (auto read = forEach(school.db,
                            "SELECT a.lesson_id, MAX(a.attempt_limit), COALESCE(MAX(s.attempts), 0) FROM assignments a "
                            "JOIN enrolments e ON e.class_id = a.class_id "
                            "LEFT JOIN standings s ON s.person_id = e.person_id AND s.lesson_id = a.lesson_id "
                            "WHERE e.person_id = ? GROUP BY a.lesson_id HAVING MIN(a.attempt_limit) > 0",
                            "see how often the lessons may be tried", {number(session.person().value)},
                            [&](const QSqlQuery& row) {
                                const std::string lesson = textOf(row, 0);
                                const auto begun = withoutScore->find(lesson);
                                const int used =
                                    row.value(2).toInt() + (begun == withoutScore->end() ? 0 : begun->second);
                                left[lesson] = std::max(0, row.value(1).toInt() - used);
                            });
        !read)
        return tl::unexpected(read.error());
    return left;
}

core::Result<std::optional<int>> attemptsLeft(const DatabaseContext& school, const Login& session,
                                              const std::string& lessonId)
{
    const auto left = attemptsLeft(school, session);
    if (!left)
        return tl::unexpected(left.error());
    const auto found = left->find(lessonId);
    return found == left->end() ? std::nullopt : std::optional(found->second);
}

}  // namespace database::sql
