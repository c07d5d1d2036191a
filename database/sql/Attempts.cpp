// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/sql/Attempts.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QStringList>

#include "core/base/Bytes.h"
#include "database/ClassOverview.h"
#include "database/Passwords.h"
#include "database/sql/Audit.h"
#include "database/sql/Doubts.h"
#include "database/sql/Recordings.h"
#include "database/sql/Statement.h"

namespace database::sql {
namespace {

using core::ErrorCode;

const std::string kAdd = "add the attempt";
const std::string kReadAttempts = "read the attempts";
constexpr double kUmPerMm = 1000.0;

std::string criteriaJson(const std::vector<CriterionLoss>& criteria)
{
    QJsonArray rows;
    for (const CriterionLoss& criterion : criteria)
        rows += QJsonArray{QString::fromStdString(criterion.id), criterion.lostTenths, criterion.weightTenths};
    return QJsonDocument(rows).toJson(QJsonDocument::Compact).toStdString();
}

std::vector<CriterionLoss> criteriaOf(const QByteArray& json)
{
    std::vector<CriterionLoss> criteria;
    const QJsonArray rows = QJsonDocument::fromJson(json).array();
    for (const auto& row : rows)
        criteria.push_back(
            {row.toArray().at(0).toString().toStdString(), row.toArray().at(1).toInt(), row.toArray().at(2).toInt()});
    return criteria;
}

/// The mapping between a column of the table "attempts" and the record.
struct Column
{
    const char* name;
    QVariant (*write)(const AttemptRecord& record);
    void (*read)(const QVariant& value, AttemptRecord& record);
    bool isInserted = true;  ///< false: the column gets its value later, or from the database
};

QVariant toColumn(const std::string& value)
{
    return text(value);
}
QVariant toColumn(std::int64_t value)
{
    return number(value);
}
QVariant toColumn(int value)
{
    return value;
}
QVariant toColumn(bool value)
{
    return value ? 1 : 0;
}
QVariant toColumn(const std::optional<int>& value)
{
    return value ? QVariant(*value) : QVariant();
}
QVariant toColumn(Doubt value)
{
    return text(doubtId(value));
}
void fromColumn(const QVariant& value, std::string& field)
{
    field = value.toString().toStdString();
}
void fromColumn(const QVariant& value, std::int64_t& field)
{
    field = value.toLongLong();
}
void fromColumn(const QVariant& value, int& field)
{
    field = value.toInt();
}
void fromColumn(const QVariant& value, bool& field)
{
    field = value.toInt() != 0;
}
void fromColumn(const QVariant& value, std::optional<int>& field)
{
    field = value.isNull() ? std::nullopt : std::optional(value.toInt());
}
void fromColumn(const QVariant& value, Doubt& field)
{
    field = doubtNamed(value.toString().toStdString());
}

/// Returns the mapping of a column to a field of the record.
template <auto Field>
constexpr Column fieldColumn(const char* name, bool isInserted = true)
{
    return {name, [](const AttemptRecord& record) { return toColumn(record.*Field); },
            [](const QVariant& value, AttemptRecord& record) { fromColumn(value, record.*Field); }, isInserted};
}

/// All columns of the table, in the order in which they are read.
constexpr std::array kAttemptColumns{
    fieldColumn<&AttemptRecord::id>("id", false),
    fieldColumn<&AttemptRecord::uid>("uid"),
    Column{"person_id", [](const AttemptRecord& record) { return number(record.person.value); },
           [](const QVariant& value, AttemptRecord& record) { record.person = {value.toLongLong()}; }},
    fieldColumn<&AttemptRecord::finishedUtc>("finished_utc"),
    fieldColumn<&AttemptRecord::tooth>("tooth"),
    fieldColumn<&AttemptRecord::lessonId>("lesson_id"),
    fieldColumn<&AttemptRecord::lessonHash>("lesson_hash"),
    fieldColumn<&AttemptRecord::rubricHash>("rubric_hash"),
    fieldColumn<&AttemptRecord::scoreTenths>("score_tenths"),
    fieldColumn<&AttemptRecord::passed>("passed"),
    fieldColumn<&AttemptRecord::givenTenths>("given_tenths", false),
    fieldColumn<&AttemptRecord::expectedTenths>("expected_tenths"),
    fieldColumn<&AttemptRecord::durationMs>("duration_ms"),
    Column{"criteria_json", [](const AttemptRecord& record) { return text(criteriaJson(record.criteria)); },
           [](const QVariant& value, AttemptRecord& record) { record.criteria = criteriaOf(value.toByteArray()); }},
    fieldColumn<&AttemptRecord::stateHash>("state_hash"),
    fieldColumn<&AttemptRecord::recordingHash>("recording_hash"),
    fieldColumn<&AttemptRecord::device>("device"),
    fieldColumn<&AttemptRecord::method>("method"),
    fieldColumn<&AttemptRecord::grid>("grid"),
    fieldColumn<&AttemptRecord::viewMode>("view_mode"),
    fieldColumn<&AttemptRecord::seed>("seed"),
    fieldColumn<&AttemptRecord::preset>("preset"),
    fieldColumn<&AttemptRecord::presetHash>("preset_hash"),
    fieldColumn<&AttemptRecord::program>("program"),
    fieldColumn<&AttemptRecord::meanForceMn>("mean_force_mn"),
    fieldColumn<&AttemptRecord::peakForceMn>("peak_force_mn"),
    fieldColumn<&AttemptRecord::passMarkTenths>("pass_mark_tenths"),
    fieldColumn<&AttemptRecord::doubt>("doubt"),
};
/// Index of the first column after those of an attempt, for queries that read more.
constexpr int kNextColumn = static_cast<int>(kAttemptColumns.size());

/// Returns "a.id, a.uid, ...": the columns of the attempts a that recordOf() reads.
QString selectedColumns()
{
    QStringList names;
    for (const Column& column : kAttemptColumns)
        names << QLatin1String("a.") + QLatin1String(column.name);
    return names.join(QStringLiteral(", "));
}

AttemptRecord recordOf(const QSqlQuery& row)
{
    AttemptRecord record;
    for (int place = 0; const Column& column : kAttemptColumns)
        column.read(row.value(place++), record);
    return record;
}

core::Result<QVariant> insertRow(const DatabaseContext& school, const AttemptRecord& record)
{
    QStringList names;
    QStringList marks;
    QVariantList values;
    for (const Column& column : kAttemptColumns) {
        if (!column.isInserted)
            continue;
        names << QLatin1String(column.name);
        marks << QStringLiteral("?");
        values << column.write(record);
    }
    return ask(school.db,
               QStringLiteral("INSERT INTO attempts (%1) VALUES (%2) ON CONFLICT (uid) DO NOTHING RETURNING id")
                   .arg(names.join(QStringLiteral(", ")), marks.join(QStringLiteral(", "))),
               kAdd, values);
}

/// Returns the doubt with which an attempt is stored: that of its check, or otherwise one that the database shows.
core::Result<Doubt> doubtOf(const DatabaseContext& school, const AttemptRecord& attempt)
{
    if (attempt.doubt != Doubt::None)
        return attempt.doubt;
    if (!attempt.recordingHash.empty()) {
        const auto anothers = ask(
            school.db, "SELECT 1 FROM attempts WHERE recording_hash = ? AND recording_hash <> '' AND person_id <> ?",
            kAdd, {text(attempt.recordingHash), number(attempt.person.value)});
        if (!anothers)
            return tl::unexpected(anothers.error());
        if (!anothers->isNull())
            return Doubt::Recording;
    }
    return isOfAnotherVersion(school, attempt).map([](bool isAnother) {
        return isAnother ? Doubt::Version : Doubt::None;
    });
}

/// A delivered attempt in the database.
struct Stored
{
    AttemptId id;
    bool isNew = false;  ///< otherwise it was stored before
    Doubt doubt = Doubt::None;
};

core::Error isSomebodyElses()
{
    return {ErrorCode::OutOfRange, "that attempt is kept already, as somebody else's"};
}

/// Stores an attempt with its score sheet.
core::Result<Stored> store(const DatabaseContext& school, const AttemptRecord& attempt)
{
    AttemptRecord kept = attempt;
    const auto doubt = doubtOf(school, kept);
    if (!doubt)
        return tl::unexpected(doubt.error());
    kept.doubt = *doubt;
    const auto added = insertRow(school, kept);
    if (!added)
        return tl::unexpected(added.error());
    if (added->isNull()) {
        const auto known = ask(school.db, "SELECT id FROM attempts WHERE uid = ? AND person_id = ?", kAdd,
                               {text(kept.uid), number(kept.person.value)});
        if (!known)
            return tl::unexpected(known.error());
        if (known->isNull())
            return tl::unexpected(isSomebodyElses());
        return Stored{{known->toLongLong()}};
    }
    const AttemptId id{added->toLongLong()};
    if (auto put = execute(school.db, QStringLiteral("INSERT INTO score_sheets (attempt_id, json) VALUES (?, ?)"), kAdd,
                           {number(id.value), text(kept.scoreSheetJson)});
        !put)
        return tl::unexpected(put.error());
    if (auto counted = recount(school, kept.person, kept.lessonId); !counted)
        return tl::unexpected(counted.error());
    return Stored{id, true, *doubt};
}

/// Lets the server store an attempt, as store() does: a station delivers the attempts of everybody, but may not read
/// them.
core::Result<Stored> storeThere(const DatabaseContext& school, const AttemptRecord& attempt)
{
    QJsonObject row;
    for (const Column& column : kAttemptColumns)
        if (column.isInserted)
            row.insert(QLatin1String(column.name), QJsonValue::fromVariant(column.write(attempt)));
    Stored stored;
    if (auto read = forEach(
            school.db, "SELECT id, is_new, doubt FROM cusp_deliver_attempt(CAST(? AS jsonb), ?)", kAdd,
            {QString::fromUtf8(QJsonDocument(row).toJson(QJsonDocument::Compact)), text(attempt.scoreSheetJson)},
            [&](const QSqlQuery& found) {
                stored = {{found.value(0).toLongLong()}, found.value(1).toBool(), doubtNamed(textOf(found, 2))};
            });
        !read)
        return tl::unexpected(read.error());
    if (stored.id.value == 0)
        return tl::unexpected(isSomebodyElses());
    return stored;
}

/// Inserts an attempt, inside a transaction.
core::Result<AttemptId> insert(const DatabaseContext& school, PersonId person, const std::string& actor,
                               const AttemptRecord& attempt, const QByteArray& recording)
{
    AttemptRecord kept = attempt;
    kept.person = person;
    if (!recording.isEmpty()) {
        const auto hash = putRecording(school, recording);
        if (!hash)
            return tl::unexpected(hash.error());
        kept.recordingHash = *hash;
    }
    // Takes its turn only now, so that no other station waits while a recording is transferred.
    if (auto turn = takeTurn(school); !turn)
        return tl::unexpected(turn.error());
    const auto stored = dialect::isStation(school.db) ? storeThere(school, kept) : store(school, kept);
    if (!stored)
        return tl::unexpected(stored.error());
    if (!stored->isNew)
        return stored->id;
    kept.doubt = stored->doubt;
    AuditBatch audit(school);
    const std::string object = "attempt:" + kept.uid;
    if (auto noted =
            audit.note(actor, "attempt.add", object, {{"digest", QString::fromStdString(digestOfAttempt(kept))}});
        !noted)
        return tl::unexpected(noted.error());
    if (kept.doubt != Doubt::None)
        if (auto noted =
                audit.note(actor, "attempt.doubt", object, {{"doubt", QString::fromStdString(doubtId(kept.doubt))}});
            !noted)
            return tl::unexpected(noted.error());
    if (auto sealed = audit.seal(); !sealed)
        return tl::unexpected(sealed.error());
    return stored->id;
}

core::Status checkUid(const AttemptRecord& attempt)
{
    if (attempt.uid.size() == kUidLength)
        return {};
    return core::unexpected(ErrorCode::BadStructure, "the attempt has no number of its own");
}

/// Returns the person who made an attempt.
core::Result<PersonId> ownerOf(const DatabaseContext& school, AttemptId id)
{
    auto row = run(school.db, "SELECT person_id FROM attempts WHERE id = ?", kReadAttempts, {number(id.value)});
    if (!row)
        return tl::unexpected(row.error());
    if (!row->next())
        return core::unexpected(ErrorCode::UnknownName, "there is no such attempt");
    return PersonId{row->value(0).toLongLong()};
}

core::Result<AuthorizedUser> admitToAttempt(const DatabaseContext& school, const Login& session, Operation operation,
                                            AttemptId id)
{
    // Checks the permission first: users without it must not learn which attempts exist.
    if (auto who = authorize(school, session, operation); !who)
        return who;
    const auto owner = ownerOf(school, id);
    if (!owner)
        return tl::unexpected(owner.error());
    return authorizeFor(school, session, operation, *owner);
}

/// Recomputes the standing that an attempt belongs to.
core::Status recountFor(const DatabaseContext& school, AttemptId id)
{
    PersonId person;
    std::string lesson;
    if (auto read = forEach(school.db, "SELECT person_id, lesson_id FROM attempts WHERE id = ?", kReadAttempts,
                            {number(id.value)},
                            [&](const QSqlQuery& row) {
                                person = {row.value(0).toLongLong()};
                                lesson = textOf(row, 1);
                            });
        !read)
        return read;
    return recount(school, person, lesson);
}

core::Result<std::string> uidOf(const DatabaseContext& school, AttemptId id)
{
    const auto uid = ask(school.db, "SELECT uid FROM attempts WHERE id = ?", kReadAttempts, {number(id.value)});
    if (!uid)
        return tl::unexpected(uid.error());
    return uid->toString().toStdString();
}

/// Stores another score.
/// @param said  reason and time
core::Status giveScore(const DatabaseContext& school, const Login& session, AttemptId id, std::optional<int> tenths,
                       const QVariantList& said)
{
    const std::string doing = "give another score";
    if (dialect::isStation(school.db))
        return execute(school.db, "SELECT cusp_override(?, ?, ?, ?)", doing,
                       QVariantList{number(id.value), toColumn(tenths)} + said);
    if (auto kept =
            execute(school.db,
                    "INSERT INTO overrides (attempt_id, author_id, given_tenths, reason, given_utc) VALUES "
                    "(?, ?, ?, ?, ?)",
                    doing, QVariantList{number(id.value), number(session.person().value), toColumn(tenths)} + said);
        !kept)
        return kept;
    if (auto set = execute(school.db, "UPDATE attempts SET given_tenths = ? WHERE id = ?", doing,
                           {toColumn(tenths), number(id.value)});
        !set)
        return set;
    return recountFor(school, id);
}

core::Result<std::string> checkWords(const std::string& words, const char* what)
{
    const QString trimmed = QString::fromStdString(words).trimmed();
    if (trimmed.isEmpty() || trimmed.size() > kLongestComment)
        return core::unexpected(ErrorCode::OutOfRange,
                                std::string(what) + " has 1 to " + std::to_string(kLongestComment) + " characters");
    return trimmed.toStdString();
}

}  // namespace

std::string digestOfAttempt(const AttemptRecord& attempt)
{
    core::ByteWriter bytes;
    for (const std::string* part :
         {&attempt.uid, &attempt.personUid, &attempt.finishedUtc, &attempt.tooth, &attempt.lessonId,
          &attempt.lessonHash, &attempt.rubricHash, &attempt.scoreSheetJson, &attempt.stateHash, &attempt.recordingHash,
          &attempt.device, &attempt.method, &attempt.viewMode, &attempt.seed, &attempt.preset, &attempt.presetHash,
          &attempt.program})
        bytes.putText(*part);
    for (const std::int64_t value :
         {std::int64_t{attempt.scoreTenths}, std::int64_t{attempt.passed ? 1 : 0},
          std::int64_t{attempt.expectedTenths.value_or(-1)}, attempt.durationMs, std::int64_t{attempt.grid},
          std::int64_t{attempt.meanForceMn}, std::int64_t{attempt.peakForceMn}, std::int64_t{attempt.passMarkTenths}})
        bytes.put(value);
    bytes.putText(criteriaJson(attempt.criteria));
    return digestOf(bytes.bytes());
}

core::Status forEachAttempt(const QSqlDatabase& db,
                            const std::function<void(const AttemptRecord& attempt, const std::string& noted)>& take)
{
    return forEach(db,
                   "SELECT " + selectedColumns() +
                       ", COALESCE(s.json, ''), p.uid, COALESCE(u.detail, '') FROM attempts a JOIN people p ON p.id = "
                       "a.person_id LEFT JOIN score_sheets s ON s.attempt_id = a.id LEFT JOIN audit u ON u.object = "
                       "'attempt:' || a.uid AND u.action = 'attempt.add' ORDER BY a.id",
                   kReadAttempts, {}, [&](const QSqlQuery& row) {
                       AttemptRecord record = recordOf(row);
                       record.scoreSheetJson = textOf(row, kNextColumn);
                       record.personUid = textOf(row, kNextColumn + 1);
                       take(record, textOf(row, kNextColumn + 2));
                   });
}

core::Result<AttemptId> deliverAttempt(const DatabaseContext& school, const AttemptRecord& attempt,
                                       const QByteArray& recording)
{
    if (auto fit = checkUid(attempt); !fit)
        return tl::unexpected(fit.error());
    return inTransaction(school.db, kAdd, [&]() -> core::Result<AttemptId> {
        const auto person = ask(school.db, personByUid(school.db), kAdd, {text(attempt.personUid)});
        if (!person)
            return tl::unexpected(person.error());
        if (person->isNull())
            return core::unexpected(ErrorCode::UnknownName,
                                    "nobody here has the account that the attempt was made with");
        return insert(school, {person->toLongLong()}, attempt.personUid, attempt, recording);
    });
}

core::Result<std::vector<AttemptRecord>> history(const DatabaseContext& school, const Login& session, PersonId person,
                                                 const HistoryQuery& query)
{
    assert(query.limit >= 0 && (query.lessonId.empty() || query.tooth.empty()));
    if (auto who = authorizeFor(school, session, Operation::ReadHistory, person); !who)
        return tl::unexpected(who.error());
    QString where = QStringLiteral(" WHERE a.person_id = ?");
    QVariantList values{number(person.value)};
    if (!query.lessonId.empty()) {
        where += QStringLiteral(" AND a.lesson_id = ?");
        values += text(query.lessonId);
    }
    if (!query.tooth.empty()) {
        where += QStringLiteral(" AND a.lesson_id = '' AND a.tooth = ?");
        values += text(query.tooth);
    }
    values += query.limit > 0 ? query.limit : std::numeric_limits<int>::max();
    std::vector<AttemptRecord> found;
    if (auto read = forEach(school.db,
                            "SELECT " + selectedColumns() + " FROM attempts a" + where +
                                " ORDER BY a.finished_utc DESC, a.id DESC LIMIT ?",
                            kReadAttempts, values, [&](const QSqlQuery& row) { found.push_back(recordOf(row)); });
        !read)
        return tl::unexpected(read.error());
    return found;
}

core::Result<std::vector<LessonStanding>> standingsOf(const DatabaseContext& school, const Login& session,
                                                      PersonId person)
{
    if (auto who = authorizeFor(school, session, Operation::ReadHistory, person); !who)
        return tl::unexpected(who.error());
    std::vector<LessonStanding> found;
    if (auto read = forEach(school.db,
                            "SELECT lesson_id, attempts, best_tenths, passed, last_utc FROM standings WHERE "
                            "person_id = ? AND lesson_id <> '' ORDER BY lesson_id",
                            kReadAttempts, {number(person.value)},
                            [&](const QSqlQuery& row) {
                                found.push_back({textOf(row, 0), row.value(1).toInt(), row.value(2).toInt(),
                                                 row.value(3).toInt() != 0, textOf(row, 4)});
                            });
        !read)
        return tl::unexpected(read.error());
    return found;
}

core::Result<AttemptRecord> openAttempt(const DatabaseContext& school, const Login& session, AttemptId id)
{
    if (auto who = admitToAttempt(school, session, Operation::OpenAttempt, id); !who)
        return tl::unexpected(who.error());
    AttemptRecord record;
    if (auto read = forEach(school.db,
                            "SELECT " + selectedColumns() +
                                ", s.json, COALESCE(p.uid, '') FROM attempts a JOIN score_sheets s ON s.attempt_id = "
                                "a.id LEFT JOIN people p ON p.id = a.person_id WHERE a.id = ?",
                            kReadAttempts, {number(id.value)},
                            [&](const QSqlQuery& row) {
                                record = recordOf(row);
                                record.scoreSheetJson = textOf(row, kNextColumn);
                                record.personUid = textOf(row, kNextColumn + 1);
                            });
        !read)
        return tl::unexpected(read.error());
    return record;
}

core::Result<QByteArray> openRecording(const DatabaseContext& school, const Login& session, AttemptId id)
{
    if (auto who = admitToAttempt(school, session, Operation::OpenAttempt, id); !who)
        return tl::unexpected(who.error());
    const auto hash =
        ask(school.db, "SELECT recording_hash FROM attempts WHERE id = ?", kReadAttempts, {number(id.value)});
    if (!hash)
        return tl::unexpected(hash.error());
    if (hash->toString().isEmpty())
        return core::unexpected(ErrorCode::FileMissing, "no recording was kept of this attempt");
    return recordingOf(school.db, hash->toString().toStdString());
}

core::Result<std::vector<KeptSheet>> sheetsOfLesson(const DatabaseContext& school, const Login& session,
                                                    const std::string& lessonId, const std::string& lessonHash,
                                                    int limit)
{
    assert(limit >= 0);
    const auto who = authorize(school, session, Operation::OpenAttempt);
    if (!who)
        return tl::unexpected(who.error());
    QString whose;
    QVariantList values{text(lessonId), text(lessonHash)};
    const qlonglong me = session.person().value;
    if (who->reach == Reach::Own) {
        whose = QStringLiteral(" AND a.person_id = ?");
        values += me;
    } else if (who->reach == Reach::Classes) {
        whose = QStringLiteral(" AND (a.person_id = ? OR a.person_id IN %1)").arg(classmates());
        values += me;
        values += me;
    }
    values += limit;
    std::vector<KeptSheet> sheets;
    if (auto read = forEach(school.db,
                            "SELECT a.finished_utc, s.json FROM attempts a JOIN score_sheets s ON s.attempt_id = a.id "
                            "WHERE a.lesson_id = ? AND a.lesson_hash = ?" +
                                whose + " ORDER BY a.finished_utc DESC, a.id DESC LIMIT ?",
                            kReadAttempts, values,
                            [&](const QSqlQuery& row) {
                                sheets.push_back({textOf(row, 0), textOf(row, 1)});
                            });
        !read)
        return tl::unexpected(read.error());
    return sheets;
}

QString comparedDevice(const QString& column)
{
    return QStringLiteral("CASE %1 WHEN 'pointer' THEN 'mouse' ELSE %1 END").arg(column);
}

core::Result<lessons::ClassStanding> standingAmongClassmates(const DatabaseContext& school, const Login& session,
                                                             const std::string& lessonId, const std::string& rubricHash,
                                                             const std::string& device, int tenths)
{
    if (auto who = authorize(school, session, Operation::CompareWithClass); !who)
        return tl::unexpected(who.error());
    const qlonglong me = session.person().value;
    const std::string among = device == "pointer" ? "mouse" : device;
    const bool isStation = dialect::isStation(school.db);
    QVariantList values{text(lessonId), text(rubricHash), text(among)};
    if (!isStation)
        values << me << me;
    std::vector<int> best;
    if (auto read = forEach(
            school.db,
            isStation ? QStringLiteral("SELECT cusp_bests(?, ?, ?)")
                      : QStringLiteral("SELECT MAX(COALESCE(a.given_tenths, a.score_tenths)) FROM attempts a JOIN "
                                       "people p ON p.id = a.person_id WHERE a.lesson_id = ? AND a.rubric_hash = ? "
                                       "AND %3 AND %1 = ? AND (a.person_id = ? OR (p.role = 'student' AND "
                                       "p.disabled = 0 AND a.person_id IN %2)) GROUP BY a.person_id")
                            .arg(comparedDevice(QStringLiteral("a.device")), classmates(), doesCount()),
            "compare with the class", values, [&](const QSqlQuery& row) { best.push_back(row.value(0).toInt()); });
        !read)
        return tl::unexpected(read.error());
    return lessons::classStanding(tenths, best);
}

core::Status overrideScore(const DatabaseContext& school, const Login& session, AttemptId id, std::optional<int> tenths,
                           const std::string& reason, std::optional<std::size_t> before)
{
    if (auto who = admitToAttempt(school, session, Operation::Override, id); !who)
        return tl::unexpected(who.error());
    const auto words = checkWords(reason, "the reason for another score");
    if (!words)
        return tl::unexpected(words.error());
    const std::string doing = "give another score";
    return inTurn(school, doing, [&]() -> core::Status {
        const auto uid = uidOf(school, id);
        if (!uid)
            return tl::unexpected(uid.error());
        const auto given = ask(school.db, QStringLiteral("SELECT count(*) FROM overrides WHERE attempt_id = ?"), doing,
                               {number(id.value)});
        if (!given)
            return tl::unexpected(given.error());
        if (before && given->toULongLong() != *before)
            return core::unexpected(core::ErrorCode::ChangedSince,
                                    "somebody else has given another score; look at it, and give yours again");
        const QVariantList said{text(*words), text(school.now())};
        if (auto put = giveScore(school, session, id, tenths, said); !put)
            return put;
        return note(school, session.uid(), "attempt.override", "attempt:" + *uid,
                    {{"given_tenths", tenths ? QJsonValue(*tenths) : QJsonValue()},
                     {"digest_of_all", QString::fromStdString(digestOfComment(said))}});
    });
}

core::Result<std::int64_t> addComment(const DatabaseContext& school, const Login& session, AttemptId id,
                                      const NewComment& comment)
{
    if (auto who = admitToAttempt(school, session, Operation::Comment, id); !who)
        return tl::unexpected(who.error());
    const auto words = checkWords(comment.words, "a comment");
    if (!words)
        return tl::unexpected(words.error());
    const std::string doing = "add the comment";
    return inTurn(school, doing, [&]() -> core::Result<std::int64_t> {
        const auto uid = uidOf(school, id);
        if (!uid)
            return tl::unexpected(uid.error());
        const auto um = [&](std::size_t axis) {
            return comment.placeMm ? QVariant(static_cast<int>(
                                         std::lround(std::clamp((*comment.placeMm)[axis], -1000.0, 1000.0) * kUmPerMm)))
                                   : QVariant();
        };
        const QVariantList row{
            text(*words),      um(0), um(1), um(2), comment.momentMs ? QVariant(number(*comment.momentMs)) : QVariant(),
            text(school.now())};
        const auto added = ask(school.db,
                               "INSERT INTO comments (attempt_id, author_id, words, x_um, y_um, z_um, moment_ms, "
                               "written_utc) VALUES (?, ?, ?, ?, ?, ?, ?, ?) RETURNING id",
                               doing, QVariantList{number(id.value), number(session.person().value)} + row);
        if (!added)
            return tl::unexpected(added.error());
        if (auto noted = note(school, session.uid(), "attempt.comment", "attempt:" + *uid,
                              {{"digest_of_all", QString::fromStdString(digestOfComment(row))}});
            !noted)
            return tl::unexpected(noted.error());
        return added->toLongLong();
    });
}

core::Status withdrawComment(const DatabaseContext& school, const Login& session, std::int64_t comment)
{
    if (auto who = authorize(school, session, Operation::WithdrawComment); !who)
        return tl::unexpected(who.error());
    const std::string doing = "take the comment back";
    return inTurn(school, doing, [&]() -> core::Status {
        QVariantList kept;
        if (auto read = forEach(school.db,
                                "SELECT c.author_id, c.withdrawn_utc, a.uid, c.words, c.x_um, c.y_um, c.z_um, "
                                "c.moment_ms, c.written_utc FROM comments c JOIN attempts a ON a.id = c.attempt_id "
                                "WHERE c.id = ?",
                                doing, {number(comment)}, [&](const QSqlQuery& row) { kept = valuesOf(row, 0); });
            !read)
            return read;
        if (kept.isEmpty())
            return core::unexpected(ErrorCode::UnknownName, "there is no such comment");
        if (kept.at(0).toLongLong() != session.person().value)
            return core::unexpected(ErrorCode::NotAllowed, "only the author of a comment can withdraw it");
        if (!kept.at(1).isNull())
            return core::unexpected(ErrorCode::ChangedSince, "the comment has been taken back already");
        if (auto done = execute(school.db, "UPDATE comments SET withdrawn_utc = ? WHERE id = ?", doing,
                                {text(school.now()), number(comment)});
            !done)
            return done;
        return note(school, session.uid(), "attempt.comment.withdraw", "attempt:" + kept.at(2).toString().toStdString(),
                    {{"digest_of_all", QString::fromStdString(digestOfComment(kept.mid(3)))}});
    });
}

std::string digestOfComment(const QVariantList& row)
{
    core::ByteWriter bytes;
    for (const QVariant& field : row)
        bytes.putText(field.isNull() ? std::string() : field.toString().toStdString());
    return digestOf(bytes.bytes());
}

}  // namespace database::sql
