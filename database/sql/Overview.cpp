// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/sql/Overview.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include <QJsonArray>
#include <QJsonDocument>

#include "database/NameOrder.h"
#include "database/sql/Attempts.h"
#include "database/sql/Doubts.h"
#include "database/sql/StartedExams.h"
#include "database/sql/Statement.h"
#include "lessons/ClassStanding.h"

namespace database::sql {
namespace {

const std::string kReadingOverview = "read the class";
constexpr int kRecent = 20;
constexpr std::size_t kRecentShown = 5;
constexpr double kMicronsPerMm = 1000.0;

/// SQL for the students of a class, as people p.
const QString kStudents = QStringLiteral("people p JOIN enrolments e ON e.person_id = p.id WHERE e.class_id = ? AND "
                                         "p.role = 'student'");

core::Status readStudents(const DatabaseContext& school, ClassOverview& overview,
                          std::map<std::int64_t, std::size_t>& rowOf)
{
    std::vector<std::pair<SortedName, MatrixStudent>> students;
    if (auto read = forEach(
            school.db,
            "SELECT p.id, p.username, p.given_name, p.family_name, p.last_login_utc, p.disabled FROM " + kStudents,
            kReadingOverview, {number(overview.id.value)},
            [&](const QSqlQuery& row) {
                MatrixStudent student;
                student.id = {row.value(0).toLongLong()};
                student.username = textOf(row, 1);
                const SortedName name{textOf(row, 3), textOf(row, 2), student.username};
                student.fullName = name.given + (name.given.empty() || name.family.empty() ? "" : " ") + name.family;
                student.lastLoginUtc = textOf(row, 4);
                student.isDisabled = row.value(5).toInt() != 0;
                students.emplace_back(name, std::move(student));
            });
        !read)
        return read;
    std::sort(students.begin(), students.end(),
              [order = NameOrder()](const auto& a, const auto& b) { return order(a.first, b.first); });
    for (auto& [name, student] : students) {
        rowOf[student.id.value] = overview.students.size();
        overview.students.push_back(std::move(student));
    }
    return {};
}

core::Status readCells(const DatabaseContext& school, ClassOverview& overview,
                       const std::map<std::int64_t, std::size_t>& rowOf)
{
    if (auto read = forEach(school.db, "SELECT lesson_id FROM assignments WHERE class_id = ? ORDER BY lesson_id",
                            kReadingOverview, {number(overview.id.value)},
                            [&](const QSqlQuery& row) { overview.lessons.push_back(textOf(row, 0)); });
        !read)
        return read;
    struct Found
    {
        std::size_t student = 0;
        std::string lesson;
        MatrixCell cell;
    };
    std::vector<Found> found;
    if (auto read = forEach(school.db,
                            "SELECT s.person_id, s.lesson_id, s.attempts, s.best_tenths, s.passed, s.last_utc FROM "
                            "standings s JOIN enrolments e ON e.person_id = s.person_id WHERE e.class_id = ?",
                            kReadingOverview, {number(overview.id.value)},
                            [&](const QSqlQuery& row) {
                                const auto place = rowOf.find(row.value(0).toLongLong());
                                if (place == rowOf.end())
                                    return;
                                found.push_back({place->second,
                                                 textOf(row, 1),
                                                 {row.value(2).toInt(), row.value(3).toInt(), row.value(4).toInt() != 0,
                                                  textOf(row, 5)}});
                            });
        !read)
        return read;
    std::set<std::string> tried;
    const std::set<std::string> assigned(overview.lessons.begin(), overview.lessons.end());
    for (const Found& one : found)
        if (!one.lesson.empty() && assigned.count(one.lesson) == 0)
            tried.insert(one.lesson);
    overview.lessons.insert(overview.lessons.end(), tried.begin(), tried.end());
    std::map<std::string, std::size_t> columnOf;
    for (std::size_t k = 0; k < overview.lessons.size(); ++k)
        columnOf[overview.lessons[k]] = k;
    overview.cells.assign(overview.students.size(), std::vector<MatrixCell>(overview.lessons.size()));
    for (Found& one : found) {
        std::string& last = overview.students[one.student].lastAttemptUtc;
        last = std::max(last, one.cell.lastUtc);
        if (const auto column = columnOf.find(one.lesson); column != columnOf.end())
            overview.cells[one.student][column->second] = std::move(one.cell);
    }
    return {};
}

/// Reads exams without a score and the limits of the students' other classes: both count if a class limits attempts.
/// Reads the number of attempts in doubt.
core::Status readLimits(const DatabaseContext& school, ClassOverview& overview,
                        const std::map<std::int64_t, std::size_t>& rowOf)
{
    std::map<std::string, std::size_t> columnOf;
    for (std::size_t k = 0; k < overview.lessons.size(); ++k)
        columnOf[overview.lessons[k]] = k;
    const auto cellOf = [&](std::int64_t person, const std::string& lesson) -> MatrixCell* {
        const auto row = rowOf.find(person);
        const auto column = columnOf.find(lesson);
        return row == rowOf.end() || column == columnOf.end() ? nullptr : &overview.cells[row->second][column->second];
    };
    if (auto read = forEachWithoutScore(school, overview.id,
                                        [&](const WithoutScore& begun) {
                                            MatrixCell* const cell = cellOf(begun.person.value, begun.lessonId);
                                            if (cell == nullptr)
                                                return;
                                            cell->withoutScore = begun.count;
                                            cell->begunUtc = begun.newestUtc;
                                        });
        !read)
        return read;
    if (auto read = forEach(school.db,
                            "SELECT a.person_id, a.lesson_id, COUNT(*) FROM attempts a JOIN enrolments e ON "
                            "e.person_id = a.person_id WHERE e.class_id = ? AND a.doubt <> '' AND a.doubt <> "
                            "'version' AND a.given_tenths IS NULL GROUP BY a.person_id, a.lesson_id",
                            kReadingOverview, {number(overview.id.value)},
                            [&](const QSqlQuery& row) {
                                if (MatrixCell* cell = cellOf(row.value(0).toLongLong(), textOf(row, 1)))
                                    cell->inDoubt = row.value(2).toInt();
                            });
        !read)
        return read;
    return forEach(
        school.db,
        "SELECT e.person_id, a.lesson_id, CASE WHEN MIN(a.attempt_limit) = 0 THEN 0 ELSE "
        "MAX(a.attempt_limit) END FROM enrolments here JOIN enrolments e ON e.person_id = here.person_id AND "
        "e.class_id <> here.class_id JOIN assignments a ON a.class_id = e.class_id WHERE here.class_id = ? "
        "GROUP BY e.person_id, a.lesson_id",
        kReadingOverview, {number(overview.id.value)}, [&](const QSqlQuery& row) {
            if (MatrixCell* cell = cellOf(row.value(0).toLongLong(), textOf(row, 1)))
                cell->limitElsewhere = row.value(2).toInt();
        });
}

/// Reads the last attempts of each student. Retains only those at the lesson that the student tried last.
core::Status readRecent(const DatabaseContext& school, ClassOverview& overview,
                        const std::map<std::int64_t, std::size_t>& rowOf)
{
    return forEach(
        school.db,
        "SELECT person_id, lesson_id, score, passed FROM (SELECT a.person_id, a.lesson_id, COALESCE(a.given_tenths, "
        "a.score_tenths) AS score, CASE WHEN a.given_tenths IS NULL THEN a.passed WHEN a.given_tenths >= "
        "a.pass_mark_tenths THEN 1 ELSE 0 END AS passed, ROW_NUMBER() OVER (PARTITION BY a.person_id ORDER BY "
        "a.finished_utc DESC, a.id DESC) AS place FROM attempts a JOIN enrolments e ON e.person_id = a.person_id WHERE "
        "e.class_id = ? AND a.lesson_id <> '' AND " +
            doesCount() + ") recent WHERE place <= ? ORDER BY person_id, place",
        kReadingOverview, {number(overview.id.value), kRecent}, [&](const QSqlQuery& row) {
            const auto place = rowOf.find(row.value(0).toLongLong());
            if (place == rowOf.end())
                return;
            MatrixStudent& student = overview.students[place->second];
            const std::string lesson = textOf(row, 1);
            if (student.recentTenths.empty())
                student.recentLesson = lesson;
            if (lesson != student.recentLesson || student.recentTenths.size() == kRecentShown)
                return;
            student.recentTenths.push_back(row.value(2).toInt());
            student.recentPassed.push_back(row.value(3).toInt() != 0);
        });
}

/// Returns a quantile, interpolated between two neighbouring values.
int quantile(const std::vector<int>& sorted, double share)
{
    const double place = share * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    const double part = place - static_cast<double>(below);
    return static_cast<int>(std::lround((1.0 - part) * sorted[below] + part * sorted[above]));
}

/// @param scoresOfNth  scores by number of the attempt (1: each student's first); sorted afterwards
std::vector<BandPoint> curveOf(std::map<int, std::vector<int>>& scoresOfNth)
{
    std::vector<BandPoint> curve;
    for (auto& [attempt, scores] : scoresOfNth) {
        if (scores.size() < static_cast<std::size_t>(lessons::kFewestPeople))
            continue;
        std::sort(scores.begin(), scores.end());
        curve.push_back({attempt, static_cast<int>(scores.size()), quantile(scores, 0.25), quantile(scores, 0.5),
                         quantile(scores, 0.75)});
    }
    return curve;
}

LessonDifficulty difficultyOf(const std::map<std::int64_t, std::vector<std::pair<int, bool>>>& byPerson,
                              const std::map<std::string, std::pair<double, int>>& shares)
{
    LessonDifficulty difficulty;
    double firsts = 0.0;
    double needed = 0.0;
    for (const auto& [person, attempts] : byPerson) {
        ++difficulty.people;
        firsts += attempts.front().first;
        const auto pass = std::find_if(attempts.begin(), attempts.end(), [](const auto& a) { return a.second; });
        if (pass == attempts.end())
            continue;
        ++difficulty.passed;
        needed += static_cast<double>(pass - attempts.begin() + 1);
    }
    if (difficulty.people > 0)
        difficulty.meanTenths = firsts / difficulty.people;
    if (difficulty.passed > 0)
        difficulty.attemptsToPass = needed / difficulty.passed;
    for (const auto& [criterion, sum] : shares)
        difficulty.items.push_back({criterion, sum.first / sum.second});
    std::stable_sort(difficulty.items.begin(), difficulty.items.end(),
                     [](const auto& a, const auto& b) { return a.share > b.share; });
    return difficulty;
}

/// Returns the SQL condition, beginning with AND, that limits a band to attempts of classmates. A class below the
/// minimum size contributes no students, even if they are in other classes. Teachers get only their own classes.
QString amongThem(const AuthorizedUser& who)
{
    return QStringLiteral(
               " AND %5 AND p.role = 'student' AND p.disabled = 0 AND a.person_id IN (SELECT e.person_id FROM "
               "enrolments "
               "e "
               "WHERE e.class_id IN (SELECT mine.class_id FROM enrolments mine JOIN enrolments theirs ON "
               "theirs.class_id = mine.class_id JOIN people one ON one.id = theirs.person_id WHERE mine.person_id = ? "
               "AND one.role = 'student' AND one.disabled = 0%1 GROUP BY mine.class_id HAVING COUNT(*) >= %2)) AND "
               "%3 = COALESCE((SELECT %4 FROM attempts own WHERE own.person_id = ? AND own.lesson_id = ? ORDER BY "
               "own.finished_utc DESC, own.id DESC LIMIT 1), %3)")
        .arg(who.reach == Reach::Classes
                 ? QStringLiteral(" AND mine.class_id IN (SELECT class_id FROM enrolments WHERE person_id = ?)")
                 : QString())
        .arg(lessons::kFewestPeople)
        .arg(comparedDevice(QStringLiteral("a.device")), comparedDevice(QStringLiteral("own.device")), doesCount());
}

/// Calls `take` for each attempt of the band, in its order within those of a person: person, score, duration.
core::Status forEachInBand(const DatabaseContext& school, const Login& session, const AuthorizedUser& who,
                           PersonId person, const std::string& lessonId,
                           const std::function<void(const QSqlQuery& row)>& take)
{
    if (dialect::isStation(school.db))
        return forEach(school.db, "SELECT someone, score, duration_ms FROM cusp_band(?, ?)", kReadingOverview,
                       {number(person.value), text(lessonId)}, take);
    QVariantList values{text(lessonId), number(person.value)};
    if (who.reach == Reach::Classes)
        values << number(session.person().value);
    values << number(person.value) << text(lessonId);
    return forEach(school.db,
                   "SELECT a.person_id, COALESCE(a.given_tenths, a.score_tenths), a.duration_ms FROM attempts a JOIN "
                   "people p ON p.id = a.person_id WHERE a.lesson_id = ?" +
                       amongThem(who) + " ORDER BY a.person_id, a.finished_utc, a.id",
                   kReadingOverview, values, take);
}

}  // namespace

core::Result<ClassOverview> classOverview(const DatabaseContext& school, const Login& session, ClassId ofClass)
{
    if (auto who = authorizeForClass(school, session, Operation::ReadClass, ofClass); !who)
        return tl::unexpected(who.error());
    ClassOverview overview;
    overview.id = ofClass;
    const auto name =
        ask(school.db, "SELECT name FROM classes WHERE id = ?", kReadingOverview, {number(ofClass.value)});
    if (!name)
        return tl::unexpected(name.error());
    if (name->isNull())
        return core::unexpected(core::ErrorCode::UnknownName, "there is no such class");
    overview.name = name->toString().toStdString();
    std::map<std::int64_t, std::size_t> rowOf;
    if (auto read = readStudents(school, overview, rowOf); !read)
        return tl::unexpected(read.error());
    if (auto read = readCells(school, overview, rowOf); !read)
        return tl::unexpected(read.error());
    if (auto read = readLimits(school, overview, rowOf); !read)
        return tl::unexpected(read.error());
    if (auto read = readRecent(school, overview, rowOf); !read)
        return tl::unexpected(read.error());
    return overview;
}

core::Result<LessonResults> lessonResults(const DatabaseContext& school, const Login& session, ClassId ofClass,
                                          const std::string& lessonId)
{
    if (auto who = authorizeForClass(school, session, Operation::ReadClass, ofClass); !who)
        return tl::unexpected(who.error());
    LessonResults results;
    results.lessonId = lessonId;
    std::map<std::int64_t, std::vector<std::pair<int, bool>>> byPerson;
    std::map<int, std::vector<int>> scoresOfNth;
    std::map<std::string, std::pair<double, int>> shares;
    if (auto read = forEach(
            school.db,
            "SELECT a.person_id, COALESCE(a.given_tenths, a.score_tenths), CASE WHEN a.given_tenths IS NULL THEN "
            "a.passed WHEN a.given_tenths >= a.pass_mark_tenths THEN 1 ELSE 0 END, a.criteria_json FROM attempts a "
            "JOIN "
            "enrolments e ON e.person_id = a.person_id JOIN people p ON p.id = a.person_id WHERE e.class_id = ? AND "
            "p.role = 'student' AND p.disabled = 0 AND a.lesson_id = ? AND " +
                doesCount() + " ORDER BY a.person_id, a.finished_utc, a.id",
            kReadingOverview, {number(ofClass.value), text(lessonId)},
            [&](const QSqlQuery& row) {
                auto& attempts = byPerson[row.value(0).toLongLong()];
                attempts.emplace_back(row.value(1).toInt(), row.value(2).toInt() != 0);
                scoresOfNth[static_cast<int>(attempts.size())].push_back(row.value(1).toInt());
                const QJsonArray criteria = QJsonDocument::fromJson(row.value(3).toByteArray()).array();
                for (const auto& value : criteria) {
                    const QJsonArray criterion = value.toArray();
                    if (const double weight = criterion.at(2).toDouble(); weight > 0.0) {
                        auto& sum = shares[criterion.at(0).toString().toStdString()];
                        sum.first += criterion.at(1).toDouble() / weight;
                        ++sum.second;
                    }
                }
            });
        !read)
        return tl::unexpected(read.error());
    for (const auto& [person, attempts] : byPerson)
        results.bestTenths.push_back(std::max_element(attempts.begin(), attempts.end())->first);
    std::sort(results.bestTenths.begin(), results.bestTenths.end());
    results.curve = curveOf(scoresOfNth);
    results.difficulty = difficultyOf(byPerson, shares);
    results.difficulty.lessonId = lessonId;
    return results;
}

core::Result<std::vector<BandPoint>> classBand(const DatabaseContext& school, const Login& session, PersonId person,
                                               const std::string& lessonId)
{
    const auto who = authorizeFor(school, session, Operation::CompareWithClass, person);
    if (!who)
        return tl::unexpected(who.error());
    std::map<std::string, int> count;
    std::map<int, std::vector<int>> scoresOfNth;
    if (auto read = forEachInBand(
            school, session, *who, person, lessonId,
            [&](const QSqlQuery& row) { scoresOfNth[++count[textOf(row, 0)]].push_back(row.value(1).toInt()); });
        !read)
        return tl::unexpected(read.error());
    return curveOf(scoresOfNth);
}

core::Result<std::optional<LessonMedians>> classMedians(const DatabaseContext& school, const Login& session,
                                                        PersonId person, const std::string& lessonId)
{
    const auto who = authorizeFor(school, session, Operation::CompareWithClass, person);
    if (!who)
        return tl::unexpected(who.error());
    std::set<std::string> people;
    std::vector<int> scores;
    std::vector<int> durations;
    if (auto read = forEachInBand(school, session, *who, person, lessonId,
                                  [&](const QSqlQuery& row) {
                                      people.insert(textOf(row, 0));
                                      scores.push_back(row.value(1).toInt());
                                      durations.push_back(row.value(2).toInt());
                                  });
        !read)
        return tl::unexpected(read.error());
    if (people.size() < static_cast<std::size_t>(lessons::kFewestPeople))
        return std::optional<LessonMedians>();
    std::sort(scores.begin(), scores.end());
    std::sort(durations.begin(), durations.end());
    return std::optional(
        LessonMedians{static_cast<int>(people.size()), quantile(scores, 0.5), quantile(durations, 0.5)});
}

core::Result<AttemptTalk> readTalk(const DatabaseContext& school, const Login& session, AttemptId id)
{
    if (auto who = authorize(school, session, Operation::OpenAttempt); !who)
        return tl::unexpected(who.error());
    const auto owner =
        ask(school.db, "SELECT person_id FROM attempts WHERE id = ?", kReadingOverview, {number(id.value)});
    if (!owner)
        return tl::unexpected(owner.error());
    if (auto who = authorizeFor(school, session, Operation::OpenAttempt, {owner->toLongLong()}); !who)
        return tl::unexpected(who.error());
    const QString author =
        QStringLiteral("COALESCE(NULLIF(TRIM(p.given_name || ' ' || p.family_name), ''), p.username)");
    AttemptTalk talk;
    if (auto read = forEach(school.db,
                            "SELECT c.id, " + author +
                                ", c.written_utc, c.words, c.x_um, c.y_um, c.z_um, c.moment_ms, c.author_id FROM "
                                "comments c JOIN people p ON p.id = c.author_id WHERE c.attempt_id = ? AND "
                                "c.withdrawn_utc IS NULL ORDER BY c.id",
                            kReadingOverview, {number(id.value)},
                            [&](const QSqlQuery& row) {
                                AttemptComment comment{
                                    row.value(0).toLongLong(), textOf(row, 1), textOf(row, 2), textOf(row, 3), {}, {}};
                                if (!row.isNull(4))
                                    comment.placeMm = {row.value(4).toInt() / kMicronsPerMm,
                                                       row.value(5).toInt() / kMicronsPerMm,
                                                       row.value(6).toInt() / kMicronsPerMm};
                                if (!row.isNull(7))
                                    comment.momentMs = row.value(7).toLongLong();
                                comment.isMine = row.value(8).toLongLong() == session.person().value;
                                talk.comments.push_back(std::move(comment));
                            });
        !read)
        return tl::unexpected(read.error());
    if (auto read = forEach(school.db,
                            "SELECT " + author +
                                ", o.given_utc, o.given_tenths, o.reason FROM overrides o JOIN people p ON p.id = "
                                "o.author_id WHERE o.attempt_id = ? ORDER BY o.id",
                            kReadingOverview, {number(id.value)},
                            [&](const QSqlQuery& row) {
                                AttemptOverride given{textOf(row, 0), textOf(row, 1), {}, textOf(row, 3)};
                                if (!row.isNull(2))
                                    given.givenTenths = row.value(2).toInt();
                                talk.overrides.push_back(std::move(given));
                            });
        !read)
        return tl::unexpected(read.error());
    return talk;
}

}  // namespace database::sql
