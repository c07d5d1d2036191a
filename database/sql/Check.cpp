// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/sql/Check.h"

#include <array>

#include <QJsonDocument>
#include <QJsonObject>

#include "database/sql/Attempts.h"
#include "database/sql/Audit.h"
#include "database/sql/Noted.h"
#include "database/sql/Recordings.h"
#include "database/sql/SchemaCheck.h"
#include "database/sql/Statement.h"

namespace database::sql {
namespace {

using Progress = std::function<bool(const char* what, std::int64_t rows)>;

const std::string kDoing = "check it";

void say(CheckReport& report, const std::string& sentence)
{
    if (report.findings.size() < report.mostFindings)
        report.findings.push_back(sentence);
}

core::Status checkPages(const QSqlDatabase& db, CheckReport& report)
{
    if (dialect::isPostgres(db))
        return {};  // the server's own business
    if (auto read = forEach(db, "PRAGMA integrity_check", kDoing, {},
                            [&](const QSqlQuery& row) {
                                if (row.value(0).toString() != u"ok")
                                    say(report,
                                        "the file is damaged: " + row.value(0).toString().simplified().toStdString());
                            });
        !read)
        return read;
    return forEach(db, "PRAGMA foreign_key_check", kDoing, {}, [&](const QSqlQuery& row) {
        say(report, "row " + textOf(row, 1) + " of " + textOf(row, 0) + " belongs to no row of " + textOf(row, 2));
    });
}

core::Status checkAttempts(const QSqlDatabase& db, CheckReport& report, const Progress& progress)
{
    // Those without an owner were made before there were people, and before there was an audit.
    const auto early = ask(db, "SELECT COUNT(*) FROM attempts WHERE person_id IS NULL", kDoing);
    if (!early)
        return tl::unexpected(early.error());
    report.attempts = early->toLongLong();
    if (auto read = forEachAttempt(db,
                                   [&](const AttemptRecord& attempt, const std::string& noted) {
                                       if (report.isStopped)
                                           return;
                                       const std::string named = "attempt " + attempt.uid + " (" + attempt.finishedUtc +
                                                                 ", " + attempt.lessonId + ")";
                                       const std::string digest =
                                           QJsonDocument::fromJson(QByteArray::fromStdString(noted))
                                               .object()
                                               .value(QStringLiteral("digest"))
                                               .toString()
                                               .toStdString();
                                       if (noted.empty())
                                           say(report, named + " was inserted: the audit knows nothing of it");
                                       else if (digest != digestOfAttempt(attempt))
                                           say(report, named + " was changed after it had been kept");
                                       if (++report.attempts % 1000 == 0 && progress)
                                           report.isStopped = !progress("attempts", report.attempts);
                                   });
        !read)
        return read;
    return forEach(db,
                   "SELECT u.object, u.seq FROM audit u WHERE u.action = 'attempt.add' AND NOT EXISTS (SELECT 1 FROM "
                   "attempts a WHERE a.uid = substr(u.object, 9))",
                   kDoing, {}, [&](const QSqlQuery& row) {
                       say(report,
                           textOf(row, 0) + " was removed; row " + textOf(row, 1) + " of the audit tells of it");
                   });
}

/// Both ways: a start that was taken away would give back an attempt.
core::Status checkExamStarts(const QSqlDatabase& db, CheckReport& report)
{
    if (auto read = forEach(db,
                            "SELECT u.object, u.seq FROM audit u WHERE u.action = 'exam.begin' AND NOT EXISTS (SELECT "
                            "1 FROM exam_starts s JOIN people p ON p.id = s.person_id WHERE s.uid = substr(u.object, "
                            "6) AND p.uid = u.actor)",
                            kDoing, {},
                            [&](const QSqlQuery& row) {
                                say(report, textOf(row, 0) + " was removed or changed; row " + textOf(row, 1) +
                                                " of the audit tells of it");
                            });
        !read)
        return read;
    return forEach(db,
                   "SELECT s.uid, s.lesson_id, s.begun_utc, COALESCE(u.detail, '') FROM exam_starts s LEFT JOIN audit "
                   "u ON u.object = 'exam:' || s.uid AND u.action = 'exam.begin'",
                   kDoing, {}, [&](const QSqlQuery& row) {
                       const QJsonObject noted = QJsonDocument::fromJson(row.value(3).toByteArray()).object();
                       if (noted.isEmpty())
                           say(report, "exam:" + textOf(row, 0) + " was inserted: the audit knows nothing of it");
                       else if (noted.value(QStringLiteral("lesson")).toString() != row.value(1).toString() ||
                                noted.value(QStringLiteral("begun")).toString() != row.value(2).toString())
                           say(report, "exam:" + textOf(row, 0) + " was changed after it had been noted");
                   });
}

core::Status checkSums(const QSqlDatabase& db, CheckReport& report)
{
    struct Look
    {
        const char* sql;
        const char* what;
    };
    for (const Look& look :
         {Look{
              "SELECT a.uid FROM attempts a LEFT JOIN score_sheets s ON s.attempt_id = a.id WHERE s.attempt_id IS NULL",
              "has no score sheet"},
          Look{"SELECT s.person_id || ' in ' || s.lesson_id FROM standings s LEFT JOIN (SELECT person_id, lesson_id, "
               "COUNT(*) n, MAX(COALESCE(given_tenths, score_tenths)) best, MAX(CASE WHEN given_tenths IS NULL THEN "
               "passed WHEN given_tenths >= pass_mark_tenths THEN 1 ELSE 0 END) passed FROM attempts GROUP BY "
               "person_id, "
               "lesson_id) "
               "a ON a.person_id = s.person_id AND a.lesson_id = s.lesson_id WHERE a.n IS NULL OR a.n <> s.attempts OR "
               "a.best <> s.best_tenths OR a.passed <> s.passed",
               "has a standing that its attempts do not add up to"},
          Look{"SELECT DISTINCT a.person_id || ' in ' || a.lesson_id FROM attempts a WHERE a.person_id IS NOT NULL AND "
               "NOT EXISTS (SELECT 1 FROM standings s WHERE s.person_id = a.person_id AND s.lesson_id = a.lesson_id)",
               "has attempts and no standing"}})
        if (auto read = forEach(db, QLatin1String(look.sql), kDoing, {},
                                [&](const QSqlQuery& row) { say(report, textOf(row, 0) + ' ' + look.what); });
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
        if (!bytes)
            say(report, bytes.error().detail);
        if (++looked % 100 == 0 && progress && !progress("recordings", looked)) {
            report.isStopped = true;
            return {};
        }
    }
    return {};
}

/// Anybody can make a key and sign with it.
core::Status checkSigner(const QSqlDatabase& db, const std::string& stationKey, CheckReport& report)
{
    const auto signer = ask(db, "SELECT station_key FROM audit_seal WHERE id = 1 AND seq > 0", kDoing);
    if (!signer)
        return tl::unexpected(signer.error());
    const std::string key = signer->toString().toStdString();
    if (!stationKey.empty() && !key.empty() && key != stationKey)
        say(report, "the head of the audit was signed with the key " + key.substr(0, 16) +
                        ", which is not this computer's; if the file was not written by Cusp on another computer, "
                        "somebody has rewritten it");
    return {};
}

}  // namespace

core::Result<CheckReport> checkDatabase(const QSqlDatabase& db, const std::vector<std::string>& witnesses,
                                        const Progress& progress, const std::string& stationKey)
{
    CheckReport report;
    if (auto done = checkPages(db, report); !done)
        return tl::unexpected(done.error());
    auto chain = checkAudit(db, witnesses, [&](std::int64_t row) {
        report.auditRows = row;
        if (progress && row % 1000 == 0)
            report.isStopped = !progress("audit", row);
        return !report.isStopped;
    });
    if (!chain)
        return tl::unexpected(chain.error());
    for (const std::string& finding : *chain)
        say(report, "audit: " + finding);
    const auto tell = [&report](const std::string& sentence) { say(report, sentence); };
    const std::array<std::function<core::Status()>, 7> looks{
        [&] { return checkSchema(db, tell); },
        [&] { return checkAttempts(db, report, progress); },
        [&] { return checkExamStarts(db, report); },
        [&] { return checkSums(db, report); },
        [&] { return compareWithAudit(db, tell); },
        [&] { return checkRecordings(db, report, progress); },
        [&] { return checkSigner(db, stationKey, report); },
    };
    for (const auto& look : looks) {
        if (report.isStopped)
            return report;
        // Much of one kind hides nothing of another.
        report.mostFindings = report.findings.size() + kMostFindings;
        if (auto done = look(); !done)
            return tl::unexpected(done.error());
    }
    const auto head = ask(db, "SELECT seq || '-' || substr(hash, 1, 12) FROM audit_seal", kDoing);
    if (!head)
        return tl::unexpected(head.error());
    report.auditCode = head->toString().toStdString();
    return report;
}

}  // namespace database::sql
