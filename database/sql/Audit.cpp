// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/sql/Audit.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <set>

#include <QJsonDocument>
#include <QRegularExpression>
#include <QSqlError>

#include "core/base/Bytes.h"
#include "database/Passwords.h"
#include "database/sql/Statement.h"

namespace database::sql {
namespace {

const std::string kNote = "note it in the audit";
const std::string kRead = "read the audit";
constexpr std::size_t kCodeDigits = 12;
/// No real database has as many rows. A larger number is forged; the limit also leaves room for the next row.
constexpr std::int64_t kHighest = std::numeric_limits<std::int64_t>::max() / 4;
const QString kColumns = QStringLiteral("seq, at_utc, actor, action, object, detail, hash");
const QString kNoAttempt =
    QStringLiteral("AND action NOT IN ('attempt.add', 'attempt.check', 'attempt.doubt', 'exam.begin')");

/// Returns SQL for the hash of the row with the number %1. The account of a station cannot read all rows.
QString hashAt(const QSqlDatabase& db)
{
    return dialect::isStation(db) ? QStringLiteral("cusp_audit_hash(%1)")
                                  : QStringLiteral("(SELECT a.hash FROM audit a WHERE a.seq = %1)");
}

/// Returns SQL for the number of the last row.
QString lastOf(const QSqlDatabase& db)
{
    return dialect::isStation(db) ? QStringLiteral("cusp_audit_last()")
                                  : QStringLiteral("(SELECT COALESCE(MAX(a.seq), 0) FROM audit a)");
}

AuditRow rowOf(const QSqlQuery& query)
{
    return {query.value(0).toLongLong(),
            textOf(query, 1),
            textOf(query, 2),
            textOf(query, 3),
            textOf(query, 4),
            textOf(query, 5),
            textOf(query, 6)};
}

/// Action of the row that is added if the end of the chain does not match its signature.
const std::string kBroken = "audit.broken";
/// Action of the row that is added if an older copy took the place of the database.
const std::string kOlder = "audit.older";
/// Action of the row with a station's key, before the first row that the station signs. Each chain begins with it.
const std::string kJoin = "station.join";

std::string stationOf(const std::string& key)
{
    return "station:" + key;
}

std::string wordsOf(const AuditHead& head)
{
    return "cusp audit " + std::to_string(head.seq) + ' ' + head.hash;
}

IntegrityIssue about(const AuditRow& row, const char* words)
{
    return {words, {std::to_string(row.seq), row.atUtc, row.action, row.object}};
}

/// Returns the issue of a row that does not follow from the previous row.
std::optional<IntegrityIssue> faultOf(const AuditRow& row, const AuditRow& before)
{
    if (row.seq > before.seq + 1)
        return IntegrityIssue{QT_TRANSLATE_NOOP("Finding", "audit row %1 was removed"),
                              {std::to_string(before.seq + 1)}};
    if (row.action == kBroken)
        return about(row, QT_TRANSLATE_NOOP(
                              "Finding",
                              "audit row %1 (%2, %3, %4) tells that the rows before it did not end as they had been "
                              "signed"));
    if (row.seq != before.seq + 1 || hashOf(row, before.hash) != row.hash)
        return about(row, QT_TRANSLATE_NOOP("Finding", "audit row %1 (%2, %3, %4) does not follow from the row before "
                                                       "it: one of the two was changed, inserted or moved"));
    return {};
}

/// Returns the issue of a row that does not match the signed head.
std::optional<IntegrityIssue> faultBySeal(const AuditRow& row, const AuditHead& head)
{
    if (row.seq > head.seq)
        return IntegrityIssue{QT_TRANSLATE_NOOP("Finding",
                                                "no signature covers audit row %1: it was inserted, or the signed "
                                                "head was set back, or the row behind it was changed"),
                              {std::to_string(row.seq)}};
    if (row.seq == head.seq && row.hash != head.hash)
        return about(row,
                     QT_TRANSLATE_NOOP("Finding", "audit row %1 (%2, %3, %4) is not the one that was signed: it was "
                                                  "changed, or the signature was put there from elsewhere"));
    return {};
}

/// Returns the issue of a row that does not match the audit codes of reports.
/// @param witnesses  number of a row and the first digits of its hash
std::optional<IntegrityIssue> faultByWitness(const AuditRow& row, const std::vector<AuditHead>& witnesses)
{
    for (const AuditHead& witness : witnesses)
        if (witness.seq == row.seq && row.hash.rfind(witness.hash, 0) != 0)
            return about(row, QT_TRANSLATE_NOOP("Finding", "audit row %1 (%2, %3, %4) is not the one that a report "
                                                           "names: it or one before it was changed, or the code is "
                                                           "not typed as it stands there"));
    return {};
}

/// Returns the issue at the end of a chain whose rows are all valid.
std::optional<IntegrityIssue> faultOfEnd(const AuditRow& last, const AuditHead& head,
                                         const std::vector<AuditHead>& witnesses)
{
    if (head.seq > last.seq)
        return IntegrityIssue{QT_TRANSLATE_NOOP("Finding", "audit row %1 was removed"), {std::to_string(last.seq + 1)}};
    for (const AuditHead& witness : witnesses)
        if (witness.seq > last.seq)
            return IntegrityIssue{QT_TRANSLATE_NOOP("Finding",
                                                    "audit row %1, which a report names, is not there: it was "
                                                    "removed, or the code is not typed as it stands there"),
                                  {std::to_string(witness.seq)}};
    return {};
}

/// Returns the issue of the station that signed the head.
/// @param stations  keys of the stations that the audit records
std::optional<IntegrityIssue> faultOfSigner(const AuditHead& head, const std::string& signature, const std::string& key,
                                            const std::set<std::string>& stations)
{
    if (head.seq == 0)
        return {};
    if (!StationKey::isSigned(wordsOf(head), signature, key))
        return IntegrityIssue{QT_TRANSLATE_NOOP("Finding",
                                                "the signature of the newest row of the audit was not made by the "
                                                "station whose key stands beside it"),
                              {}};
    if (stations.count(stationOf(key)) == 0)
        return IntegrityIssue{QT_TRANSLATE_NOOP("Finding",
                                                "the newest row of the audit was signed with the key %1, and the "
                                                "audit knows no station that has it"),
                              {key.substr(0, kCodeDigits)}};
    return {};
}

}  // namespace

std::string hashOf(const AuditRow& row, const std::string& hashBefore)
{
    core::ByteWriter bytes;
    bytes.putText(hashBefore);
    bytes.put(row.seq);
    for (const std::string* part : {&row.atUtc, &row.actor, &row.action, &row.object, &row.detail})
        bytes.putText(*part);
    return digestOf(bytes.bytes());
}

core::Status AuditBatch::begin()
{
    bool isThere = false;
    bool isSound = false;
    bool mustJoin = false;
    std::int64_t last = 0;
    const QString joined = QStringLiteral("EXISTS (SELECT 1 FROM audit j WHERE j.action = '%1' AND j.object = %2)")
                               .arg(QString::fromStdString(kJoin));
    if (auto read = forEach(m_school.db,
                            "SELECT s.seq, s.hash, s.signature, s.station_key, COALESCE(" +
                                hashAt(m_school.db).arg("s.seq") + ", ''), " + lastOf(m_school.db) + ", CASE WHEN " +
                                joined.arg("'station:' || s.station_key") + " THEN 1 ELSE 0 END, CASE WHEN " +
                                joined.arg("?") + " THEN 1 ELSE 0 END FROM audit_seal s WHERE s.id = 1" +
                                QString(dialect::isPostgres(m_school.db) ? " FOR UPDATE OF s" : ""),
                            kNote, {text(stationOf(m_school.key.publicHex()))},
                            [&](const QSqlQuery& row) {
                                isThere = true;
                                m_seq = row.value(0).toLongLong();
                                m_hash = textOf(row, 1);
                                last = row.value(5).toLongLong();
                                const bool isSigned =
                                    m_seq == 0 ||
                                    (StationKey::isSigned(wordsOf({m_seq, m_hash}), textOf(row, 2), textOf(row, 3)) &&
                                     row.value(6).toInt() == 1);
                                isSound = isSigned && m_seq == last && m_hash == textOf(row, 4);
                                mustJoin = row.value(7).toInt() == 0;
                            });
        !read)
        return read;
    const bool isFirst = m_seq == 0;
    m_seq = std::max(m_seq, last);
    if (!isThere || m_seq > kHighest)
        return core::unexpected(core::ErrorCode::BadStructure,
                                "database " + dialect::nameOf(m_school.db) +
                                    ": the head of its audit is missing or damaged; restore "
                                    "a backup of it");
    m_insert.emplace(m_school.db);
    if (!m_insert->prepare(QStringLiteral("INSERT INTO audit (%1) VALUES (?, ?, ?, ?, ?, ?, ?)").arg(kColumns)))
        return tl::unexpected(dialect::error(m_school.db, m_insert->lastError(), kNote));
    // Without this row, a new signature would hide that the chain was changed.
    if (auto noted = isSound ? core::Status() : note("system", kBroken, "audit"); !noted || !mustJoin)
        return noted;
    // The random uid makes the first row unique, even if two databases are created at the same time.
    const QJsonObject school{{"school", QString::fromStdString(newUid())}};
    return note("system", kJoin, stationOf(m_school.key.publicHex()), isFirst ? school : QJsonObject());
}

core::Status AuditBatch::note(const std::string& actor, const std::string& action, const std::string& object,
                              const QJsonObject& detail)
{
    if (!m_insert)
        if (auto begun = begin(); !begun)
            return begun;
    AuditRow row;
    row.seq = m_seq + 1;
    row.atUtc = m_school.now();
    row.actor = actor;
    row.action = action;
    row.object = object;
    row.detail = QJsonDocument(detail).toJson(QJsonDocument::Compact).toStdString();
    row.hash = hashOf(row, m_hash);
    int place = 0;
    m_insert->bindValue(place++, static_cast<qlonglong>(row.seq));
    for (const std::string* part : {&row.atUtc, &row.actor, &row.action, &row.object, &row.detail, &row.hash})
        m_insert->bindValue(place++, text(*part));
    if (!m_insert->exec())
        return tl::unexpected(dialect::error(m_school.db, m_insert->lastError(), kNote));
    m_seq = row.seq;
    m_hash = row.hash;
    return {};
}

core::Status AuditBatch::seal()
{
    if (!m_insert)
        return {};
    m_insert.reset();
    return execute(m_school.db, "UPDATE audit_seal SET seq = ?, hash = ?, signature = ?, station_key = ? WHERE id = 1",
                   kNote,
                   {static_cast<qlonglong>(m_seq), text(m_hash), text(m_school.key.sign(wordsOf({m_seq, m_hash}))),
                    text(m_school.key.publicHex())});
}

core::Status takeTurn(const DatabaseContext& school)
{
    if (auto right = checkClock(school.nowUtc()); !right)
        return right;
    const QString turn = dialect::lockTurn(school.db);
    return turn.isEmpty() ? core::Status() : execute(school.db, turn, kNote);
}

core::Status note(const DatabaseContext& school, const std::string& actor, const std::string& action,
                  const std::string& object, const QJsonObject& detail)
{
    AuditBatch batch(school);
    if (auto noted = batch.note(actor, action, object, detail); !noted)
        return noted;
    return batch.seal();
}

core::Result<AuditHead> auditHead(const QSqlDatabase& db)
{
    AuditHead head;
    if (auto read = forEach(db, "SELECT seq, hash FROM audit_seal WHERE id = 1", kRead, {},
                            [&](const QSqlQuery& row) {
                                head = {row.value(0).toLongLong(), textOf(row, 1)};
                            });
        !read)
        return tl::unexpected(read.error());
    return head;
}

core::Result<bool> isOlderThan(const DatabaseContext& school, const AuditHead& seen, const std::string& seenUtc)
{
    const std::string doing = "compare the audit";
    const auto hash = ask(school.db, "SELECT " + hashAt(school.db).arg("?"), doing, {number(seen.seq)});
    if (!hash)
        return tl::unexpected(hash.error());
    if (seen.seq == 0 || hash->toString().toStdString() == seen.hash)
        return false;
    const auto restored =
        ask(school.db, "SELECT 1 FROM audit WHERE action = 'backup.restored' AND at_utc >= ?", doing, {text(seenUtc)});
    if (!restored)
        return tl::unexpected(restored.error());
    if (!restored->isNull())
        return false;
    const core::Status noted = inTurn(school, doing, [&] {
        return note(school, "system", kOlder, "audit", {{"seen", QString::fromStdString(seen.code())}});
    });
    if (!noted)
        return tl::unexpected(noted.error());
    return true;
}

core::Result<std::vector<AuditRow>> readAudit(const DatabaseContext& school, const Login& session, int limit,
                                              std::int64_t beforeSeq, AuditRows which)
{
    assert(limit >= 0 && beforeSeq >= 0);
    if (auto who = authorize(school, session, Operation::ReadAudit); !who)
        return tl::unexpected(who.error());
    std::vector<AuditRow> rows;
    const QString others = which == AuditRows::All ? QString() : kNoAttempt;
    const qlonglong before = beforeSeq > 0 ? beforeSeq : std::numeric_limits<qlonglong>::max();
    if (auto read = forEach(
            school.db,
            QStringLiteral("SELECT %1 FROM audit WHERE seq < ? %2 ORDER BY seq DESC LIMIT ?").arg(kColumns, others),
            kRead, {before, limit}, [&](const QSqlQuery& row) { rows.push_back(rowOf(row)); });
        !read)
        return tl::unexpected(read.error());
    return rows;
}

core::Result<std::vector<IntegrityIssue>> checkAudit(const QSqlDatabase& db, const std::vector<std::string>& codes,
                                                     const std::function<bool(std::int64_t rows)>& progress)
{
    std::vector<AuditHead> witnesses;
    for (const std::string& code : codes) {
        const auto found = readAuditCode(code);
        if (!found)
            return std::vector{IntegrityIssue{
                QT_TRANSLATE_NOOP("Finding", "\"%1\" is no audit code; a report shows one such as 412-9f3ac07be1d2"),
                {code}}};
        witnesses.push_back(*found);
    }
    auto seal = run(db, "SELECT seq, hash, signature, station_key FROM audit_seal WHERE id = 1", kRead);
    if (!seal)
        return tl::unexpected(seal.error());
    if (!seal->next())
        return std::vector{
            IntegrityIssue{QT_TRANSLATE_NOOP("Finding", "the signed head of the audit was removed"), {}}};
    const AuditHead head{seal->value(0).toLongLong(), textOf(*seal, 1)};
    auto rows = run(db, QStringLiteral("SELECT %1 FROM audit ORDER BY seq").arg(kColumns), kRead);
    if (!rows)
        return tl::unexpected(rows.error());
    AuditRow before;
    std::set<std::string> stations;
    std::optional<IntegrityIssue> fault;
    while (!fault && rows->next()) {
        const AuditRow row = rowOf(*rows);
        fault = faultOf(row, before);
        if (!fault)
            fault = faultBySeal(row, head);
        if (!fault)
            fault = faultByWitness(row, witnesses);
        if (row.action == kJoin)
            stations.insert(row.object);
        before = row;
        if (progress && !progress(row.seq))
            return std::vector<IntegrityIssue>();
    }
    if (rows->lastError().isValid())
        return tl::unexpected(dialect::error(db, rows->lastError(), kRead));
    if (!fault)
        fault = faultOfEnd(before, head, witnesses);
    if (!fault)
        fault = faultOfSigner(head, textOf(*seal, 2), textOf(*seal, 3), stations);
    return fault ? std::vector{*fault} : std::vector<IntegrityIssue>();
}

}  // namespace database::sql
