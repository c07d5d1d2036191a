// SPDX-License-Identifier: GPL-3.0-or-later
// cusp db: commands for a whole database.
#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <vector>

#include <QDateTime>
#include <QDir>
#include <QElapsedTimer>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonObject>
#include <unistd.h>

#include "app/school/AttemptToCheck.h"
#include "app/school/SchoolService.h"
#include "bench/Circumstances.h"
#include "cli/Commands.h"
#include "cli/parts/Arguments.h"
#include "cli/parts/SchoolParts.h"
#include "cli/parts/StopSignal.h"
#include "database/Outbox.h"
#include "database/Usernames.h"
#include "database/sql/Attempts.h"
#include "database/sql/Audit.h"
#include "database/sql/Backups.h"
#include "database/sql/Check.h"
#include "database/sql/Classes.h"
#include "database/sql/Copy.h"
#include "database/sql/Export.h"
#include "database/sql/Grants.h"
#include "database/sql/Logins.h"
#include "database/sql/Overview.h"
#include "database/sql/People.h"
#include "database/sql/Repositories.h"
#include "database/sql/Statement.h"

namespace cli {
namespace {

using core::ErrorCode;
using database::Address;
using database::sql::Database;

/// One subcommand of `cusp db`, with its options parsed and its address known.
struct Part
{
    const char* name;
    const char* usage;
    const char* summary;
    void (*addOptions)(QCommandLineParser& parser);
    int (*run)(const QCommandLineParser& parser, const Address& address);
    bool takesFile = false;  ///< one argument after the options
};

void nothing(QCommandLineParser&) {}

bool wantsJson(const QCommandLineParser& parser)
{
    return parser.isSet(QStringLiteral("json"));
}

/// Shows the progress of a long operation on one line of stderr, if that is a terminal.
void tellProgress(const QString& what, qint64 count)
{
    printText(QStringLiteral("\r%1: %2  ").arg(what).arg(count), stderr);
}

int answer(const QCommandLineParser& parser, const QString& sentence, const QJsonObject& object)
{
    if (wantsJson(parser))
        printJson(object);
    else
        printText(sentence + '\n');
    return kDone;
}

/// Returns true until a signal arrives.
bool goesOn()
{
    return !StopSignal::hasCome();
}

core::Status expectFile(const Address& address)
{
    if (!address.isServer())
        return {};
    return core::unexpected(ErrorCode::WrongKind,
                            "a server's database is backed up by its administrator (pg_dump); \"cusp db copy\" brings "
                            "it into a file");
}

int failedWithBackups(const core::Error& error, const Address& address)
{
    return failed(withWayBack(error, address));
}

int initDatabase(const QCommandLineParser& parser, const Address& address)
{
    const QString admin = parser.value(QStringLiteral("admin"));
    const bool hasAdmin = parser.isSet(QStringLiteral("admin"));
    std::optional<database::Secret> password;
    if (hasAdmin) {
        // Checks the name before the file is created: otherwise an invalid name would leave a database without an
        // admin.
        if (auto fit = database::normalUsername(admin.toStdString()); !fit)
            return failed(fit.error());
        const auto typed = askSecret("Password of the new admin: ");
        if (!typed)
            return failed(typed.error());
        password.emplace(*typed);
        if (auto fit = database::sql::Logins::checkNewPassword(password->text(), admin.toStdString()); !fit)
            return failed(fit.error());
    }
    // For the same reason, the account of the stations is checked now.
    const QString station = parser.value(QStringLiteral("station"));
    const bool hasStation = parser.isSet(QStringLiteral("station"));
    if (hasStation && !address.isServer())
        return wrongUsage(QStringLiteral("--station is for a server; a file has no accounts"));
    if (const auto sql = hasStation ? database::sql::grantsFor(station) : QString(); !sql)
        return failed(sql.error());
    const bool isNew = !address.isServer() && !QFileInfo::exists(address.file);
    const auto open = openSchool(address, Opening::Create);
    if (!open)
        return failedWithBackups(open.error(), address);
    if (const std::string way = isNew ? wayBack(address) : std::string(); !way.empty())
        warn({"this is a new school, and there are backups of an earlier one: " + way});
    if (hasAdmin) {
        const auto session =
            database::sql::Logins::createFirstAdmin(*open->school, {admin.toStdString(), "", "", database::Role::Admin},
                                                    password->text(), database::timedCost());
        if (!session)
            return failed(session.error());
    }
    if (hasStation)
        if (auto granted = database::sql::applyGrants(open->school->db, station); !granted)
            return failed(granted.error());
    const auto version = database::sql::dialect::schemaVersion(open->school->db);
    if (!version)
        return failed(version.error());
    return answer(parser,
                  QStringLiteral("%1 is ready, with schema %2.").arg(address.shown(), QString::number(*version)),
                  {{"database", address.shown()}, {"schema", *version}, {"admin", admin}, {"station", station}});
}

int printGrants(const QCommandLineParser& parser, const Address& address)
{
    if (!parser.isSet(QStringLiteral("station")))
        return wrongUsage(QStringLiteral("say for which account of the server with --station NAME"));
    const auto sql = database::sql::grantsFor(parser.value(QStringLiteral("station")));
    if (!sql)
        return failed(sql.error());
    if (wantsJson(parser))
        printJson({{"database", address.shown()}, {"sql", *sql}});
    else
        printText(*sql);
    return kDone;
}

int checkWhole(const QCommandLineParser& parser, const Address& address)
{
    std::vector<std::string> witnesses;
    for (const QString& code : parser.values(QStringLiteral("witness"))) {
        witnesses.push_back(code.toStdString());
        if (!database::readAuditCode(witnesses.back()))
            return wrongUsage(QStringLiteral("\"%1\" is no audit code; a report shows one such as 412-9f3ac07be1d2")
                                  .arg(printable(code)));
    }
    const auto open = openSchool(address, Opening::ToLook);
    if (!open)
        return failedWithBackups(open.error(), address);
    const auto report = database::sql::checkDatabase(
        open->school->db, witnesses, {},
        address.isServer() || !open->hasStationKey ? std::string() : open->school->key.publicHex());
    if (!report)
        return failedWithBackups(report.error(), address);
    QJsonArray findings;
    QString text;
    for (const database::IntegrityIssue& finding : report->findings) {
        findings += finding.english();
        text += printable(finding.english()) + '\n';
    }
    std::vector<std::string> notes;
    for (const database::IntegrityIssue& note : report->notes)
        notes.push_back(printable(note.english()).toStdString());
    const bool isSound = report->findings.empty();
    const QString signedBy = QString::fromStdString(report->signedBy);
    const bool isOwnKey = open->hasStationKey && report->signedBy == open->school->key.publicHex();
    const char* const signer = isOwnKey ? ", this computer" : ", another computer";
    const QJsonObject object{{"database", address.shown()},
                             {"sound", isSound},
                             {"findings", findings},
                             {"notes", toJsonArray(notes)},
                             {"attempts", static_cast<qint64>(report->attempts)},
                             {"audit_rows", static_cast<qint64>(report->auditRows)},
                             {"audit_code", QString::fromStdString(report->auditCode)},
                             {"signed_by", signedBy}};
    if (wantsJson(parser))
        printJson(object);
    else
        printText(text + QStringLiteral("%1: %2 attempts, %3 rows of audit, audit code %4%5\n")
                             .arg(isSound ? QStringLiteral("sound") : QStringLiteral("not sound"))
                             .arg(report->attempts)
                             .arg(report->auditRows)
                             .arg(QString::fromStdString(report->auditCode),
                                  signedBy.isEmpty()
                                      ? QString()
                                      : QStringLiteral(", signed by %1%2").arg(signedBy.left(16), signer)));
    warn(notes);
    if (const std::string way = report->isWhole ? std::string() : wayBack(address); !way.empty())
        warn({way});
    return isSound ? kDone : kFailed;
}

int backUpFile(const QCommandLineParser& parser, const Address& address)
{
    if (auto fit = expectFile(address); !fit)
        return failed(fit.error());
    const StopSignal stop;
    const auto open = openSchool(address, Opening::ToLook);
    if (!open)
        return failedWithBackups(open.error(), address);
    const QString folder = parser.isSet(QStringLiteral("to")) ? parser.value(QStringLiteral("to"))
                                                              : database::sql::backupFolder(address.file);
    const auto made = database::sql::backUp(open->school->db, folder, QDateTime::currentDateTimeUtc(), goesOn);
    if (!made)
        return failedWithBackups(made.error(), address);
    const QStringList gone = database::sql::removeOldBackups(open->school->db, folder);
    return answer(parser, QStringLiteral("Backed up to %1. Its pages and keys are whole.").arg(*made),
                  {{"backup", *made}, {"removed", QJsonArray::fromStringList(gone)}});
}

int restoreFile(const QCommandLineParser& parser, const Address& address)
{
    if (auto fit = expectFile(address); !fit)
        return failed(fit.error());
    const StopSignal stop;
    makeDataFolder(address);
    const QString backup = parser.positionalArguments().front();
    // Moves attempts that were delivered since the last backup back to the outbox: the window delivers them again when
    // it opens. This happens before the restore, so that a later failure loses none. Without the station's key an
    // attempt cannot be read, and stays where it is.
    const QDir folder = QFileInfo(address.file).absoluteDir();
    auto key = database::StationKey::make();
    if (QFileInfo::exists(stationKeyOf(address)))
        key = database::StationKey::readOrMake(stationKeyOf(address)).value_or(key);
    database::Outbox(folder.filePath(QStringLiteral("outbox")), key, database::Outbox::schoolAt(address, folder.path()))
        .sendAgain();
    const auto replaced = database::sql::restoreBackup(backup, address.file, QDateTime::currentDateTimeUtc(), goesOn);
    if (!replaced)
        return failed(replaced.error());
    const auto failedInPlace = [&](core::Error error) {
        error.detail += "; the backup is in its place";
        if (!replaced->isEmpty())
            error.detail += ", and what was there lies in " + replaced->toStdString();
        return failed(error);
    };
    const auto open = openSchool(address, Opening::Migrate);
    if (!open)
        return failedInPlace(open.error());
    if (auto noted = database::sql::noteRestored(*open->school, {}, backup); !noted)
        return failedInPlace(noted.error());
    return answer(parser,
                  replaced->isEmpty()
                      ? QStringLiteral("Restored as %1.").arg(address.file)
                      : QStringLiteral("Restored as %1; what was there lies in %2.").arg(address.file, *replaced),
                  {{"database", address.file}, {"replaced", *replaced}});
}

int migrateDatabase(const QCommandLineParser& parser, const Address& address)
{
    const auto open = openSchool(address, Opening::Migrate);
    if (!open)
        return failedWithBackups(open.error(), address);
    const auto version = database::sql::dialect::schemaVersion(open->school->db);
    if (!version)
        return failed(version.error());
    return answer(parser, QStringLiteral("%1 has schema %2.").arg(address.shown(), QString::number(*version)),
                  {{"database", address.shown()}, {"schema", *version}});
}

struct Delivery
{
    int sent = 0;
    int left = 0;
    int damaged = 0;  ///< moved to the folder of damaged files
};

/// Delivers the attempts waiting on this station, and warns of each that could not be delivered.
/// @param isOfAll  whether attempts for other schools are delivered too
Delivery deliverWaiting(const Address& address, const OpenSchool& open, bool isOfAll)
{
    const QDir folder = QFileInfo(stationKeyOf(address)).dir();
    const database::Outbox letters(folder.filePath(QStringLiteral("outbox")), open.school->key);
    const QString school = database::Outbox::schoolAt(address, folder.path());
    Delivery delivery;
    for (const QString& file : letters.waiting()) {
        const auto letter = app::readLetter(letters, file);
        if (letter && !isOfAll && !letter->school.isEmpty() && letter->school != school)
            continue;
        const core::Status done =
            letter ? letter->deliver(*open.school, letter->check()) : tl::unexpected(letter.error());
        if (done) {
            // If several programs deliver the file at once, only the one that removes it counts it.
            if (address.isServer() ? letters.remove(file) : letters.keepArrived(file))
                ++delivery.sent;
            continue;
        }
        if (done.error().code == ErrorCode::FileMissing)  // a window has delivered it
            continue;
        warn({done.error().detail});
        if (!letter && done.error().code == ErrorCode::BadStructure) {
            letters.setAside(file);
            ++delivery.damaged;
        } else {
            ++delivery.left;
        }
    }
    return delivery;
}

/// Delivers all attempts waiting on this station, for any school, because a school may have been renamed or moved.
int sendWaiting(const QCommandLineParser& parser, const Address& address)
{
    const auto open = openSchool(address, Opening::AsItIs);
    if (!open)
        return failedWithBackups(open.error(), address);
    const Delivery done = deliverWaiting(address, *open, true);
    answer(parser,
           QStringLiteral("%1 attempts and beginnings of exams were sent, %2 wait.").arg(done.sent).arg(done.left),
           {{"database", address.shown()}, {"sent", done.sent}, {"waiting", done.left}, {"damaged", done.damaged}});
    return done.left + done.damaged == 0 ? kDone : kFailed;
}

/// Returns the files that a copy creates besides its recordings and that do not exist yet. Empty for a server.
QStringList filesToMake(const Address& target)
{
    QStringList files;
    if (target.isServer())
        return files;
    if (!QFileInfo::exists(target.file))
        files += database::sql::wholeOf(target.file);
    if (const QString key = stationKeyOf(target); !QFileInfo::exists(key))
        files += key;
    return files;
}

int copyDatabase(const QCommandLineParser& parser, const Address& address)
{
    if (!parser.isSet(QStringLiteral("to")))
        return wrongUsage(QStringLiteral("say where with --to FILE or --to postgresql://user@host/name"));
    if (const auto code = refuseNobody(parser))
        return *code;
    const auto target = Address::parse(parser.value(QStringLiteral("to")));
    if (!target)
        return failed(target.error());
    const auto from = openSchool(address, Opening::AsItIs);
    if (!from)
        return failedWithBackups(from.error(), address);
    const auto session = logIn(parser, *from);
    if (!session)
        return failed(session.error());
    // Checks the permission before any file is created at the target.
    if (const auto may = database::sql::authorize(*from->school, *session, database::Operation::CopySchool); !may)
        return failed(may.error());
    // Attempts waiting for this school belong in the copy too: the copy has another identity, so they are not delivered
    // to it.
    const Delivery delivered = deliverWaiting(address, *from, false);
    const StopSignal stop;
    const QStringList made = filesToMake(*target);
    auto to = openSchool(*target, Opening::ToFill);
    if (!to)
        return failed(to.error());
    const bool tells = isatty(STDERR_FILENO) != 0;
    const auto report =
        database::sql::copySchool(*from->school, *session, *to->school, [tells](const QString& table, qint64 rows) {
            if (tells)
                tellProgress(table, rows);
            return !StopSignal::hasCome();
        });
    if (tells)
        printText(QStringLiteral("\n"), stderr);
    if (!report) {
        to->school.reset();
        to->database.reset();
        // Another program may be copying into the target now, or may have done so.
        if (!made.isEmpty() && database::sql::expectClosed(target->file) &&
            database::sql::schoolOf(target->file).empty())
            for (const QString& file : made)
                QFile::remove(file);
        return failed(report.error());
    }
    if (delivered.left > 0)
        warn({std::to_string(delivered.left) +
              " attempts and beginnings of exams wait beside what was copied, and are not in the copy: put right what "
              "is said of them above, and copy again"});
    if (report->recordingsMissing > 0)
        warn({std::to_string(report->recordingsMissing) +
              " recordings are missing or damaged in what was copied: \"cusp db check\" names them; their attempts are "
              "there, and cannot be replayed until the files are brought back from a backup of the folder recordings"});
    return answer(parser,
                  QStringLiteral("Copied and verified: %1 rows, %2 recordings, into %3.")
                      .arg(QString::number(report->rows), QString::number(report->recordings), target->shown()),
                  {{"rows", static_cast<qint64>(report->rows)},
                   {"recordings", static_cast<qint64>(report->recordings)},
                   {"recordings_missing", static_cast<qint64>(report->recordingsMissing)},
                   {"sent", delivered.sent},
                   {"waiting", delivered.left},
                   {"database", target->shown()}});
}

int tellStats(const QCommandLineParser& parser, const Address& address)
{
    const auto open = openSchool(address, Opening::ToLook);
    if (!open)
        return failedWithBackups(open.error(), address);
    if (auto owner = database::sql::expectOwner(open->school->db, "cusp db stats"); !owner)
        return failed(owner.error());
    QJsonObject object{{"database", address.shown()}};
    QString text = address.shown() + '\n';
    const auto version = database::sql::dialect::schemaVersion(open->school->db);
    if (!version)
        return failed(version.error());
    object.insert("schema", *version);
    for (const auto& [name, sql] :
         {std::pair("students", "SELECT count(*) FROM people WHERE role = 'student'"),
          std::pair("instructors", "SELECT count(*) FROM people WHERE role = 'instructor'"),
          std::pair("admins", "SELECT count(*) FROM people WHERE role = 'admin'"),
          std::pair("classes", "SELECT count(*) FROM classes"), std::pair("attempts", "SELECT count(*) FROM attempts"),
          std::pair("comments", "SELECT count(*) FROM comments WHERE withdrawn_utc IS NULL"),
          std::pair("presets", "SELECT count(*) FROM presets"),
          std::pair("audit_rows", "SELECT count(*) FROM audit")}) {
        const auto count = database::sql::ask(open->school->db, QLatin1String(sql), "count its rows");
        if (!count)
            return failed(count.error());
        object.insert(QLatin1String(name), count->toLongLong());
        text += QStringLiteral("  %1 %2\n").arg(QLatin1String(name), -12).arg(count->toLongLong());
    }
    if (!address.isServer()) {
        object.insert("bytes", QFileInfo(address.file).size());
        object.insert("backups",
                      static_cast<qint64>(database::sql::backupsIn(database::sql::backupFolder(address.file)).size()));
    }
    if (wantsJson(parser))
        printJson(object);
    else
        printText(text);
    return kDone;
}

/// Returns three figures of some times, ms: the first time, without caches; the median; and the 99th percentile.
QJsonObject timesOf(std::vector<double> ms)
{
    const auto rounded = [](double time) { return std::round(time * 100.0) / 100.0; };
    const double first = ms.front();
    std::sort(ms.begin(), ms.end());
    return {{"first_ms", rounded(first)},
            {"p50_ms", rounded(ms[ms.size() / 2])},
            {"p99_ms", rounded(ms[(ms.size() * 99 + 99) / 100 - 1])}};
}

/// Measures the pages that students and teachers open most, and an export, with the data in the database.
int measureSchool(const QCommandLineParser& parser, const Address& address)
{
    namespace sql = database::sql;
    if (const auto code = refuseNobody(parser))
        return *code;
    const auto open = openSchool(address, Opening::AsItIs);
    if (!open)
        return failedWithBackups(open.error(), address);
    const auto session = logIn(parser, *open);
    if (!session)
        return failed(session.error());
    const sql::DatabaseContext& school = *open->school;
    const auto people = sql::listPeople(school, *session);
    const auto classes = sql::listClasses(school, *session);
    if (!people || !classes)
        return failed(people ? classes.error() : people.error());
    constexpr std::size_t kLooks = 100;
    constexpr std::size_t kPartsPerLook = 500;
    std::vector<double> history;
    std::vector<double> matrix;
    const auto timed = [](std::vector<double>& ms, const auto& work) {
        QElapsedTimer since;
        since.start();
        core::Status done = work();
        ms.push_back(static_cast<double>(since.nsecsElapsed()) * 1e-6);
        return done;
    };
    for (std::size_t k = 0; k < people->size() && history.size() < kLooks;
         k += std::max<std::size_t>(1, people->size() / kLooks)) {
        const database::Person& person = (*people)[k];
        if (person.role != database::Role::Student)
            continue;
        const auto done = timed(history, [&]() -> core::Status {
            const auto attempts = sql::history(school, *session, person.id, {});
            if (!attempts)
                return tl::unexpected(attempts.error());
            const std::string lesson = attempts->empty() ? std::string() : attempts->front().lessonId;
            const auto band = sql::classBand(school, *session, person.id, lesson);
            const auto medians = sql::classMedians(school, *session, person.id, lesson);
            return band && medians ? core::Status() : core::unexpected(ErrorCode::BadStructure, "a page failed");
        });
        if (!done)
            return failed(done.error());
    }
    for (const database::SchoolClass& one : *classes) {
        const auto done = timed(matrix, [&]() -> core::Status {
            const auto overview = sql::classOverview(school, *session, one.id);
            return overview ? core::Status() : core::Status(tl::unexpected(overview.error()));
        });
        if (!done)
            return failed(done.error());
    }
    if (history.empty() || matrix.empty())
        return failed({ErrorCode::FileEmpty, "nobody is there to measure; enter students and classes first"});
    // Not the peak memory: a login briefly needs more than an export, and would hide that the export grows.
    const double beforeMiB = bench::residentMiB();
    double largestMiB = beforeMiB;
    std::size_t parts = 0;
    QElapsedTimer since;
    since.start();
    const auto rows = sql::exportAttempts(school, *session, [&](std::string_view) {
        if (++parts % kPartsPerLook == 0)
            largestMiB = std::max(largestMiB, bench::residentMiB());
        return true;
    });
    if (!rows)
        return failed(rows.error());
    const double exportS = static_cast<double>(since.nsecsElapsed()) * 1e-9;
    const QJsonObject object{{"database", address.shown()},
                             {"attempts", static_cast<qint64>(*rows)},
                             {"history_page", timesOf(history)},
                             {"class_matrix", timesOf(matrix)},
                             {"export_rows_per_s", std::round(static_cast<double>(*rows) / std::max(exportS, 1e-9))},
                             {"mib_before_export", std::round(beforeMiB)},
                             {"mib_largest_in_export", std::round(largestMiB)}};
    printJson(object);
    return kDone;
}

/// Marks the attempts again that no computer of an instructor or an admin has marked yet.
int markAttempts(const QCommandLineParser& parser, const Address& address)
{
    if (const auto code = refuseNobody(parser))
        return *code;
    const StopSignal stop;
    const auto open = openSchool(address, Opening::AsItIs);
    if (!open)
        return failedWithBackups(open.error(), address);
    const auto session = logIn(parser, *open);
    if (!session)
        return failed(session.error());
    std::set<std::int64_t> unreadable;
    QJsonArray doubts;
    int marked = 0;
    core::Status done;
    database::sql::withRepositories(*open->school, [&](const database::Repositories& school) {
        while (done && goesOn()) {
            const auto next = app::nextToCheck(school, *session, unreadable);
            if (!next)
                done = tl::unexpected(next.error());
            if (!next || !*next)
                return;
            const app::AttemptToCheck& toCheck = **next;
            if (!toCheck.recording) {
                unreadable.insert(toCheck.attempt.id);
                continue;
            }
            const database::Doubt found = app::check(toCheck);
            done = school.attempts.noteCheck(*session, {toCheck.attempt.id}, found);
            if (!done)
                return;
            ++marked;
            if (found != database::Doubt::None)
                doubts += QJsonObject{{"attempt", QString::fromStdString(toCheck.attempt.uid)},
                                      {"doubt", QString::fromStdString(database::doubtId(found))}};
        }
    });
    if (!done)
        return failed(done.error());
    return answer(parser,
                  QStringLiteral("%1 attempts were marked again, %2 of them are in doubt; %3 have a recording that "
                                 "cannot be read.")
                      .arg(marked)
                      .arg(doubts.size())
                      .arg(unreadable.size()),
                  {{"marked", marked}, {"doubts", doubts}, {"unreadable", static_cast<int>(unreadable.size())}});
}

void addStation(QCommandLineParser& parser)
{
    parser.addOption({QStringLiteral("station"),
                      QStringLiteral("An account of the server that owns nothing there, for the stations; the "
                                     "server's administrator has created it."),
                      QStringLiteral("NAME")});
}

void addAdmin(QCommandLineParser& parser)
{
    addStation(parser);
    parser.addOption({QStringLiteral("admin"),
                      QStringLiteral("Enters the first admin under this name; the password is asked for, or read from "
                                     "standard input."),
                      QStringLiteral("NAME")});
}

void addWitness(QCommandLineParser& parser)
{
    parser.addOption({QStringLiteral("witness"),
                      QStringLiteral("An audit code that a printed report shows, such as 412-9f3ac07be1d2; may be "
                                     "given several times."),
                      QStringLiteral("CODE")});
}

void addBackupFolder(QCommandLineParser& parser)
{
    parser.addOption({QStringLiteral("to"),
                      QStringLiteral("The folder; beside cusp.sqlite \"backups\" if not given, beside X.sqlite "
                                     "\"X.sqlite-backups\"."),
                      QStringLiteral("FOLDER")});
}

void addTarget(QCommandLineParser& parser)
{
    addPersonOption(parser);
    parser.addOption({QStringLiteral("to"),
                      QStringLiteral("An empty or new database: a file, or "
                                     "postgresql://user@host/name."),
                      QStringLiteral("FILE|URL")});
}

constexpr std::array kParts{
    Part{"init", "cusp db init [--db FILE|URL] [--admin NAME] [--station NAME]",
         "creates the database, and its first admin; gives stations an account with few rights", addAdmin,
         initDatabase},
    Part{"grants", "cusp db grants --station NAME", "prints the SQL by which \"init --station\" gives those rights",
         addStation, printGrants},
    Part{"check", "cusp db check [--db FILE|URL] [--witness CODE]... [--json]",
         "looks at everything: pages, keys, audit, attempts; names what was changed", addWitness, checkWhole},
    Part{"backup", "cusp db backup [--db FILE] [--to FOLDER] [--json]",
         "copies the file, checks the pages and keys of the copy, and removes older backups", addBackupFolder,
         backUpFile},
    Part{"restore", "cusp db restore BACKUP [--db FILE]", "puts a backup in the place of the file", nothing,
         restoreFile, true},
    Part{"migrate", "cusp db migrate [--db FILE|URL]", "brings an older database to this program's schema", nothing,
         migrateDatabase},
    Part{"mark", "cusp db mark --as NAME [--db FILE|URL] [--json]",
         "marks attempts again from their recordings, and notes which are in doubt", addPersonOption, markAttempts},
    Part{"send", "cusp db send [--db FILE|URL]",
         "delivers what waits on this computer, also what waits for this school under another name", nothing,
         sendWaiting},
    Part{"copy", "cusp db copy --as ADMIN [--db FILE|URL] --to FILE|URL",
         "brings a school into another database, and verifies it", addTarget, copyDatabase},
    Part{"stats", "cusp db stats [--db FILE|URL] [--json]", "counts what is there", nothing, tellStats},
    Part{"measure", "cusp db measure --as ADMIN [--db FILE|URL]",
         "times the history page, the class matrix and an export", addPersonOption, measureSchool},
};

}  // namespace

int dbCommand(const QStringList& arguments)
{
    const QString name = arguments.value(0);
    if (arguments.isEmpty() || name == u"--help" || name == u"-h") {
        QString text = QStringLiteral("Usage: cusp db PART [OPTIONS]\nThe school's data as a whole.\n\n");
        for (const Part& part : kParts)
            text += QStringLiteral("  %1 %2\n").arg(QLatin1String(part.name), -9).arg(QLatin1String(part.summary));
        text += QStringLiteral("\n\"cusp db PART --help\" explains a part.\n");
        printText(text, arguments.isEmpty() ? stderr : stdout);
        return arguments.isEmpty() ? kWrongUsage : kDone;
    }
    const auto* const part =
        std::find_if(kParts.begin(), kParts.end(), [&](const Part& p) { return name == QLatin1String(p.name); });
    if (part == kParts.end())
        return wrongUsage(QStringLiteral("cusp db has no part \"%1\"; \"cusp db --help\" lists those there are")
                              .arg(printable(name)));
    QCommandLineParser parser;
    parser.setApplicationDescription(QStringLiteral("%1.").arg(QLatin1String(part->summary)));
    addDatabaseOption(parser);
    part->addOptions(parser);
    addJson(parser);
    if (const auto code = parse(parser, arguments.mid(1), QLatin1String(part->usage), QStringLiteral("witness")))
        return *code;
    if (parser.positionalArguments().size() != (part->takesFile ? 1 : 0))
        return wrongUsage(QStringLiteral("usage: ") + QLatin1String(part->usage));
    const auto address = databaseAddress(parser);
    return address ? part->run(parser, *address) : failed(address.error());
}

}  // namespace cli
