// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/sql/Noted.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <utility>

#include <QCryptographicHash>
#include <QJsonDocument>
#include <QJsonObject>

#include "database/Passwords.h"
#include "database/Permissions.h"
#include "database/sql/Attempts.h"
#include "database/sql/People.h"
#include "database/sql/Statement.h"

namespace database::sql {
namespace {

using Say = std::function<void(const IntegrityIssue&)>;

const std::string kComparing = "check it";

/// The rows of a table by their object ("person:1f..."); several rows may have the same object.
using Rows = std::map<std::string, std::multiset<std::string>>;

std::string joined(std::initializer_list<std::string> values)
{
    std::string all;
    for (const std::string& value : values)
        all += value + '\n';
    return all;
}

/// An action of the audit and the operation that it is.
struct Act
{
    const char* action;
    Operation operation;
};
constexpr Act kActs[]{
    {"person.add", Operation::AddPerson},
    {"person.change", Operation::ChangePerson},
    {"password.reset", Operation::ResetPassword},
    {"class.add", Operation::ChangeClasses},
    {"class.rename", Operation::ChangeClasses},
    {"class.enrol", Operation::ChangeClasses},
    {"class.leave", Operation::ChangeClasses},
    {"lesson.assign", Operation::Assign},
    {"lesson.unassign", Operation::Assign},
    {"attempt.comment", Operation::Comment},
    {"attempt.override", Operation::Override},
    {"attempt.check", Operation::CheckAttempt},
    {"preset.add", Operation::AddPreset},
    {"setting.change", Operation::ChangeSettings},
    {"person.erase", Operation::ChangePerson},
    {"attempt.comment.erase", Operation::ChangePerson},
    {"attempt.override.erase", Operation::ChangePerson},
};

/// Replays the audit from its first row and computes the expected content of each table.
class Noted
{
public:
    void take(const std::string& actor, const std::string& action, const std::string& about, const QJsonObject& detail);
    /// Returns whether the role that the actor has at this row permits the action. True for a person from before there
    /// was an audit, whose role is not noted.
    [[nodiscard]] bool mayDo(const std::string& actor, const std::string& action) const;
    [[nodiscard]] Rows rowsOf(const std::string& table) { return std::move(m_tables[table]); }

private:
    void set(const char* table, const std::string& about, std::initializer_list<std::string> values)
    {
        m_tables[table][about] = {joined(values)};
    }

    /// Sets the row of an attempt; there is none for an attempt as it was delivered, without a doubt.
    void setAttempt(const std::string& about)
    {
        const Verdict& now = m_attempts[about];
        if (now.given.empty() && now.doubt.empty() && now.checked == "0")
            m_tables["attempts"].erase(about);
        else
            set("attempts", about, {now.given, now.doubt, now.checked});
    }

    /// The columns of an attempt that may change.
    struct Verdict
    {
        std::string given;
        std::string doubt;
        std::string checked = "0";
    };

    struct Standing
    {
        std::string role;
        std::string disabled = "0";
        std::string names;  ///< digest
        std::string login;  ///< digest
    };

    std::map<std::string, Rows> m_tables;
    std::map<std::string, Standing> m_people;
    std::map<std::string, Verdict> m_attempts;
    /// By class and lesson: uid of the first person who assigned it, and the expected row.
    std::map<std::pair<std::string, std::string>, std::pair<std::string, std::string>> m_assignments;
};

/// Replaces the digest in the row of a text. Such a row begins with its author and ends with its digest.
void replaceDigest(std::multiset<std::string>& rows, const std::string& author, const std::string& before,
                   const std::string& after)
{
    const auto row = std::find_if(rows.begin(), rows.end(), [&](const std::string& one) {
        return one.starts_with(author + '\n') && one.ends_with('\n' + before + '\n');
    });
    if (row == rows.end())
        return;
    std::string changed = row->substr(0, row->size() - before.size() - 1) + after + '\n';
    rows.erase(row);
    rows.insert(std::move(changed));
}

bool Noted::mayDo(const std::string& actor, const std::string& action) const
{
    if (actor == "system")  // Cusp itself adds only the first admin
        return action != "person.add" || m_people.empty();
    const auto* const act =
        std::find_if(std::begin(kActs), std::end(kActs), [&](const Act& one) { return action == one.action; });
    const auto person = m_people.find("person:" + actor);
    if (act == std::end(kActs) || person == m_people.end())
        return true;
    const auto role = roleOf(person->second.role);
    return !role || reachOf(act->operation, *role) != Reach::Nothing;
}

void Noted::take(const std::string& actor, const std::string& action, const std::string& about,
                 const QJsonObject& detail)
{
    const auto word = [&detail](const char* key) {
        return detail.value(QLatin1String(key)).toVariant().toString().toStdString();
    };
    if (action == "attempt.override") {
        m_tables["overrides"][about].insert(joined({actor, word("given_tenths"), word("digest_of_all")}));
        m_attempts[about].given = word("given_tenths");
        setAttempt(about);
    } else if (action == "attempt.doubt" || action == "attempt.check") {
        m_attempts[about].doubt = word("doubt");
        if (action == "attempt.check")
            m_attempts[about].checked = "1";
        setAttempt(about);
    } else if (action == "attempt.comment") {
        m_tables["comments"][about].insert(joined({actor, "0", word("digest_of_all")}));
    } else if (action == "attempt.comment.withdraw") {
        auto& comments = m_tables["comments"][about];
        if (const auto stood = comments.find(joined({actor, "0", word("digest_of_all")})); stood != comments.end())
            comments.erase(stood);
        comments.insert(joined({actor, "1", word("digest_of_all")}));
    } else if (action == "attempt.comment.erase" || action == "attempt.override.erase") {
        replaceDigest(m_tables[action == "attempt.comment.erase" ? "comments" : "overrides"][about], word("author"),
                      word("digest_before"), word("digest_of_all"));
    } else if (action == "preset.add") {
        set("presets", about, {actor, word("hash"), word("hash")});
    } else if (action == "setting.change") {
        set("settings", about, {detail.contains(QStringLiteral("digest")) ? word("digest") : digestOf(word("value"))});
    } else if (action == "exam.begin") {
        set("exam_starts", about, {actor, word("lesson"), word("begun")});
    } else if (action == "class.add" || action == "class.rename") {
        set("classes", about, {word("name")});
    } else if (action == "class.enrol") {
        m_tables["enrolments"]["person:" + word("person")].insert(joined({about}));
    } else if (action == "class.leave") {
        m_tables["enrolments"]["person:" + word("person")].erase(joined({about}));
    } else if (action == "lesson.assign") {
        auto& [giver, row] = m_assignments[{about, word("lesson")}];
        if (giver.empty())  // the first person who assigned the lesson stays its author
            giver = actor;
        auto& lessons = m_tables["assignments"][about];
        lessons.erase(row);
        row = joined({word("lesson"), giver, word("due"), word("limit"), word("hash")});
        lessons.insert(row);
        auto& versions = m_tables["assigned_versions"][about];
        if (const std::string version = joined({word("lesson"), word("hash")});
            !word("hash").empty() && versions.count(version) == 0)
            versions.insert(version);
    } else if (action == "lesson.unassign") {
        m_tables["assignments"][about].erase(m_assignments[{about, word("lesson")}].second);
        m_assignments.erase({about, word("lesson")});
    } else {
        Standing& person = m_people[about];
        for (const auto& [key, kept] : {std::pair("role", &person.role), std::pair("names_digest", &person.names),
                                        std::pair("login_digest", &person.login)})
            if (detail.contains(QLatin1String(key)))
                *kept = word(key);
        if (detail.contains(QStringLiteral("disabled")))
            person.disabled = detail.value(QStringLiteral("disabled")).toBool() ? "1" : "0";
        set("people", about, {person.role, person.disabled, person.names, person.login});
    }
}

/// Returns all columns after the first (the object), as stored.
std::string plain(const QSqlQuery& row)
{
    std::string all;
    for (const QVariant& value : valuesOf(row, 1))
        all += (value.isNull() ? std::string() : value.toString().toStdString()) + '\n';
    return all;
}

std::string asOpinion(const QSqlQuery& row)
{
    // The engines return different values for null.
    return joined({textOf(row, 1), row.isNull(2) ? "" : textOf(row, 2), digestOfComment(valuesOf(row, 3))});
}

std::string asPreset(const QSqlQuery& row)
{
    const QByteArray hash = QCryptographicHash::hash(row.value(3).toString().toUtf8(), QCryptographicHash::Sha256);
    return joined({textOf(row, 1), textOf(row, 2), hash.toHex().toStdString()});
}

std::string asSetting(const QSqlQuery& row)
{
    return joined({digestOf(textOf(row, 1))});
}

std::string asPerson(const QSqlQuery& row)
{
    Person person;
    person.uid = textOf(row, 3);
    person.username = textOf(row, 4);
    person.givenName = textOf(row, 5);
    person.familyName = textOf(row, 6);
    return joined({textOf(row, 1), textOf(row, 2), digestOfNames(person),
                   digestOfLogin(person.uid, {textOf(row, 7), textOf(row, 8), textOf(row, 9)})});
}

struct Table
{
    const char* name;
    const char* sql;  ///< the first column is the object, as named in the audit
    std::string (*valueOf)(const QSqlQuery& row);
};
constexpr Table kTables[]{
    {"people",
     "SELECT 'person:' || uid, role, disabled, uid, username, given_name, family_name, password_hash, reset_hash, "
     "reset_until_utc FROM people",
     asPerson},
    {"overrides",
     "SELECT 'attempt:' || a.uid, p.uid, o.given_tenths, o.reason, o.given_utc FROM overrides o JOIN attempts a ON "
     "a.id "
     "= o.attempt_id JOIN people p ON p.id = o.author_id",
     asOpinion},
    {"attempts",
     "SELECT 'attempt:' || uid, given_tenths, doubt, checked % 2 FROM attempts WHERE given_tenths IS NOT NULL OR doubt "
     "<> '' OR checked = 1",
     plain},
    {"comments",
     "SELECT 'attempt:' || a.uid, p.uid, CASE WHEN c.withdrawn_utc IS NULL THEN 0 ELSE 1 END, c.words, c.x_um, c.y_um, "
     "c.z_um, c.moment_ms, c.written_utc FROM comments c JOIN attempts a ON a.id = c.attempt_id JOIN people p ON p.id "
     "= "
     "c.author_id",
     asOpinion},
    {"classes", "SELECT 'class:' || id, name FROM classes", plain},
    {"enrolments",
     "SELECT 'person:' || p.uid, 'class:' || e.class_id FROM enrolments e JOIN people p ON p.id = e.person_id", plain},
    {"assignments",
     "SELECT 'class:' || a.class_id, a.lesson_id, p.uid, a.due_utc, a.attempt_limit, a.lesson_hash FROM assignments a "
     "JOIN people p ON p.id = a.created_by",
     plain},
    {"assigned_versions", "SELECT 'class:' || class_id, lesson_id, lesson_hash FROM assigned_versions", plain},
    {"presets",
     "SELECT 'preset:' || r.name || ' v' || r.version, COALESCE(p.uid, ''), r.hash, r.json FROM presets r LEFT JOIN "
     "people p ON p.id = r.author_id",
     asPreset},
    {"settings", "SELECT 'setting:' || name, value FROM settings WHERE owner = ''", asSetting},
    {"exam_starts",
     "SELECT 'exam:' || s.uid, p.uid, s.lesson_id, s.begun_utc FROM exam_starts s JOIN people p ON p.id = s.person_id",
     plain}};

IntegrityIssue differs(const char* table, const std::string& about)
{
    return {QT_TRANSLATE_NOOP("Finding", "%1 differs from the audit: the row of %2 was changed, added or removed"),
            {std::string("table ") + table, about}};
}

core::Status compare(const QSqlDatabase& db, const Table& table, Rows noted, const Say& say)
{
    Rows found;
    if (auto read = forEach(db, QLatin1String(table.sql), kComparing, {},
                            [&](const QSqlQuery& row) { found[textOf(row, 0)].insert(table.valueOf(row)); });
        !read)
        return read;
    for (const auto& [about, rows] : found)
        if (const auto expected = noted.extract(about); expected.empty() || expected.mapped() != rows)
            say(differs(table.name, about));
    for (const auto& [about, rows] : noted)
        if (!rows.empty())
            say(differs(table.name, about));
    return {};
}

}  // namespace

core::Status compareWithAudit(const QSqlDatabase& db, const Say& say)
{
    Noted noted;
    if (auto read =
            forEach(db,
                    "SELECT actor, action, object, detail, seq FROM audit WHERE action IN ('attempt.override', "
                    "'attempt.doubt', 'attempt.check', 'attempt.comment', 'attempt.comment.withdraw', 'lesson.assign', "
                    "'lesson.unassign', 'person.add', "
                    "'person.change', 'person.erase', 'attempt.comment.erase', 'attempt.override.erase', "
                    "'password.code', 'password.change', 'password.reset', 'password.rehash', "
                    "'class.add', 'class.rename', 'class.enrol', 'class.leave', 'preset.add', 'setting.change', "
                    "'exam.begin') ORDER BY seq",
                    kComparing, {},
                    [&](const QSqlQuery& row) {
                        if (!noted.mayDo(textOf(row, 0), textOf(row, 1)))
                            say({QT_TRANSLATE_NOOP("Finding", "row %1 of the audit was not written by Cusp: the role "
                                                              "of person:%2 did not permit %3 on %4 then"),
                                 {textOf(row, 4), textOf(row, 0), textOf(row, 1), textOf(row, 2)}});
                        noted.take(textOf(row, 0), textOf(row, 1), textOf(row, 2),
                                   QJsonDocument::fromJson(row.value(3).toByteArray()).object());
                    });
        !read)
        return read;
    for (const Table& table : kTables)
        if (auto done = compare(db, table, noted.rowsOf(table.name), say); !done)
            return done;
    return {};
}

}  // namespace database::sql
