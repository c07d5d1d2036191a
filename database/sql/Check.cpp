// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/sql/Check.h"

#include <set>

#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <QScopeGuard>

#include "database/sql/Attempts.h"
#include "database/sql/Audit.h"
#include "database/sql/Doubts.h"
#include "database/sql/Grants.h"
#include "database/sql/LessonVersions.h"
#include "database/sql/Migrations.h"
#include "database/sql/Noted.h"
#include "database/sql/Recordings.h"
#include "database/sql/Statement.h"

namespace database::sql {
namespace {

using Progress = std::function<bool(const char* what, std::int64_t rows)>;

const std::string kDoing = "check it";
constexpr std::size_t kShownDigits = 12;  ///< of a hash

void say(CheckReport& report, const IntegrityIssue& finding)
{
    if (report.findings.size() < report.mostFindings)
        report.findings.push_back(finding);
}

/// Checks that all tables of the migrations exist, and the triggers that prevent changes of rows.
core::Status checkSchema(const QSqlDatabase& db, CheckReport& report)
{
    const auto steps = shippedMigrations();
    if (!steps)
        return tl::unexpected(steps.error());
    std::set<QString> there;
    // On a server, a trigger that is disabled or fires on replicas only does not count.
    const QString names =
        dialect::isPostgres(db)
            ? QStringLiteral(
                  "SELECT 'table ' || relname FROM pg_class WHERE relkind = 'r' AND pg_table_is_visible(oid) "
                  "UNION ALL SELECT 'trigger ' || tgname FROM pg_trigger WHERE tgenabled IN ('O', 'A') AND "
                  "pg_table_is_visible(tgrelid)")
            : QStringLiteral("SELECT type || ' ' || name FROM sqlite_master");
    if (auto read =
            forEach(db, names, kDoing, {}, [&there](const QSqlQuery& row) { there.insert(row.value(0).toString()); });
        !read)
        return read;
    static const QRegularExpression kMade(QStringLiteral(R"(CREATE (TABLE|TRIGGER) (\w+))"));
    for (const Migration& step : *steps)
        for (auto found = kMade.globalMatch(dialect::expand(db, step.sql)); found.hasNext();) {
            const auto made = found.next();
            const QString named = made.captured(1).toLower() + ' ' + made.captured(2);
            if (there.insert(named).second)  // a later step may replace a trigger
                say(report,
                    {QT_TRANSLATE_NOOP("Finding", "%1 is no longer there: what it guarded is not guarded any more"),
                     {named.toStdString()}});
        }
    return {};
}

core::Status checkPages(const QSqlDatabase& db, CheckReport& report)
{
    if (dialect::isPostgres(db))
        return {};  // the server checks its pages itself
    if (auto read = forEach(db, "PRAGMA integrity_check", kDoing, {},
                            [&](const QSqlQuery& row) {
                                if (row.value(0).toString() != u"ok")
                                    say(report, {QT_TRANSLATE_NOOP("Finding", "the file is damaged: %1"),
                                                 {row.value(0).toString().simplified().toStdString()}});
                            });
        !read)
        return read;
    return forEach(db, "PRAGMA foreign_key_check", kDoing, {}, [&](const QSqlQuery& row) {
        say(report, {QT_TRANSLATE_NOOP("Finding", "row %1 of the table %2 belongs to no row of %3"),
                     {textOf(row, 1), textOf(row, 0), textOf(row, 2)}});
    });
}

core::Status checkAttempts(const QSqlDatabase& db, CheckReport& report, const Progress& progress)
{
    // Attempts without a person are older than accounts and the audit.
    const auto early = ask(db, "SELECT COUNT(*) FROM attempts WHERE person_id IS NULL", kDoing);
    if (!early)
        return tl::unexpected(early.error());
    report.attempts = early->toLongLong();
    if (auto read = forEachAttempt(
            db,
            [&](const AttemptRecord& attempt, const std::string& noted) {
                if (report.isStopped)
                    return;
                const std::vector<std::string> named{"attempt:" + attempt.uid, attempt.finishedUtc, attempt.lessonId};
                const std::string digest = QJsonDocument::fromJson(QByteArray::fromStdString(noted))
                                               .object()
                                               .value(QStringLiteral("digest"))
                                               .toString()
                                               .toStdString();
                if (noted.empty())
                    say(report, {QT_TRANSLATE_NOOP("Finding", "%1 (%2, %3) is not noted in the audit: it was inserted, "
                                                              "or the note of it is among the rows of the audit that "
                                                              "were removed or changed"),
                                 named});
                else if (digest != digestOfAttempt(attempt))
                    say(report,
                        {QT_TRANSLATE_NOOP("Finding", "%1 (%2, %3) was changed after it had been kept"), named});
                if (++report.attempts % 1000 == 0 && progress)
                    report.isStopped = !progress("attempts", report.attempts);
            });
        !read)
        return read;
    const auto inDoubt = ask(
        db, "SELECT COUNT(*) FROM attempts WHERE doubt <> '' AND doubt <> 'version' AND given_tenths IS NULL", kDoing);
    if (!inDoubt)
        return tl::unexpected(inDoubt.error());
    if (inDoubt->toInt() > 0)
        report.notes.push_back({QT_TRANSLATE_NOOP("Finding", "%1 attempts do not match their recordings and do not "
                                                             "count; the pages of the classes mark them"),
                                {inDoubt->toString().toStdString()}});
    return forEach(db,
                   "SELECT u.object, u.seq FROM audit u WHERE u.action = 'attempt.add' AND NOT EXISTS (SELECT 1 FROM "
                   "attempts a WHERE a.uid = substr(u.object, 9) AND a.person_id IS NOT NULL)",
                   kDoing, {}, [&](const QSqlQuery& row) {
                       say(report, {QT_TRANSLATE_NOOP("Finding", "%1 was removed; row %2 of the audit tells of it"),
                                    {textOf(row, 0), textOf(row, 1)}});
                   });
}

core::Status checkChain(const QSqlDatabase& db, const std::vector<std::string>& witnesses, CheckReport& report,
                        const Progress& progress)
{
    const auto found = checkAudit(db, witnesses, [&](std::int64_t rows) {
        if (progress && rows % 1000 == 0)
            report.isStopped = !progress("audit", rows);
        return !report.isStopped;
    });
    if (!found)
        return tl::unexpected(found.error());
    for (const IntegrityIssue& finding : *found)
        say(report, finding);
    if (!found->empty() && witnesses.empty())  // with witnesses the reason may be a mistyped code
        report.notes.push_back(
            {QT_TRANSLATE_NOOP("Finding", "the audit itself was changed: rows that differ from it may be right all "
                                          "the same"),
             {}});
    if (auto read = forEach(
            db, "SELECT seq, at_utc FROM audit WHERE action = 'audit.older' ORDER BY seq", kDoing, {},
            [&](const QSqlQuery& row) {
                report.notes.push_back(
                    {QT_TRANSLATE_NOOP("Finding", "row %1 of the audit (%2): a computer had seen later rows of it. "
                                                  "If nobody restored a backup without Cusp then, somebody put an "
                                                  "older copy in the place of the database"),
                     {textOf(row, 0), textOf(row, 1)}});
            });
        !read)
        return read;
    const auto rows = ask(db, "SELECT COUNT(*) FROM audit", kDoing);
    const auto head = auditHead(db);
    if (!rows || !head)
        return tl::unexpected(rows ? head.error() : rows.error());
    report.auditRows = rows->toLongLong();
    report.auditCode = head->code();
    return {};
}

core::Status checkSums(const QSqlDatabase& db, CheckReport& report)
{
    struct Look
    {
        QString sql;
        const char* words;
    };
    for (const Look& look :
         {Look{"SELECT 'attempt:' || a.uid FROM attempts a LEFT JOIN score_sheets s ON s.attempt_id = a.id WHERE "
               "s.attempt_id IS NULL",
               QT_TRANSLATE_NOOP("Finding", "%1 has no score sheet")},
          Look{
              "SELECT 'person:' || p.uid, s.lesson_id FROM standings s JOIN people p ON p.id = s.person_id LEFT JOIN "
              "(" +
                  selectedStandings() + groupedByLesson() +
                  ") n ON n.person_id = s.person_id AND n.lesson_id = s.lesson_id WHERE n.attempts IS NULL OR "
                  "n.attempts <> s.attempts OR n.best_tenths <> s.best_tenths OR n.passed <> s.passed OR n.last_utc <> "
                  "s.last_utc",
              QT_TRANSLATE_NOOP("Finding", "%1 has a standing in %2 that the attempts do not add up to")},
          Look{"SELECT DISTINCT 'person:' || p.uid, a.lesson_id FROM attempts a JOIN people p ON p.id = a.person_id "
               "WHERE " +
                   isAtItsLesson() +
                   " AND NOT EXISTS (SELECT 1 FROM standings s WHERE s.person_id = a.person_id AND s.lesson_id = "
                   "a.lesson_id)",
               QT_TRANSLATE_NOOP("Finding", "%1 has attempts in %2 and no standing")}})
        if (auto read = forEach(db, look.sql, kDoing, {},
                                [&](const QSqlQuery& row) {
                                    say(report, {look.words, {textOf(row, 0), textOf(row, 1)}});
                                });
            !read)
            return read;
    return {};
}

core::Status checkRecordings(const QSqlDatabase& db, CheckReport& report, const Progress& progress)
{
    const auto hashes = recordingsNamed(db);
    if (!hashes)
        return tl::unexpected(hashes.error());
    std::int64_t looked = 0;
    for (const std::string& hash : *hashes) {
        const auto bytes = recordingOf(db, hash);
        if (!bytes && bytes.error().code != core::ErrorCode::FileMissing &&
            bytes.error().code != core::ErrorCode::BadStructure)
            return tl::unexpected(bytes.error());
        if (!bytes && bytes.error().code == core::ErrorCode::FileMissing)
            say(report,
                {QT_TRANSLATE_NOOP(
                     "Finding",
                     "the recording %1 is not there any more; bring the folder \"recordings\" back from a backup"),
                 {hash.substr(0, kShownDigits)}});
        else if (!bytes)
            say(report, {QT_TRANSLATE_NOOP("Finding",
                                           "the recording %1 was changed or is damaged; bring it back from a backup"),
                         {hash.substr(0, kShownDigits)}});
        if (++looked % 100 == 0 && progress && !progress("recordings", looked)) {
            report.isStopped = true;
            return {};
        }
    }
    return {};
}

/// Reports a head that was signed with the key of another station, because anyone can create a key and sign with it.
core::Status checkSigner(const QSqlDatabase& db, const std::string& stationKey, CheckReport& report)
{
    const auto signer = ask(db, "SELECT station_key FROM audit_seal WHERE id = 1 AND seq > 0", kDoing);
    if (!signer)
        return tl::unexpected(signer.error());
    const std::string key = report.signedBy = signer->toString().toStdString();
    if (!stationKey.empty() && !key.empty() && key != stationKey)
        say(report, {QT_TRANSLATE_NOOP("Finding", "the head of the audit was signed with the key %1, which is not this "
                                                  "computer's; if the file was not written by Cusp on another "
                                                  "computer, somebody has rewritten it"),
                     {key.substr(0, kShownDigits)}});
    return {};
}

}  // namespace

core::Result<CheckReport> checkDatabase(const QSqlDatabase& db, const std::vector<std::string>& witnesses,
                                        const Progress& progress, const std::string& stationKey)
{
    if (auto owner = expectOwner(db, "cusp db check"); !owner)
        return tl::unexpected(owner.error());
    CheckReport report;
    // Reads one consistent state: otherwise a program that writes meanwhile could have changed only some of the tables.
    if (auto begun = execute(db, dialect::beginRead(db), kDoing); !begun)
        return tl::unexpected(begun.error());
    const auto ended = qScopeGuard([&db] { static_cast<void>(execute(db, "ROLLBACK", kDoing)); });
    const std::function<core::Status()> looks[]{
        [&] { return checkSchema(db, report); },
        [&] { return checkPages(db, report); },
        [&] { return checkChain(db, witnesses, report, progress); },
        [&] { return checkSigner(db, stationKey, report); },
        [&] { return checkAttempts(db, report, progress); },
        [&] { return compareWithAudit(db, [&report](const IntegrityIssue& finding) { say(report, finding); }); },
        [&] { return checkSums(db, report); },
        [&] { return checkVersions(db, [&report](const IntegrityIssue& finding) { say(report, finding); }); },
        [&] { return checkRecordings(db, report, progress); },
    };
    for (const auto& look : looks) {
        // Each check has its own limit, so that many findings of one check do not hide those of the next.
        report.mostFindings = report.findings.size() + kMostFindings;
        const core::Status done = look();
        if (!done &&
            (done.error().code == core::ErrorCode::ConnectionLost || done.error().code == core::ErrorCode::Busy))
            return tl::unexpected(done.error());
        if (!done) {
            report.isWhole = false;
            report.findings.push_back(
                {QT_TRANSLATE_NOOP("Finding", "the check could not go on: %1"), {done.error().detail}});
        }
        if (!done || report.isStopped)
            break;
    }
    return report;
}

}  // namespace database::sql
