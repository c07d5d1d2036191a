// SPDX-License-Identifier: GPL-3.0-or-later
// cusp user: commands for single people of a school. cusp import roster and cusp export attempts: for many at once.
#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <system_error>

#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonObject>
#include <QSaveFile>

#include "cli/Commands.h"
#include "cli/parts/Arguments.h"
#include "cli/parts/SchoolParts.h"
#include "cli/parts/StopSignal.h"
#include "core/base/WholeFile.h"
#include "database/Codes.h"
#include "database/Csv.h"
#include "database/sql/Classes.h"
#include "database/sql/Database.h"
#include "database/sql/Erasing.h"
#include "database/sql/Export.h"
#include "database/sql/Logins.h"
#include "database/sql/People.h"
#include "database/sql/Roster.h"

namespace cli {
namespace {

using core::ErrorCode;
using database::Person;
using database::Role;

QString roleWord(Role role)
{
    return QString::fromUtf8(database::roleName(role).data());
}

void addCommon(QCommandLineParser& parser)
{
    addDatabaseOption(parser);
    addPersonOption(parser);
    parser.addOption({QStringLiteral("json"), QStringLiteral("Answers in JSON.")});
}

/// An open school and the login of the acting user.
struct Desk
{
    OpenSchool open;
    database::Login session;
};

core::Result<Desk> deskOf(const QCommandLineParser& parser)
{
    const auto address = databaseAddress(parser);
    if (!address)
        return tl::unexpected(address.error());
    auto open = openSchool(*address, Opening::AsItIs);
    if (!open)
        return tl::unexpected(withWayBack(open.error(), *address));
    auto session = logIn(parser, *open);
    if (!session)
        return tl::unexpected(session.error());
    return Desk{std::move(*open), std::move(*session)};
}

QJsonObject toJson(const Person& person)
{
    return {{"username", QString::fromStdString(person.username)},
            {"given_name", QString::fromStdString(person.givenName)},
            {"family_name", QString::fromStdString(person.familyName)},
            {"role", roleWord(person.role)},
            {"disabled", person.disabled},
            {"has_password", person.hasPassword},
            {"last_login_utc", QString::fromStdString(person.lastLoginUtc)}};
}

/// Checks that the codes were printed. They are shown only once. If printing fails, the change in the database stays.
int expectTold(const std::string& done)
{
    if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0)
        return kDone;
    std::clearerr(stdout);  // the error is reported here
    return failed({ErrorCode::FileUnwritable, "the answer could not be written to standard output; " + done});
}

/// @param done  "s1001 is entered"
int tellCode(const QCommandLineParser& parser, const QString& username, const std::string& code,
             const std::string& done)
{
    if (parser.isSet(QStringLiteral("json")))
        printJson({{"username", username}, {"code", QString::fromStdString(code)}});
    else
        printText(QStringLiteral("%1 logs in once with the code %2 within three days, and then chooses a password.\n")
                      .arg(username, QString::fromStdString(code)));
    return expectTold(done + ", but the code is lost: \"cusp user reset " + username.toStdString() +
                      "\" gives another");
}

int addUser(const QCommandLineParser& parser, const QString& username)
{
    const auto role = database::roleOf(parser.value(QStringLiteral("role")).toStdString());
    if (!role || *role == Role::Guest)
        return wrongUsage(QStringLiteral("--role wants student, instructor or admin"));
    const auto desk = deskOf(parser);
    if (!desk)
        return failed(desk.error());
    const auto entered =
        database::sql::addPerson(*desk->open.school, desk->session,
                                 {username.toStdString(), parser.value(QStringLiteral("given")).toStdString(),
                                  parser.value(QStringLiteral("family")).toStdString(), *role});
    if (!entered)
        return failed(entered.error());
    const QString name = QString::fromStdString(entered->person.username);
    return tellCode(parser, name, entered->code, name.toStdString() + " is entered");
}

int listUsers(const QCommandLineParser& parser, const QString&)
{
    const auto desk = deskOf(parser);
    if (!desk)
        return failed(desk.error());
    const auto people = database::sql::listPeople(*desk->open.school, desk->session);
    if (!people)
        return failed(people.error());
    QJsonArray list;
    QString text;
    for (const Person& person : *people) {
        list += toJson(person);
        text += QStringLiteral("%1 %2 %3%4\n")
                    .arg(printable(QString::fromStdString(person.username)), -20)
                    .arg(roleWord(person.role), -11)
                    .arg(printable(QString::fromStdString(person.fullName())),
                         person.disabled ? QStringLiteral("  (disabled)") : QString());
    }
    if (parser.isSet(QStringLiteral("json")))
        printJson({{"people", list}});
    else
        printText(text);
    return kDone;
}

int resetUser(const QCommandLineParser& parser, const QString& username)
{
    const auto desk = deskOf(parser);
    if (!desk)
        return failed(desk.error());
    const auto person = database::sql::findPerson(*desk->open.school, desk->session, username.toStdString());
    if (!person)
        return failed(person.error());
    const auto reset = database::sql::resetPassword(*desk->open.school, desk->session, person->id);
    if (!reset)
        return failed(reset.error());
    if (person->disabled)
        warn({username.toStdString() + " is disabled and cannot log in, with a code or without; \"cusp user disable " +
              username.toStdString() + " --enable\" lets them in again"});
    return tellCode(parser, username, reset->code, "the password of " + username.toStdString() + " is taken away");
}

int disableUser(const QCommandLineParser& parser, const QString& username)
{
    const auto desk = deskOf(parser);
    if (!desk)
        return failed(desk.error());
    auto person = database::sql::findPerson(*desk->open.school, desk->session, username.toStdString());
    if (!person)
        return failed(person.error());
    person->disabled = !parser.isSet(QStringLiteral("enable"));
    if (const auto changed = database::sql::changePerson(*desk->open.school, desk->session, *person); !changed)
        return failed(changed.error());
    if (parser.isSet(QStringLiteral("json")))
        printJson(toJson(*person));
    else
        printText(QStringLiteral("%1 %2 log in.\n")
                      .arg(username, person->disabled ? QStringLiteral("can no longer") : QStringLiteral("can")));
    return kDone;
}

int eraseUser(const QCommandLineParser& parser, const QString& username)
{
    if (!parser.isSet(QStringLiteral("yes")))
        return wrongUsage(QStringLiteral("erasing removes the names, the login and the comments by and about %1, and "
                                         "cannot be undone; if that is meant, add --yes")
                              .arg(printable(username)));
    const auto desk = deskOf(parser);
    if (!desk)
        return failed(desk.error());
    const auto person = database::sql::findPerson(*desk->open.school, desk->session, username.toStdString());
    if (!person)
        return failed(person.error());
    const auto erased = database::sql::erasePerson(*desk->open.school, desk->session, person->id);
    if (!erased)
        return failed(erased.error());
    if (!erased->isFileClean)
        warn({"another program was using the database file, so unused parts of it may contain the names until another "
              "person is erased"});
    if (parser.isSet(QStringLiteral("json"))) {
        printJson(toJson(erased->person));
        return kDone;
    }
    printText(QStringLiteral("%1 was erased; the attempts stay as %2. The names may still be in backups (delete those "
                             "made before now), exported files and printed reports.\n")
                  .arg(QString::fromStdString(person->username), QString::fromStdString(erased->person.username)));
    return kDone;
}

void nothing(QCommandLineParser&) {}

void addNames(QCommandLineParser& parser)
{
    parser.addOption({QStringLiteral("given"), QStringLiteral("Given name."), QStringLiteral("NAME")});
    parser.addOption({QStringLiteral("family"), QStringLiteral("Family name."), QStringLiteral("NAME")});
    parser.addOption({QStringLiteral("role"), QStringLiteral("student, instructor or admin; student if not given."),
                      QStringLiteral("ROLE"), QStringLiteral("student")});
}

void addEnable(QCommandLineParser& parser)
{
    parser.addOption({QStringLiteral("enable"), QStringLiteral("Lets the person log in again.")});
}

void addYes(QCommandLineParser& parser)
{
    parser.addOption({QStringLiteral("yes"), QStringLiteral("Confirms that the person is erased for good.")});
}

struct Part
{
    const char* name;
    const char* usage;
    const char* summary;
    void (*addOptions)(QCommandLineParser& parser);
    int (*run)(const QCommandLineParser& parser, const QString& username);
    bool takesName = true;
};

constexpr std::array kParts{
    Part{"add", "cusp user add NAME --as ADMIN [--given NAME] [--family NAME] [--role ROLE] [--db FILE|URL]",
         "adds a person and prints the one-time code for their first login", addNames, addUser},
    Part{"list", "cusp user list --as NAME [--db FILE|URL] [--json]", "lists the people one may see", nothing,
         listUsers, false},
    Part{"reset", "cusp user reset NAME --as ADMIN [--db FILE|URL]",
         "removes a password and prints a one-time code in its place", nothing, resetUser},
    Part{"disable", "cusp user disable NAME --as ADMIN [--enable] [--db FILE|URL]",
         "lets a person no longer log in; their attempts stay", addEnable, disableUser},
    Part{"erase", "cusp user erase NAME --as ADMIN --yes [--db FILE|URL]",
         "erases names, login and comments for good; attempts stay under a pseudonym", addYes, eraseUser},
};

/// Returns an error for a path that SQLite uses for its own files: SQLite could delete the file, or read it into the
/// database.
core::Status expectNotBeside(const QString& path, const database::Address& school)
{
    const auto placeOf = [](const QString& file) {
        const QFileInfo info(file);
        return QDir(info.dir().canonicalPath()).filePath(info.fileName());
    };
    for (const char* end : database::sql::kBeside)
        if (!school.isServer() && placeOf(path) == placeOf(school.file + QLatin1String(end)))
            return core::unexpected(ErrorCode::FileUnwritable,
                                    path.toStdString() + " is a name that belongs to the school's file; give another");
    return {};
}

/// Returns an error if the file exists, because overwriting a file of codes would lose them.
core::Status expectNew(const QString& path, const database::Address& school)
{
    if (QFileInfo::exists(path))
        return core::unexpected(ErrorCode::FileUnwritable,
                                "there is a file " + path.toStdString() +
                                    " already, and codes overwrite nothing; give another name");
    return expectNotBeside(path, school);
}

/// Returns the path where a table is written. It may replace an older table, but not a database, a station's key or a
/// backup. Follows links first, because saving through a link would replace its target.
core::Result<QString> placeOfTable(const QString& path, const database::Address& school)
{
    const QFileInfo named(path);
    if (auto free = expectNotBeside(path, school); !free)
        return tl::unexpected(free.error());
    if (!named.exists() && !named.isSymLink())
        return path;
    if (!named.isFile())
        return core::unexpected(ErrorCode::FileUnwritable,
                                path.toStdString() + " is no file; name one, or - for standard output");
    const QString place = named.canonicalFilePath();
    std::error_code unknown;
    const bool isSchool = !school.isServer() &&
                          std::filesystem::equivalent(place.toStdU16String(), school.file.toStdU16String(), unknown);
    if (isSchool || QFileInfo(place).suffix().compare(u"csv", Qt::CaseInsensitive) != 0)
        return core::unexpected(ErrorCode::FileUnwritable,
                                "there is a file " + place.toStdString() +
                                    " already that is no table of last time; give another name, ending in .csv");
    return place;
}

int tellRoster(const QCommandLineParser& parser, const database::RosterOutcome& outcome, bool dryRun, bool tellsCodes)
{
    const auto fresh = [&outcome](database::Role role) {
        return std::count_if(outcome.people.begin(), outcome.people.end(),
                             [role](const database::RosterPerson& one) { return one.isNew && one.role == role; });
    };
    const auto known = std::count_if(outcome.people.begin(), outcome.people.end(),
                                     [](const database::RosterPerson& one) { return !one.isNew; });
    const auto expectRosterTold = [&] {
        const bool isLost = !dryRun && tellsCodes && known < static_cast<qint64>(outcome.people.size());
        return isLost ? expectTold("the list is entered, but the codes are lost: \"cusp user reset\" gives each of "
                                   "the new ones another")
                      : kDone;
    };
    QJsonArray faults;
    QString text;
    for (const database::RosterFault& fault : outcome.faults) {
        faults += QJsonObject{{"line", fault.line},
                              {"column", QString::fromStdString(fault.column)},
                              {"what", QString::fromStdString(fault.what)}};
        text += QStringLiteral("line %1%2: %3\n")
                    .arg(fault.line)
                    .arg(fault.column.empty() ? QString() : ", column " + QString::fromStdString(fault.column),
                         printable(QString::fromStdString(fault.what)));
    }
    QJsonArray people;
    for (const database::RosterPerson& person : outcome.people)
        people += QJsonObject{{"username", QString::fromStdString(person.username)},
                              {"name", QString::fromStdString(person.fullName)},
                              {"role", QString::fromUtf8(database::roleName(person.role).data())},
                              {"new", person.isNew},
                              {"name_before", QString::fromStdString(person.nameBefore)},
                              {"short_line", person.isShort},
                              {"code", tellsCodes ? QString::fromStdString(person.code) : QString()}};
    if (parser.isSet(QStringLiteral("json"))) {
        printJson({{"dry_run", dryRun}, {"faults", faults}, {"people", people}});
        return outcome.faults.empty() ? expectRosterTold() : kFailed;
    }
    if (!outcome.faults.empty()) {
        printText(text, stderr);
        return failed({ErrorCode::BadStructure, "nobody was entered; correct the lines above and import again"});
    }
    printText(QStringLiteral("%1: %2 new (students: %3, instructors: %4, admins: %5); %6 known already.\n")
                  .arg(dryRun ? QStringLiteral("This would be entered") : QStringLiteral("Entered"))
                  .arg(static_cast<qint64>(outcome.people.size()) - known)
                  .arg(fresh(database::Role::Student))
                  .arg(fresh(database::Role::Instructor))
                  .arg(fresh(database::Role::Admin))
                  .arg(known));
    for (const database::RosterPerson& person : outcome.people)
        if (!person.nameBefore.empty())
            printText(QStringLiteral("other name: %1 was %2\n")
                          .arg(printable(QString::fromStdString(person.username + ' ' + person.fullName)),
                               printable(QString::fromStdString(person.nameBefore))));
    for (const database::RosterPerson& person : outcome.people)
        if (person.isShort)
            printText(QStringLiteral("fewer fields than the first line names: %1\n")
                          .arg(printable(QString::fromStdString(person.username + ' ' + person.fullName))));
    for (const std::string& name : outcome.newClasses)
        printText(QStringLiteral("new class: %1\n").arg(printable(QString::fromStdString(name))));
    if (!dryRun && tellsCodes)
        for (const database::RosterPerson& person : outcome.people)
            if (person.isNew)
                printText(QStringLiteral("%1 %2\n")
                              .arg(printable(QString::fromStdString(person.username)), -20)
                              .arg(QString::fromStdString(person.code)));
    return expectRosterTold();
}

}  // namespace

int userCommand(const QStringList& arguments)
{
    const QString name = arguments.value(0);
    if (arguments.isEmpty() || name == u"--help" || name == u"-h") {
        QString text = QStringLiteral("Usage: cusp user PART [OPTIONS]\nThe people of a school.\n\n");
        for (const Part& part : kParts)
            text += QStringLiteral("  %1 %2\n").arg(QLatin1String(part.name), -9).arg(QLatin1String(part.summary));
        text += QStringLiteral("\nThe first admin is entered by \"cusp db init --admin NAME\" or in the window.\n");
        printText(text, arguments.isEmpty() ? stderr : stdout);
        return arguments.isEmpty() ? kWrongUsage : kDone;
    }
    const auto* const part =
        std::find_if(kParts.begin(), kParts.end(), [&](const Part& p) { return name == QLatin1String(p.name); });
    if (part == kParts.end())
        return wrongUsage(QStringLiteral("cusp user has no part \"%1\"; \"cusp user --help\" lists those there are")
                              .arg(printable(name)));
    QCommandLineParser parser;
    parser.setApplicationDescription(QStringLiteral("%1.").arg(QLatin1String(part->summary)));
    addCommon(parser);
    part->addOptions(parser);
    if (const auto code = parse(parser, arguments.mid(1), QLatin1String(part->usage)))
        return *code;
    if (parser.positionalArguments().size() != (part->takesName ? 1 : 0))
        return wrongUsage(QStringLiteral("usage: ") + QLatin1String(part->usage));
    if (const auto code = refuseNobody(parser))
        return *code;
    return part->run(parser, parser.positionalArguments().value(0));
}

int importCommand(const QStringList& arguments)
{
    const QString usage = QStringLiteral("cusp import roster FILE.csv --as ADMIN [--dry-run] [--codes FILE.csv]");
    QCommandLineParser parser;
    parser.setApplicationDescription(
        QStringLiteral("Enters a class list, all or nothing. The first line of the CSV names its columns: username, "
                       "given_name, family_name, role, class."));
    addCommon(parser);
    parser.addOption({QStringLiteral("dry-run"), QStringLiteral("Says what would be entered, and what is wrong.")});
    parser.addOption({QStringLiteral("codes"),
                      QStringLiteral("Writes the one-time codes there, for the owner's eyes only, instead of printing "
                                     "them."),
                      QStringLiteral("FILE.csv")});
    if (const auto code = parse(parser, arguments, usage))
        return *code;
    const QStringList words = parser.positionalArguments();
    if (words.size() != 2 || words.front() != u"roster")
        return wrongUsage("usage: " + usage);
    if (const auto code = refuseNobody(parser))
        return *code;
    // Checked before opening the file, because reading a pipe could block forever.
    const QFileInfo list(words.back());
    if (list.exists() && !list.isFile())
        return failed({ErrorCode::FileUnreadable,
                       "the class list " + words.back().toStdString() + " is no file; name a file of CSV"});
    QFile file(words.back());
    if (!file.open(QIODevice::ReadOnly))
        return failed({list.exists() ? ErrorCode::FileUnreadable : ErrorCode::FileMissing,
                       "the class list " + words.back().toStdString() + " cannot be read; check its name"});
    constexpr qint64 kMost = qint64{32} << 20;
    const QByteArray csv = file.read(kMost);
    const auto desk = deskOf(parser);
    if (!desk)
        return failed(desk.error());
    const bool dryRun = parser.isSet(QStringLiteral("dry-run"));
    const bool toFile = parser.isSet(QStringLiteral("codes"));
    const QString codes = parser.value(QStringLiteral("codes"));
    if (const auto fit = toFile ? expectNew(codes, desk->open.database->address()) : core::Status(); !fit)
        return failed(fit.error());
    // The codes are on the disk before they become valid: otherwise a program that ends in between would lose them.
    const QString part = codes + QStringLiteral(".part");
    if (const auto fit = toFile ? expectNew(part, desk->open.database->address()) : core::Status(); !fit)
        return failed(fit.error());
    bool isKept = false;
    const auto keepCodes = [&](const std::vector<database::RosterPerson>& people) {
        isKept = toFile;
        return toFile ? database::writeCodes(part, people) : core::Status();
    };
    const auto outcome = database::sql::importRoster(*desk->open.school, desk->session,
                                                     {csv.constData(), static_cast<std::size_t>(csv.size())}, dryRun,
                                                     nullptr, keepCodes);
    const bool hasCodes = outcome && std::any_of(outcome->people.begin(), outcome->people.end(),
                                                 [](const auto& person) { return person.isNew; });
    if (isKept && !hasCodes)
        QFile::remove(part);
    if (!outcome)
        return failed({outcome.error().code, words.back().toStdString() + ": " + outcome.error().detail});
    if (outcome->faults.empty() && outcome->people.empty())
        return failed({ErrorCode::FileEmpty,
                       words.back().toStdString() + ": there is nobody in it, only the line that names the columns"});
    if (isKept && hasCodes && !QFile::rename(part, codes)) {
        // The people exist in the database now, so their codes must not be lost.
        tellRoster(parser, *outcome, dryRun, true);
        return failed({ErrorCode::FileUnwritable, "the codes are in " + part.toStdString() +
                                                      ", which could not be renamed to " + codes.toStdString()});
    }
    return tellRoster(parser, *outcome, dryRun, !toFile);
}

int exportCommand(const QStringList& arguments)
{
    const QString usage = QStringLiteral("cusp export attempts --csv FILE|- --as NAME");
    QCommandLineParser parser;
    parser.setApplicationDescription(QStringLiteral("Writes the attempts one may see as CSV."));
    addCommon(parser);
    parser.addOption(
        {QStringLiteral("csv"), QStringLiteral("The file; - for standard output."), QStringLiteral("FILE|-")});
    if (const auto code = parse(parser, arguments, usage))
        return *code;
    if (parser.positionalArguments() != QStringList{QStringLiteral("attempts")} || !parser.isSet(QStringLiteral("csv")))
        return wrongUsage("usage: " + usage);
    if (const auto code = refuseNobody(parser))
        return *code;
    const auto desk = deskOf(parser);
    if (!desk)
        return failed(desk.error());
    const QString path = parser.value(QStringLiteral("csv"));
    const bool toStdout = path == u"-";
    const auto place = toStdout ? core::Result<QString>() : placeOfTable(path, desk->open.database->address());
    if (!place)
        return failed(place.error());
    // Created before the file, whose destructor removes its temporary file when the command is stopped.
    const StopSignal stop;
    // The table contains names and scores: a new file is readable only by its owner, and an existing one keeps its
    // permissions.
    const bool isNew = !QFileInfo::exists(*place);
    QSaveFile file(*place);
    if (!toStdout &&
        (!file.open(QIODevice::WriteOnly) || (isNew && !file.setPermissions(QFile::ReadOwner | QFile::WriteOwner))))
        return failed({ErrorCode::FileUnwritable, "the file " + path.toStdString() + " cannot be written (" +
                                                      file.errorString().toStdString() + "); choose another place"});
    const auto count = database::sql::exportAttempts(*desk->open.school, desk->session, [&](std::string_view line) {
        const auto size = static_cast<qint64>(line.size());
        if (StopSignal::hasCome())
            return false;
        return toStdout ? std::fwrite(line.data(), 1, line.size(), stdout) == line.size()
                        : file.write(line.data(), size) == size;
    });
    if (StopSignal::hasCome())
        return failed(
            {ErrorCode::FileUnwritable, "the attempts were not all written: it was stopped" +
                                            std::string(toStdout ? "" : ", and the file is as it was before")});
    if (!count)
        return failed(count.error());
    if (toStdout ? std::fflush(stdout) != 0 : !file.flush() || !file.commit())
        return failed({ErrorCode::FileUnwritable, (toStdout ? "standard output" : "the file " + path.toStdString()) +
                                                      " could not be written to its end; make room on the disk"});
    if (parser.isSet(QStringLiteral("json")) && !toStdout)
        printJson({{"attempts", static_cast<qint64>(*count)}, {"file", path}});
    else if (!toStdout)
        printText(QStringLiteral("%1 attempts were written to %2.\n").arg(QString::number(*count), path));
    return kDone;
}

}  // namespace cli
