// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/sql/Noted.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include <QCryptographicHash>
#include <QDateTime>
#include <QJsonDocument>
#include <QJsonObject>

#include "database/Passwords.h"
#include "database/sql/Attempts.h"
#include "database/sql/People.h"
#include "database/sql/Statement.h"

namespace database::sql {
namespace {

using Say = std::function<void(const Finding&)>;

const std::string kDoing = "check it";
constexpr int kMachines = -1;  ///< no score of a teacher

/// What a teacher said of an attempt.
struct Opinion
{
    std::string author;  ///< uid
    std::optional<int> tenths;
    std::string digest;       ///< of the words; empty: not noted
    std::string digestOfAll;  ///< of the words with the date, and of a comment its place and moment; empty: not noted
};
/// By the uid of the attempt, in the order of saying.
using Opinions = std::map<std::string, std::vector<Opinion>>;

struct Standing
{
    std::string role;
    bool disabled = false;
    std::string names;  ///< digest; empty: noted before there was one
};
/// Class and uid.
using Enrolments = std::set<std::pair<std::string, std::string>>;

/// Who made something, and when.
struct Origin
{
    std::string author;  ///< uid
    QDateTime at;
};

/// Comments that were taken back, and when: by the uid of the attempt and the digest of what was said. Two may say the
/// same.
using Withdrawn = std::multimap<std::pair<std::string, std::string>, Origin>;

struct Given
{
    std::string due;
    int limit = 0;
    Origin origin;  ///< of the first time since it was taken back
};

/// All that the audit says of other tables.
struct Noted
{
    Opinions overrides;
    Opinions comments;
    Withdrawn withdrawn;
    std::map<std::string, Standing> people;                                           ///< by uid
    std::map<std::pair<std::string, std::string>, std::optional<Given>> assignments;  ///< by class and lesson
    std::map<std::string, std::string> classes;                                       ///< names, by number
    Enrolments enrolments;
    std::map<std::string, std::string> presets;   ///< hashes, by name and version
    std::map<std::string, Origin> presetOrigins;  ///< the same
    std::map<std::string, std::string> settings;  ///< digests of the school's values, by name
    bool areSettingsWhole = false;                ///< made by a program that noted all from the beginning
};

std::string textIn(const QJsonObject& detail, const char* key)
{
    return detail.value(QLatin1String(key)).toString().toStdString();
}

std::string afterColon(const std::string& object)
{
    return object.substr(object.find(':') + 1);
}

QDateTime momentOf(const QString& utc)
{
    return QDateTime::fromString(utc, Qt::ISODate);
}

/// The clock is asked once for what is made, and again for the audit.
/// @param row  has in the column `first` whose a thing is, by uid, and behind that when it was made
bool isFrom(const Origin& noted, const QSqlQuery& row, int first)
{
    constexpr qint64 kMostBetweenS = 60;
    const QDateTime made = momentOf(row.value(first + 1).toString());
    return textOf(row, first) == noted.author && made.isValid() && std::abs(made.secsTo(noted.at)) <= kMostBetweenS;
}

void take(Noted& noted, const Origin& origin, const std::string& action, const std::string& object,
          const QJsonObject& detail)
{
    const std::string& actor = origin.author;
    const std::string id = afterColon(object);
    if (action == "attempt.override") {
        const QJsonValue given = detail.value(QStringLiteral("given_tenths"));
        noted.overrides[id].push_back({actor, given.isDouble() ? std::optional(given.toInt()) : std::nullopt,
                                       textIn(detail, "reason_digest"), textIn(detail, "digest_of_all")});
    } else if (action == "attempt.comment") {
        noted.comments[id].push_back({actor, {}, textIn(detail, "digest"), textIn(detail, "digest_of_all")});
    } else if (action == "attempt.comment.withdraw") {
        noted.withdrawn.emplace(std::pair(id, textIn(detail, "digest_of_all")), origin);
    } else if (action == "preset.add") {
        noted.presets[id] = textIn(detail, "hash");
        noted.presetOrigins[id] = origin;
    } else if (action == "setting.change") {
        noted.settings[id] =
            detail.contains(QStringLiteral("digest")) ? textIn(detail, "digest") : digestOf(textIn(detail, "value"));
        noted.areSettingsWhole = noted.areSettingsWhole || actor == "system";
    } else if (action == "lesson.assign") {
        auto& given = noted.assignments[{id, textIn(detail, "lesson")}];
        given =
            Given{textIn(detail, "due"), detail.value(QStringLiteral("limit")).toInt(), given ? given->origin : origin};
    } else if (action == "lesson.unassign") {
        noted.assignments[{id, textIn(detail, "lesson")}].reset();
    } else if (action == "class.add" || action == "class.rename") {
        noted.classes[id] = textIn(detail, "name");
    } else if (action == "class.enrol") {
        noted.enrolments.emplace(id, textIn(detail, "person"));
    } else if (action == "class.leave") {
        noted.enrolments.erase({id, textIn(detail, "person")});
    } else {
        Standing& person = noted.people[id];
        if (detail.contains(QStringLiteral("role")))
            person.role = textIn(detail, "role");
        if (detail.contains(QStringLiteral("disabled")))
            person.disabled = detail.value(QStringLiteral("disabled")).toBool();
        if (detail.contains(QStringLiteral("names_digest")))
            person.names = textIn(detail, "names_digest");
    }
}

/// What is said of an opinion.
struct OpinionWords
{
    const char* inserted;
    const char* notNoted;  ///< the same where the audit has lost rows
    const char* changed;
    const char* removed;
};
constexpr OpinionWords kOverride{
    QT_TRANSLATE_NOOP("Finding", "an override of %1 was inserted: the audit knows nothing of it"),
    QT_TRANSLATE_NOOP("Finding", "an override of %1 is not noted in the audit: it was inserted, or the note of it is "
                                 "among the rows of the audit that were removed or changed"),
    QT_TRANSLATE_NOOP("Finding", "an override of %1 was changed after it had been noted"),
    QT_TRANSLATE_NOOP("Finding", "an override of %1 was removed")};
constexpr OpinionWords kComment{
    QT_TRANSLATE_NOOP("Finding", "a comment on %1 was inserted: the audit knows nothing of it"),
    QT_TRANSLATE_NOOP("Finding", "a comment on %1 is not noted in the audit: it was inserted, or the note of it is "
                                 "among the rows of the audit that were removed or changed"),
    QT_TRANSLATE_NOOP("Finding", "a comment on %1 was changed after it had been noted"),
    QT_TRANSLATE_NOOP("Finding", "a comment on %1 was removed")};
constexpr const char* kRemoved = QT_TRANSLATE_NOOP("Finding", "%1 was removed");
constexpr const char* kOtherwise = QT_TRANSLATE_NOOP("Finding", "%1 is not what the audit says");

core::Status compareOpinions(const QSqlDatabase& db, const char* sql, const Opinions& expected,
                             const OpinionWords& words, bool lacksNotes, const Say& say)
{
    std::map<std::string, std::size_t> seen;
    if (auto read = forEach(
            db, QLatin1String(sql), kDoing, {},
            [&](const QSqlQuery& row) {
                const std::string attempt = textOf(row, 0);
                const std::size_t n = seen[attempt]++;
                const auto found = expected.find(attempt);
                const Opinion* const noted =
                    found != expected.end() && n < found->second.size() ? &found->second[n] : nullptr;
                const int tenths = row.isNull(2) ? kMachines : row.value(2).toInt();
                if (noted == nullptr)
                    say({lacksNotes ? words.notNoted : words.inserted, {"attempt:" + attempt}});
                else if (noted->author != textOf(row, 1) || noted->tenths.value_or(kMachines) != tenths ||
                         (!noted->digest.empty() && noted->digest != digestOf(textOf(row, 3))) ||
                         (!noted->digestOfAll.empty() && noted->digestOfAll != digestOfComment(valuesOf(row, 3))))
                    say({words.changed, {"attempt:" + attempt}});
            });
        !read)
        return read;
    for (const auto& [attempt, opinions] : expected)
        if (opinions.size() > seen[attempt])
            say({words.removed, {"attempt:" + attempt}});
    return {};
}

core::Status compareWithdrawn(const QSqlDatabase& db, Withdrawn expected, const Say& say)
{
    if (auto read = forEach(
            db,
            "SELECT a.uid, p.uid, c.withdrawn_utc, c.words, c.x_um, c.y_um, c.z_um, c.moment_ms, c.written_utc FROM "
            "comments c JOIN attempts a ON a.id = c.attempt_id JOIN people p ON p.id = c.author_id "
            "WHERE c.withdrawn_utc IS NOT NULL",
            kDoing, {},
            [&](const QSqlQuery& row) {
                const auto [first, last] = expected.equal_range({textOf(row, 0), digestOfComment(valuesOf(row, 3))});
                const auto found =
                    std::find_if(first, last, [&row](const auto& noted) { return isFrom(noted.second, row, 1); });
                if (found != last)
                    expected.erase(found);
                else
                    say({QT_TRANSLATE_NOOP("Finding", "a comment on %1 was taken back, and it was not noted"),
                         {"attempt:" + textOf(row, 0)}});
            });
        !read)
        return read;
    for (const auto& [said, origin] : expected)
        say({QT_TRANSLATE_NOOP("Finding", "a comment on %1 that was taken back is there again, changed or removed"),
             {"attempt:" + said.first}});
    return {};
}

/// What counts instead of the machine's score is what was given last.
core::Status compareScores(const QSqlDatabase& db, const Opinions& overrides, const Say& say)
{
    std::map<std::string, int> given;
    if (auto read = forEach(db, "SELECT uid, given_tenths FROM attempts WHERE given_tenths IS NOT NULL", kDoing, {},
                            [&](const QSqlQuery& row) { given[textOf(row, 0)] = row.value(1).toInt(); });
        !read)
        return read;
    const auto differs = [&](const std::string& attempt) {
        say({QT_TRANSLATE_NOOP("Finding", "%1 has another score than the audit says was given to it"),
             {"attempt:" + attempt}});
    };
    for (const auto& [attempt, tenths] : given)
        if (const auto found = overrides.find(attempt);
            found == overrides.end() || found->second.back().tenths.value_or(kMachines) != tenths)
            differs(attempt);
    for (const auto& [attempt, opinions] : overrides)
        if (opinions.back().tenths && given.count(attempt) == 0)
            differs(attempt);
    return {};
}

core::Status comparePeople(const QSqlDatabase& db, std::map<std::string, Standing> expected, bool lacksNotes,
                           const Say& say)
{
    if (auto read =
            forEach(db, "SELECT uid, role, disabled, username, given_name, family_name FROM people", kDoing, {},
                    [&](const QSqlQuery& row) {
                        const auto found = expected.find(textOf(row, 0));
                        if (found == expected.end()) {
                            say({wordsOfUnnoted(lacksNotes), {"person:" + textOf(row, 0)}});
                            return;
                        }
                        if (found->second.role != textOf(row, 1))
                            say({QT_TRANSLATE_NOOP("Finding", "%1 has the role %2, the audit says %3"),
                                 {"person:" + textOf(row, 0), textOf(row, 1), found->second.role}});
                        if (found->second.disabled != (row.value(2).toInt() != 0))
                            say({QT_TRANSLATE_NOOP("Finding", "%1 was disabled or enabled, and it was not noted"),
                                 {"person:" + textOf(row, 0)}});
                        Person person;
                        person.uid = textOf(row, 0);
                        person.username = textOf(row, 3);
                        person.givenName = textOf(row, 4);
                        person.familyName = textOf(row, 5);
                        if (!found->second.names.empty() && found->second.names != digestOfNames(person))
                            say({QT_TRANSLATE_NOOP("Finding", "%1 was given another name, and it was not noted"),
                                 {"person:" + person.uid}});
                        expected.erase(found);
                    });
        !read)
        return read;
    for (const auto& [uid, person] : expected)
        say({kRemoved, {"person:" + uid}});
    return {};
}

/// A password that nobody can read is told, however it came there.
void compareLogin(const std::string& uid, const KeptLogin& kept, const std::string& noted, const Say& say)
{
    const std::vector<std::string> named{"person:" + uid};
    if (!kept.passwordHash.empty() && !isPasswordHash(kept.passwordHash))
        say({QT_TRANSLATE_NOOP("Finding", "the password of %1 cannot be read, and lets nobody in: reset it, or restore "
                                          "a backup"),
             named});
    else if (!noted.empty() && noted != digestOfLogin(uid, kept))
        say({QT_TRANSLATE_NOOP("Finding", "the password or the one-time code of %1 was changed without a note in the "
                                          "audit: reset it, or restore a backup"),
             named});
}

/// In one statement: somebody may just be logging in, and his password be hashed anew. Where an older program has
/// changed one since, its note has no digest, and it is not known what it is.
core::Status compareLogins(const QSqlDatabase& db, const Say& say)
{
    return forEach(db,
                   "SELECT p.uid, p.password_hash, p.reset_hash, p.reset_until_utc, COALESCE(u.detail, '') FROM people "
                   "p LEFT JOIN (SELECT object, MAX(seq) AS newest FROM audit WHERE action IN ('person.add', "
                   "'password.code', 'password.change', 'password.reset', 'password.rehash') GROUP BY object) n ON "
                   "n.object = 'person:' || p.uid LEFT JOIN audit u ON u.seq = n.newest",
                   kDoing, {}, [&](const QSqlQuery& row) {
                       const QJsonObject noted = QJsonDocument::fromJson(row.value(4).toByteArray()).object();
                       compareLogin(textOf(row, 0), {textOf(row, 1), textOf(row, 2), textOf(row, 3)},
                                    textIn(noted, "login_digest"), say);
                   });
}

core::Status compareAssignments(const QSqlDatabase& db,
                                std::map<std::pair<std::string, std::string>, std::optional<Given>> expected,
                                const Say& say)
{
    if (auto read = forEach(
            db,
            "SELECT a.class_id, a.lesson_id, a.due_utc, a.attempt_limit, p.uid, a.created_utc FROM assignments a JOIN "
            "people p ON p.id = a.created_by",
            kDoing, {},
            [&](const QSqlQuery& row) {
                const auto found = expected.find({textOf(row, 0), textOf(row, 1)});
                const bool isNoted = found != expected.end() && found->second;
                if (!isNoted || found->second->due != textOf(row, 2) || found->second->limit != row.value(3).toInt() ||
                    !isFrom(found->second->origin, row, 4))
                    say({QT_TRANSLATE_NOOP("Finding", "what %1 was given of the lesson %2 is not what the audit says"),
                         {"class:" + textOf(row, 0), textOf(row, 1)}});
                if (found != expected.end())
                    expected.erase(found);
            });
        !read)
        return read;
    for (const auto& [key, given] : expected)
        if (given)
            say({QT_TRANSLATE_NOOP("Finding", "that %1 was given the lesson %2 was removed"),
                 {"class:" + key.first, key.second}});
    return {};
}

core::Status compareClasses(const QSqlDatabase& db, std::map<std::string, std::string> names, Enrolments expected,
                            bool lacksNotes, const Say& say)
{
    if (auto read = forEach(db, "SELECT id, name FROM classes", kDoing, {},
                            [&](const QSqlQuery& row) {
                                const auto found = names.find(textOf(row, 0));
                                if (found == names.end()) {
                                    say({wordsOfUnnoted(lacksNotes), {"class:" + textOf(row, 0)}});
                                    return;
                                }
                                if (found->second != textOf(row, 1))
                                    say({QT_TRANSLATE_NOOP("Finding", "%1 was renamed, and it was not noted"),
                                         {"class:" + textOf(row, 0)}});
                                names.erase(found);
                            });
        !read)
        return read;
    for (const auto& [id, name] : names)
        say({kRemoved, {"class:" + id}});
    if (auto read =
            forEach(db, "SELECT e.class_id, p.uid FROM enrolments e JOIN people p ON p.id = e.person_id", kDoing, {},
                    [&](const QSqlQuery& row) {
                        if (expected.erase({textOf(row, 0), textOf(row, 1)}) == 0)
                            say({QT_TRANSLATE_NOOP("Finding", "%1 was put into %2, and it was not noted"),
                                 {"person:" + textOf(row, 1), "class:" + textOf(row, 0)}});
                    });
        !read)
        return read;
    for (const auto& [ofClass, person] : expected)
        say({QT_TRANSLATE_NOOP("Finding", "%1 was taken out of %2, and it was not noted"),
             {"person:" + person, "class:" + ofClass}});
    return {};
}

/// What schools have whose settings were not all noted.
bool isOfLogins(const std::string& setting)
{
    return setting.rfind("password.", 0) == 0;
}

/// Presets were changed where their hash is not that of what they say, or they are another's than was noted.
core::Status comparePresets(const QSqlDatabase& db, const std::map<std::string, Origin>& origins, const Say& say)
{
    return forEach(db,
                   "SELECT r.name || ' v' || r.version, r.hash, r.json, COALESCE(p.uid, ''), r.created_utc FROM "
                   "presets r LEFT JOIN people p ON p.id = r.author_id",
                   kDoing, {}, [&](const QSqlQuery& row) {
                       const QByteArray hash =
                           QCryptographicHash::hash(row.value(2).toString().toUtf8(), QCryptographicHash::Sha256);
                       const auto origin = origins.find(textOf(row, 0));
                       if (hash.toHex().toStdString() != textOf(row, 1) ||
                           (origin != origins.end() && !isFrom(origin->second, row, 3)))
                           say({kOtherwise, {"preset:" + textOf(row, 0)}});
                   });
}

/// @param asNoted  what the audit has of a row
/// @param mustBeNoted  else some was there from the beginning
core::Status compareKept(const QSqlDatabase& db, const QString& sql, std::map<std::string, std::string> expected,
                         const std::function<std::string(const std::string& value)>& asNoted,
                         const std::function<bool(const std::string& name)>& mustBeNoted, const std::string& kind,
                         bool lacksNotes, const Say& say)
{
    if (auto read = forEach(db, sql, kDoing, {},
                            [&](const QSqlQuery& row) {
                                const std::string named = kind + ':' + textOf(row, 0);
                                const auto found = expected.find(textOf(row, 0));
                                if (found == expected.end()) {
                                    if (mustBeNoted(textOf(row, 0)))
                                        say({wordsOfUnnoted(lacksNotes), {named}});
                                    return;
                                }
                                if (found->second != asNoted(textOf(row, 1)))
                                    say({kOtherwise, {named}});
                                expected.erase(found);
                            });
        !read)
        return read;
    for (const auto& [name, value] : expected)
        say({kRemoved, {std::string(kind).append(":").append(name)}});
    return {};
}

/// An attempt that is nobody's counts for nobody. Those from before there were people are called by their number, and
/// come before all others.
core::Status compareOwners(const QSqlDatabase& db, bool lacksNotes, const Say& say)
{
    if (auto read = forEach(db,
                            "SELECT a.uid FROM attempts a WHERE a.person_id IS NULL AND NOT EXISTS (SELECT 1 FROM "
                            "audit u WHERE u.object = 'attempt:' || a.uid AND u.action = 'attempt.add') AND NOT (a.uid "
                            "= 'legacy-' || a.id AND a.id > 0 AND a.id < COALESCE((SELECT MIN(b.id) FROM attempts b "
                            "WHERE b.person_id IS NOT NULL), a.id + 1))",
                            kDoing, {},
                            [&](const QSqlQuery& row) {
                                say({wordsOfUnnoted(lacksNotes), {"attempt:" + textOf(row, 0)}});
                            });
        !read)
        return read;
    return forEach(db,
                   "SELECT a.uid FROM attempts a WHERE a.person_id IS NULL AND EXISTS (SELECT 1 FROM audit u WHERE "
                   "u.object = 'attempt:' || a.uid AND u.action = 'attempt.add')",
                   kDoing, {}, [&](const QSqlQuery& row) {
                       say({QT_TRANSLATE_NOOP("Finding", "%1 was taken from the person who made it"),
                            {"attempt:" + textOf(row, 0)}});
                   });
}

}  // namespace

const char* wordsOfUnnoted(bool lacksNotes)
{
    return lacksNotes ? QT_TRANSLATE_NOOP("Finding", "%1 is not noted in the audit: it was inserted, or the note of it "
                                                     "is among the rows of the audit that were removed or changed")
                      : QT_TRANSLATE_NOOP("Finding", "%1 was inserted: the audit knows nothing of it");
}

core::Status compareWithAudit(const QSqlDatabase& db, bool lacksNotes, const Say& say)
{
    Noted noted;
    if (auto read =
            forEach(db,
                    "SELECT actor, at_utc, action, object, detail FROM audit WHERE action IN ('attempt.override', "
                    "'attempt.comment', 'attempt.comment.withdraw', 'lesson.assign', 'lesson.unassign', 'person.add', "
                    "'person.change', "
                    "'class.add', 'class.rename', 'class.enrol', 'class.leave', 'preset.add', 'setting.change') "
                    "ORDER BY seq",
                    kDoing, {},
                    [&](const QSqlQuery& row) {
                        take(noted, {textOf(row, 0), momentOf(row.value(1).toString())}, textOf(row, 2), textOf(row, 3),
                             QJsonDocument::fromJson(row.value(4).toByteArray()).object());
                    });
        !read)
        return read;
    const auto asItIs = [](const std::string& value) { return value; };
    const auto digest = [](const std::string& value) { return digestOf(value); };
    const auto always = [](const std::string&) { return true; };
    const auto must = [&noted](const std::string& name) { return noted.areSettingsWhole || !isOfLogins(name); };
    for (const auto& done :
         {compareOpinions(
              db,
              "SELECT a.uid, p.uid, o.given_tenths, o.reason, o.given_utc FROM overrides o JOIN attempts a ON a.id = "
              "o.attempt_id JOIN people p ON p.id = o.author_id ORDER BY o.id",
              noted.overrides, kOverride, lacksNotes, say),
          compareOpinions(db,
                          "SELECT a.uid, p.uid, NULL, c.words, c.x_um, c.y_um, c.z_um, c.moment_ms, c.written_utc FROM "
                          "comments c JOIN attempts a ON a.id = c.attempt_id "
                          "JOIN people p ON p.id = c.author_id ORDER BY c.id",
                          noted.comments, kComment, lacksNotes, say),
          compareWithdrawn(db, noted.withdrawn, say), compareScores(db, noted.overrides, say),
          comparePeople(db, noted.people, lacksNotes, say), compareLogins(db, say),
          compareAssignments(db, noted.assignments, say),
          compareClasses(db, noted.classes, noted.enrolments, lacksNotes, say),
          compareKept(db, "SELECT name || ' v' || version, hash FROM presets", noted.presets, asItIs, always, "preset",
                      lacksNotes, say),
          comparePresets(db, noted.presetOrigins, say),
          compareKept(db, "SELECT name, value FROM settings WHERE owner = ''", noted.settings, digest, must, "setting",
                      lacksNotes, say),
          compareOwners(db, lacksNotes, say)})
        if (!done)
            return done;
    return {};
}

}  // namespace database::sql
