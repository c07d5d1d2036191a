// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/sql/People.h"

#include <algorithm>
#include <map>

#include "core/base/Bytes.h"
#include "database/NameOrder.h"
#include "database/Passwords.h"
#include "database/Usernames.h"
#include "database/sql/Audit.h"
#include "database/sql/Classes.h"
#include "database/sql/Logins.h"
#include "database/sql/Statement.h"

namespace database::sql {
namespace {

using core::ErrorCode;

constexpr qsizetype kLongestPersonName = 200;

/// Returns the SQL for whether people p have a password. The account of a station cannot read the hash.
QString hasPassword(const QSqlDatabase& db)
{
    return dialect::isStation(db) ? QStringLiteral("cusp_has_password(p.id)") : QStringLiteral("p.password_hash <> ''");
}

/// Returns the columns of people p that personOf() reads.
QString personColumns(const QSqlDatabase& db)
{
    return QStringLiteral("p.id, p.uid, p.username, p.given_name, p.family_name, p.role, p.disabled, %1, "
                          "p.last_login_utc, %2, p.reset_until_utc")
        .arg(hasPassword(db),
             dialect::isStation(db) ? QStringLiteral("cusp_has_code(p.id)") : QStringLiteral("p.reset_hash <> ''"));
}

Person personOf(const QSqlQuery& row)
{
    Person person;
    person.id = {row.value(0).toLongLong()};
    person.uid = textOf(row, 1);
    person.username = textOf(row, 2);
    person.givenName = textOf(row, 3);
    person.familyName = textOf(row, 4);
    person.role = roleOf(textOf(row, 5)).value_or(Role::Student);
    person.disabled = row.value(6).toInt() != 0;
    person.hasPassword = row.value(7).toBool();
    person.lastLoginUtc = textOf(row, 8);
    if (row.value(9).toBool())
        person.codeUntilUtc = textOf(row, 10);
    return person;
}

QVariant roleText(Role role)
{
    return text(std::string(roleName(role)));
}

core::Status checkNames(const NewPerson& who)
{
    if (who.role == Role::Guest)
        return core::unexpected(ErrorCode::OutOfRange, "a person is a student, an instructor or an admin");
    for (const std::string* name : {&who.givenName, &who.familyName})
        if (auto fit = checkPersonName(*name); !fit)
            return fit;
    return {};
}

KeptLogin codeAsKept(const DatabaseContext& school, const std::string& uid, const std::string& code)
{
    const QDateTime until = school.nowUtc().addSecs(std::chrono::seconds(Logins::kCodeLife).count());
    return {{}, hashOfCode(uid, code), until.toString(Qt::ISODate).toStdString()};
}

/// Replaces a password by a one-time code.
core::Status replacePassword(const DatabaseContext& school, PersonId person, const KeptLogin& code)
{
    const std::string doing = "set a one-time code";
    if (dialect::isStation(school.db))
        return execute(school.db, "SELECT cusp_reset(?, ?, ?)", doing,
                       {number(person.value), text(code.codeHash), text(code.codeUntilUtc)});
    return execute(school.db, "UPDATE people SET password_hash = '', reset_hash = ?, reset_until_utc = ? WHERE id = ?",
                   doing, {text(code.codeHash), text(code.codeUntilUtc), number(person.value)});
}

/// @param called  for the error
core::Result<Person> personBy(const DatabaseContext& school, const QString& column, const QVariant& value,
                              const std::string& called)
{
    std::optional<Person> found;
    if (auto read = forEach(
            school.db, QStringLiteral("SELECT %1 FROM people p WHERE p.%2 = ?").arg(personColumns(school.db), column),
            "find the person", {value}, [&](const QSqlQuery& row) { found = personOf(row); });
        !read)
        return tl::unexpected(read.error());
    if (!found)
        return core::unexpected(ErrorCode::UnknownName,
                                "nobody here " + called + "; \"cusp user list\" lists who there is");
    return *found;
}

/// Returns the wanted person, but with the stored value of every field that the user has not changed.
core::Result<Person> merged(const Person& wanted, const Person& before, const std::optional<Person>& asItWas)
{
    Person person = wanted;
    bool isOverruled = false;
    const auto keepOthers = [&](auto field) {
        if (!asItWas)
            return;
        if (wanted.*field == (*asItWas).*field)
            person.*field = before.*field;
        else if (before.*field != (*asItWas).*field && before.*field != wanted.*field)
            isOverruled = true;
    };
    keepOthers(&Person::givenName);
    keepOthers(&Person::familyName);
    keepOthers(&Person::role);
    keepOthers(&Person::disabled);
    if (isOverruled)
        return core::unexpected(core::ErrorCode::ChangedSince, "the person has been changed by somebody else");
    return person;
}

/// Stores the fields that differ from `before`, inside a transaction.
core::Status storeChange(const DatabaseContext& school, AuditBatch& audit, const std::string& actor,
                         const Person& before, const Person& person)
{
    if (person.givenName == before.givenName && person.familyName == before.familyName && person.role == before.role &&
        person.disabled == before.disabled)
        return {};
    if (before.role == Role::Admin && (person.disabled || person.role != Role::Admin))
        if (auto left = expectAnotherAdmin(school, person.id); !left)
            return left;
    if (auto changed =
            execute(school.db, "UPDATE people SET given_name = ?, family_name = ?, role = ?, disabled = ? WHERE id = ?",
                    "change the person",
                    {text(person.givenName), text(person.familyName), roleText(person.role), person.disabled ? 1 : 0,
                     number(person.id.value)});
        !changed)
        return changed;
    // The audit must not contain names, because its rows cannot be erased.
    QJsonObject detail;
    if (before.role != person.role)
        detail["role"] = QString::fromUtf8(roleName(person.role).data());
    if (before.disabled != person.disabled)
        detail["disabled"] = person.disabled;
    if (before.givenName != person.givenName || before.familyName != person.familyName)
        detail["names_digest"] = QString::fromStdString(digestOfNames(person));
    return audit.note(actor, "person.change", "person:" + before.uid, detail);
}

/// Adds a person to the classes that only `wanted` contains, and removes them from those that only `present` contains.
/// Inside a transaction.
core::Status moveClasses(const DatabaseContext& school, AuditBatch& audit, const std::string& actor, PersonId person,
                         const std::vector<ClassId>& wanted, const std::vector<ClassId>& present)
{
    const auto isIn = [](const std::vector<ClassId>& classes, ClassId id) {
        return std::find(classes.begin(), classes.end(), id) != classes.end();
    };
    for (const ClassId id : wanted)
        if (!isIn(present, id))
            if (auto put = putInto(school, audit, actor, id, person); !put)
                return put;
    for (const ClassId id : present)
        if (!isIn(wanted, id))
            if (auto out = takeOutOf(school, audit, actor, id, person); !out)
                return out;
    return {};
}

}  // namespace

core::Result<Person> readPerson(const DatabaseContext& school, PersonId id)
{
    return personBy(school, QStringLiteral("id"), number(id.value), "has the number " + std::to_string(id.value));
}

core::Status expectAnotherAdmin(const DatabaseContext& school, PersonId person)
{
    const auto other = ask(school.db,
                           "SELECT 1 FROM people p WHERE p.role = 'admin' AND p.disabled = 0 AND p.id <> ? AND " +
                               hasPassword(school.db) + " LIMIT 1",
                           "see who else is an admin", {static_cast<qlonglong>(person.value)});
    if (!other)
        return tl::unexpected(other.error());
    if (other->isNull())
        return core::unexpected(ErrorCode::NobodyLeft,
                                "this is the last admin who can log in; make somebody else an admin first");
    return {};
}

core::Status expectNotErased(const Person& person)
{
    if (!person.isErased())
        return {};
    return core::unexpected(ErrorCode::ChangedSince, person.username +
                                                         " is a person who was erased and cannot come back; enter the "
                                                         "person anew if they are here again");
}

core::Status checkPersonName(const std::string& name)
{
    if (QString::fromStdString(name).toUcs4().size() > kLongestPersonName)
        return core::unexpected(ErrorCode::OutOfRange,
                                "a name has at most " + std::to_string(kLongestPersonName) + " characters; shorten it");
    if (!canBeSeen(name))
        return core::unexpected(ErrorCode::OutOfRange, "a name holds characters that cannot be seen; type it again");
    return {};
}

core::Result<std::vector<Person>> listPeople(const DatabaseContext& school, const Login& session)
{
    const auto who = authorize(school, session, Operation::ListPeople);
    if (!who)
        return tl::unexpected(who.error());
    QString where;
    QVariantList values;
    if (who->reach != Reach::All) {
        where = QStringLiteral(" WHERE p.id IN %1").arg(classmates());
        values = {static_cast<qlonglong>(session.person().value)};
    }
    std::vector<Person> people;
    if (auto read = forEach(school.db, "SELECT " + personColumns(school.db) + " FROM people p" + where,
                            "list the people", values, [&](const QSqlQuery& row) { people.push_back(personOf(row)); });
        !read)
        return tl::unexpected(read.error());
    std::sort(people.begin(), people.end(), [order = NameOrder()](const Person& a, const Person& b) {
        return order(SortedName{a.familyName, a.givenName, a.username},
                     SortedName{b.familyName, b.givenName, b.username});
    });
    std::map<std::int64_t, std::size_t> placeOf;
    for (std::size_t k = 0; k < people.size(); ++k)
        placeOf[people[k].id.value] = k;
    if (auto read =
            forEach(school.db, "SELECT person_id, class_id FROM enrolments ORDER BY class_id", "list the people", {},
                    [&](const QSqlQuery& row) {
                        if (const auto place = placeOf.find(row.value(0).toLongLong()); place != placeOf.end())
                            people[place->second].classes.push_back({row.value(1).toLongLong()});
                    });
        !read)
        return tl::unexpected(read.error());
    return people;
}

std::string digestOfNames(const Person& person)
{
    core::ByteWriter bytes;
    for (const std::string* part : {&person.uid, &person.username, &person.givenName, &person.familyName})
        bytes.putText(*part);
    return digestOf(bytes.bytes());
}

std::string digestOfLogin(const std::string& uid, const KeptLogin& kept)
{
    core::ByteWriter bytes;
    for (const std::string* part : {&uid, &kept.passwordHash, &kept.codeHash, &kept.codeUntilUtc})
        bytes.putText(*part);
    return digestOf(bytes.bytes());
}

core::Status noteLogin(const DatabaseContext& school, const std::string& actor, const std::string& action,
                       const std::string& uid, const KeptLogin& kept)
{
    return note(school, actor, action, "person:" + uid,
                {{"login_digest", QString::fromStdString(digestOfLogin(uid, kept))}});
}

core::Result<Person> enter(const DatabaseContext& school, AuditBatch& audit, const std::string& actor,
                           const NewPerson& who, const FirstLogin& login)
{
    const auto username = normalUsername(who.username);
    if (!username)
        return tl::unexpected(username.error());
    if (auto fit = checkNames(who); !fit)
        return tl::unexpected(fit.error());
    if (isPseudonym(*username))
        return core::unexpected(ErrorCode::OutOfRange, "\"" + *username +
                                                           "\" is what an erased person is called; choose another "
                                                           "user's name");
    const auto taken = ask(school.db, "SELECT 1 FROM people WHERE username = ?", "enter the person", {text(*username)});
    if (!taken)
        return tl::unexpected(taken.error());
    if (!taken->isNull())
        return core::unexpected(ErrorCode::OutOfRange,
                                "there is somebody called \"" + *username + "\" already; choose another user's name");
    Person person;
    person.uid = newUid();
    person.username = *username;
    person.givenName = who.givenName;
    person.familyName = who.familyName;
    person.role = who.role;
    person.hasPassword = !login.passwordHash.empty();
    KeptLogin kept;
    if (!login.code.empty())
        kept = codeAsKept(school, person.uid, login.code);
    person.codeUntilUtc = kept.codeUntilUtc;
    kept.passwordHash = login.passwordHash;
    auto added = ask(school.db,
                     "INSERT INTO people (uid, username, given_name, family_name, role, password_hash, reset_hash, "
                     "reset_until_utc, disabled, created_utc, last_login_utc) VALUES (?, ?, ?, ?, ?, ?, ?, ?, 0, ?, "
                     "'') RETURNING id",
                     "enter the person",
                     {text(person.uid), text(person.username), text(person.givenName), text(person.familyName),
                      roleText(person.role), text(kept.passwordHash), text(kept.codeHash), text(kept.codeUntilUtc),
                      text(school.now())});
    if (!added)
        return tl::unexpected(added.error());
    person.id = {added->toLongLong()};
    if (auto noted = audit.note(actor, "person.add", "person:" + person.uid,
                                {{"role", QString::fromUtf8(roleName(person.role).data())},
                                 {"names_digest", QString::fromStdString(digestOfNames(person))},
                                 {"login_digest", QString::fromStdString(digestOfLogin(person.uid, kept))}});
        !noted)
        return tl::unexpected(noted.error());
    return person;
}

core::Result<Entered> addPerson(const DatabaseContext& school, const Login& session, const NewPerson& who,
                                const std::vector<ClassId>& classes)
{
    if (auto may = authorize(school, session, Operation::AddPerson); !may)
        return tl::unexpected(may.error());
    if (!classes.empty())
        if (auto may = authorize(school, session, Operation::ChangeClasses); !may)
            return tl::unexpected(may.error());
    return inTurn(school, "enter the person", [&]() -> core::Result<Entered> {
        AuditBatch audit(school);
        const std::string code = newCode();
        auto person = enter(school, audit, session.uid(), who, {{}, code});
        if (!person)
            return tl::unexpected(person.error());
        if (auto moved = moveClasses(school, audit, session.uid(), person->id, classes, {}); !moved)
            return tl::unexpected(moved.error());
        person->classes = classes;
        if (auto sealed = audit.seal(); !sealed)
            return tl::unexpected(sealed.error());
        return Entered{std::move(*person), code};
    });
}

core::Result<Person> changePerson(const DatabaseContext& school, const Login& session, const Person& wanted,
                                  const std::optional<Person>& asItWas)
{
    if (auto may = authorize(school, session, Operation::ChangePerson); !may)
        return tl::unexpected(may.error());
    if (asItWas && asItWas->classes != wanted.classes)
        if (auto may = authorize(school, session, Operation::ChangeClasses); !may)
            return tl::unexpected(may.error());
    if (auto fit = checkNames({wanted.username, wanted.givenName, wanted.familyName, wanted.role}); !fit)
        return tl::unexpected(fit.error());
    return inTurn(school, "change the person", [&]() -> core::Result<Person> {
        const auto before = readPerson(school, wanted.id);
        if (!before)
            return tl::unexpected(before.error());
        if (auto is = expectNotErased(*before); !is)
            return tl::unexpected(is.error());
        auto person = merged(wanted, *before, asItWas);
        if (!person)
            return person;
        AuditBatch audit(school);
        if (auto stored = storeChange(school, audit, session.uid(), *before, *person); !stored)
            return tl::unexpected(stored.error());
        if (asItWas)
            if (auto moved = moveClasses(school, audit, session.uid(), person->id, wanted.classes, asItWas->classes);
                !moved)
                return tl::unexpected(moved.error());
        if (auto sealed = audit.seal(); !sealed)
            return tl::unexpected(sealed.error());
        return person;
    });
}

core::Result<Entered> resetPassword(const DatabaseContext& school, const Login& session, PersonId person)
{
    if (auto may = authorize(school, session, Operation::ResetPassword); !may)
        return tl::unexpected(may.error());
    return inTurn(school, "set a one-time code", [&]() -> core::Result<Entered> {
        auto who = readPerson(school, person);
        if (!who)
            return tl::unexpected(who.error());
        if (auto is = expectNotErased(*who); !is)
            return tl::unexpected(is.error());
        if (who->role == Role::Admin)
            if (auto left = expectAnotherAdmin(school, person); !left)
                return tl::unexpected(left.error());
        const std::string code = newCode();
        const KeptLogin kept = codeAsKept(school, who->uid, code);
        if (auto set = replacePassword(school, person, kept); !set)
            return tl::unexpected(set.error());
        if (auto forgiven = execute(school.db, "DELETE FROM failed_logins WHERE name_hash LIKE ?",
                                    "set a one-time code", {text(digestOf(who->username) + '%')});
            !forgiven)
            return tl::unexpected(forgiven.error());
        if (auto noted = noteLogin(school, session.uid(), "password.reset", who->uid, kept); !noted)
            return tl::unexpected(noted.error());
        who->hasPassword = false;
        who->codeUntilUtc = kept.codeUntilUtc;
        return Entered{std::move(*who), code};
    });
}

core::Result<Person> findPerson(const DatabaseContext& school, const Login& session, const std::string& username)
{
    const auto who = authorize(school, session, Operation::ChangePerson);
    if (!who)
        return tl::unexpected(who.error());
    const auto name = normalUsername(username);
    if (!name)
        return tl::unexpected(name.error());
    return personBy(school, QStringLiteral("username"), text(*name), "is called \"" + *name + '"');
}

}  // namespace database::sql
