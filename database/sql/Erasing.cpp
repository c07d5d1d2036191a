// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/sql/Erasing.h"

#include <utility>
#include <vector>

#include "database/Passwords.h"
#include "database/sql/Attempts.h"
#include "database/sql/Audit.h"
#include "database/sql/Classes.h"
#include "database/sql/Grants.h"
#include "database/sql/People.h"
#include "database/sql/Statement.h"

namespace database::sql {
namespace {

using core::ErrorCode;

const std::string kErasing = "erase the person";

/// A transaction that erases a person.
struct Erasure
{
    const DatabaseContext& school;
    AuditBatch& audit;
    const std::string& actor;  ///< uid, for the audit
};

core::Status expectErasable(const DatabaseContext& school, const Login& session, const Person& person)
{
    if (person.isErased())
        return core::unexpected(ErrorCode::ChangedSince, person.username + " has been erased already");
    if (person.role == Role::Admin)
        if (auto left = expectAnotherAdmin(school, person.id); !left)
            return left;
    if (person.id == session.person())
        return core::unexpected(ErrorCode::NotAllowed,
                                "you cannot erase the account that you are using; another admin can");
    return {};
}

/// Erases the names and the login, and returns the person as they are then.
core::Result<Person> eraseNames(const Erasure& erasure, const Person& before)
{
    Person person = before;
    person.username = before.pseudonym();
    person.givenName.clear();
    person.familyName.clear();
    person.disabled = true;
    person.hasPassword = false;
    person.codeUntilUtc.clear();
    person.lastLoginUtc.clear();
    const QSqlDatabase& db = erasure.school.db;
    if (auto done = execute(db,
                            "UPDATE people SET username = ?, given_name = '', family_name = '', password_hash = '', "
                            "reset_hash = '', reset_until_utc = '', last_login_utc = '', disabled = 1 WHERE id = ?",
                            kErasing, {text(person.username), number(person.id.value)});
        !done)
        return tl::unexpected(done.error());
    const std::string name = digestOf(before.username);
    if (auto done = execute(db, "DELETE FROM failed_logins WHERE name_hash LIKE ? OR name_hash = ?", kErasing,
                            {text(name + '%'), text("try:" + name)});
        !done)
        return tl::unexpected(done.error());
    if (auto done = execute(db, "DELETE FROM settings WHERE owner = ?", kErasing, {text(person.uid)}); !done)
        return tl::unexpected(done.error());
    if (auto noted =
            erasure.audit.note(erasure.actor, "person.erase", "person:" + person.uid,
                               {{"disabled", true},
                                {"names_digest", QString::fromStdString(digestOfNames(person))},
                                {"login_digest", QString::fromStdString(digestOfLogin(person.uid, KeptLogin()))}});
        !noted)
        return tl::unexpected(noted.error());
    return person;
}

/// A column with texts about attempts.
struct TextColumn
{
    const char* table;
    const char* column;
    const char* digested;  ///< the columns of its digest, see digestOfComment()
    const char* whose;     ///< condition on the attempts a and the table t, with the person for each "%1"
    const char* action;    ///< in the audit
};
constexpr TextColumn kTextColumns[]{
    {"comments", "words", "t.words, t.x_um, t.y_um, t.z_um, t.moment_ms, t.written_utc",
     "a.person_id = %1 OR t.author_id = %1", "attempt.comment.erase"},
    {"overrides", "reason", "t.reason, t.given_utc", "a.person_id = %1", "attempt.override.erase"},
};

core::Status eraseTexts(const Erasure& erasure, PersonId person, const TextColumn& where)
{
    struct Text
    {
        std::int64_t id = 0;
        std::string attemptUid;
        std::string authorUid;
        QVariantList digested;
    };
    std::vector<Text> texts;
    if (auto read = forEach(
            erasure.school.db,
            QStringLiteral("SELECT t.id, a.uid, p.uid, %1 FROM %2 t JOIN attempts a ON a.id = "
                           "t.attempt_id JOIN people p ON p.id = t.author_id WHERE %3 ORDER BY t.id")
                .arg(QLatin1String(where.digested), QLatin1String(where.table),
                     QString::fromLatin1(where.whose).arg(person.value)),
            kErasing, {},
            [&](const QSqlQuery& row) {
                texts.push_back({row.value(0).toLongLong(), textOf(row, 1), textOf(row, 2), sql::valuesOf(row, 3)});
            });
        !read)
        return read;
    const QString erase = QStringLiteral("UPDATE %1 SET %2 = ? WHERE id = ?")
                              .arg(QLatin1String(where.table), QLatin1String(where.column));
    for (const Text& one : texts) {
        if (auto done = execute(erasure.school.db, erase, kErasing, {text(kErasedText), number(one.id)}); !done)
            return done;
        QVariantList now = one.digested;
        now.front() = text(kErasedText);
        if (auto noted = erasure.audit.note(erasure.actor, where.action, "attempt:" + one.attemptUid,
                                            {{"author", QString::fromStdString(one.authorUid)},
                                             {"digest_before", QString::fromStdString(digestOfComment(one.digested))},
                                             {"digest_of_all", QString::fromStdString(digestOfComment(now))}});
            !noted)
            return noted;
    }
    return {};
}

core::Status leaveClasses(const Erasure& erasure, PersonId person)
{
    std::vector<ClassId> classes;
    if (auto read = forEach(erasure.school.db, "SELECT class_id FROM enrolments WHERE person_id = ? ORDER BY class_id",
                            kErasing, {number(person.value)},
                            [&](const QSqlQuery& row) { classes.push_back({row.value(0).toLongLong()}); });
        !read)
        return read;
    for (const ClassId id : classes)
        if (auto out = takeOutOf(erasure.school, erasure.audit, erasure.actor, id, person); !out)
            return out;
    return {};
}

}  // namespace

core::Result<ErasedPerson> erasePerson(const DatabaseContext& school, const Login& session, PersonId id)
{
    if (auto may = authorize(school, session, Operation::ChangePerson); !may)
        return tl::unexpected(may.error());
    if (auto may = expectOwner(school.db, "cusp user erase"); !may)
        return tl::unexpected(may.error());
    auto erased = inTurn(school, kErasing, [&]() -> core::Result<Person> {
        auto before = readPerson(school, id);
        if (!before)
            return before;
        if (auto is = expectErasable(school, session, *before); !is)
            return tl::unexpected(is.error());
        AuditBatch audit(school);
        const Erasure erasure{school, audit, session.uid()};
        // Names first: the database lets reasons change only of a person who is erased.
        auto person = eraseNames(erasure, *before);
        if (!person)
            return person;
        for (const TextColumn& column : kTextColumns)
            if (auto done = eraseTexts(erasure, id, column); !done)
                return tl::unexpected(done.error());
        if (auto left = leaveClasses(erasure, id); !left)
            return tl::unexpected(left.error());
        if (auto sealed = audit.seal(); !sealed)
            return tl::unexpected(sealed.error());
        return person;
    });
    if (!erased)
        return tl::unexpected(erased.error());
    return ErasedPerson{std::move(*erased), dialect::overwriteUnused(school.db).has_value()};
}

}  // namespace database::sql
