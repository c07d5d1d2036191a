// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/SchoolParts.h"

#include <cstdio>
#include <iostream>

#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QScopeGuard>
#include <QStandardPaths>
#include <termios.h>
#include <unistd.h>

#include "database/sql/Backups.h"
#include "database/sql/Logins.h"

namespace app::cli {
namespace {

using core::ErrorCode;

/// As the window calls itself, whose data is meant.
QString dataFolder()
{
    return QDir(QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation)).filePath(QStringLiteral("cusp"));
}

/// A file that this user may not read. A pipe is none: it would let wait for ever.
bool isClosed(const QString& path)
{
    const QFileInfo info(path);
    QFile file(path);
    return info.isFile() && !info.isSymLink() && !file.open(QIODevice::ReadOnly);
}

}  // namespace

void addDatabaseOption(QCommandLineParser& parser)
{
    parser.addOption({QStringLiteral("db"),
                      QStringLiteral("The school's data: a file, or postgresql://user@host/name; the user's own file "
                                     "if not given."),
                      QStringLiteral("FILE|URL")});
}

core::Result<database::Address> databaseAddress(const QCommandLineParser& parser)
{
    return database::Address::parse(parser.isSet(QStringLiteral("db"))
                                        ? parser.value(QStringLiteral("db"))
                                        : QDir(dataFolder()).filePath(QStringLiteral("cusp.sqlite")));
}

void makeDataFolder(const database::Address& address)
{
    if (!address.isServer() && QFileInfo(address.file).absolutePath() == dataFolder())
        QDir().mkpath(dataFolder());
}

std::string wayBack(const database::Address& address)
{
    if (address.isServer())
        return {};
    const QString backup = database::sql::newestSound(address.file, QDateTime::currentDateTimeUtc());
    // A restore that somebody stopped in the middle may leave none in the place of the file, where a new one is begun.
    const QString replaced = database::sql::liesEmpty(address.file)
                                 ? database::sql::newestReplaced(address.file, QDateTime::currentDateTimeUtc())
                                 : QString();
    std::string way;
    if (!replaced.isEmpty())
        way = "the newest whole school that a restore has moved aside is " + replaced.toStdString();
    if (!backup.isEmpty())
        way += (way.empty() ? "" : ", ") + ("the newest sound backup is " + backup.toStdString());
    return way.empty() ? way : way + ", and \"cusp db restore\" brings it back";
}

core::Error withWayBack(core::Error error, const database::Address& address)
{
    if (error.code == ErrorCode::BadStructure || error.code == ErrorCode::WrongKind ||
        error.code == ErrorCode::FileMissing)
        if (const std::string way = wayBack(address); !way.empty())
            error.detail += "; " + way;
    return error;
}

QString stationKeyOf(const database::Address& address)
{
    const QString folder = address.isServer() ? dataFolder() : QFileInfo(address.file).absolutePath();
    return QDir(folder).filePath(QStringLiteral("station.key"));
}

core::Result<OpenSchool> openSchool(const database::Address& address, Opening how)
{
    const bool mayCreate = how == Opening::Create;
    if (!mayCreate && !address.isServer() && !QFileInfo::exists(address.file))
        return core::unexpected(ErrorCode::FileMissing, "database " + address.file.toStdString() +
                                                            ": there is no such file; \"cusp db init\" creates one");
    if (mayCreate)
        makeDataFolder(address);
    OpenSchool open;
    database::sql::Database::Options options;
    options.mayMigrate = how == Opening::Migrate || how == Opening::Create;
    options.mayCreate = mayCreate;
    options.onlyLooks = how == Opening::ToLook;
    auto database = database::sql::Database::open(address, options);
    if (!database)
        return tl::unexpected(database.error());
    // A backup that is looked at lies where no station is.
    const QString keyFile = stationKeyOf(address);
    open.hasStationKey = how != Opening::ToLook || QFileInfo::exists(keyFile);
    auto key = open.hasStationKey ? database::StationKey::readOrMake(keyFile)
                                  : core::Result<database::StationKey>(database::StationKey::make());
    // It is its owner's alone. Who may read the database can look at it all the same.
    if (how == Opening::ToLook && !key && isClosed(keyFile)) {
        open.keyFault = key.error().detail;
        open.hasStationKey = false;
        key = database::StationKey::make();
    }
    if (!key)
        return tl::unexpected(key.error());
    open.database = std::move(*database);
    const QSqlDatabase db = open.database->handle();
    open.school = std::make_unique<database::sql::School>(database::sql::School{db, *key, database::sql::clockOf(db)});
    return open;
}

void addPersonOption(QCommandLineParser& parser)
{
    parser.addOption({QStringLiteral("as"),
                      QStringLiteral("Who does it; the password is asked for, or read from standard input."),
                      QStringLiteral("NAME")});
}

core::Result<database::Session> logIn(const QCommandLineParser& parser, const OpenSchool& school)
{
    if (!parser.isSet(QStringLiteral("as")))
        return core::unexpected(ErrorCode::NotAllowed,
                                "that needs a login; say who does it with --as NAME (the password is asked for)");
    const std::string name = parser.value(QStringLiteral("as")).toStdString();
    auto session = database::sql::Logins::login(*school.school, name, askSecret("Password: "));
    if (!session && session.error().code == ErrorCode::NewPassword)
        return core::unexpected(ErrorCode::NewPassword,
                                "the one-time code is right; log in with it in Cusp's window, choose a password there, "
                                "and try again");
    return session;
}

std::string askSecret(const char* question)
{
    std::string line;
    const bool isTerminal = isatty(STDIN_FILENO) != 0;
    termios before{};
    if (isTerminal && tcgetattr(STDIN_FILENO, &before) == 0) {
        std::fputs(question, stderr);
        termios hidden = before;
        hidden.c_lflag &= ~static_cast<tcflag_t>(ECHO);
        tcsetattr(STDIN_FILENO, TCSAFLUSH, &hidden);
    }
    const auto restore = qScopeGuard([&] {
        if (isTerminal) {
            tcsetattr(STDIN_FILENO, TCSAFLUSH, &before);
            std::fputc('\n', stderr);
        }
    });
    std::getline(std::cin, line);
    if (!line.empty() && line.back() == '\r')  // of a file that was written on Windows
        line.pop_back();
    return line;
}

}  // namespace app::cli
