// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/parts/SchoolParts.h"

#include <array>
#include <csignal>
#include <cstdio>
#include <iostream>
#include <optional>

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QStandardPaths>
#include <termios.h>
#include <unistd.h>

#include "cli/parts/Arguments.h"
#include "database/sql/Backups.h"
#include "database/sql/Logins.h"

namespace cli {
namespace {

using core::ErrorCode;

/// Returns the window's data folder, although the command has another application name.
QString dataFolder()
{
    return QDir(QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation)).filePath(QStringLiteral("cusp"));
}

/// Turns off the echo of a terminal while it exists. If the program is stopped meanwhile, the echo is on until the
/// program continues.
class HiddenTyping
{
public:
    HiddenTyping()
    {
        tcgetattr(STDIN_FILENO, &shown);
        hide();
        for (std::size_t k = 0; k < kSignals.size(); ++k)
            m_knew[k] = catchIt(kSignals[k]);
    }
    ~HiddenTyping()
    {
        for (std::size_t k = 0; k < kSignals.size(); ++k)
            sigaction(kSignals[k], &m_knew[k], nullptr);
        tcsetattr(STDIN_FILENO, TCSAFLUSH, &shown);
    }
    HiddenTyping(const HiddenTyping&) = delete;
    HiddenTyping& operator=(const HiddenTyping&) = delete;

private:
    static constexpr std::array kSignals{SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGTSTP};
    static inline termios shown{};  ///< static, because the signal handler has no other access

    static void hide()
    {
        termios hidden = shown;
        hidden.c_lflag &= ~static_cast<tcflag_t>(ECHO);
        tcsetattr(STDIN_FILENO, TCSAFLUSH, &hidden);
    }
    /// Sets a one-time handler that restores the echo before the usual effect of the signal. Returns the handler that
    /// was set before.
    static struct sigaction catchIt(int signal)
    {
        struct sigaction ours
        {};
        struct sigaction before
        {};
        ours.sa_handler = &showAgain;
        ours.sa_flags = SA_RESTART | SA_RESETHAND | SA_NODEFER;
        sigaction(signal, &ours, &before);
        // A signal that is ignored (nohup) stays ignored, so that the program survives it.
        if (before.sa_handler == SIG_IGN)
            sigaction(signal, &before, nullptr);
        return before;
    }
    static void showAgain(int signal)
    {
        tcsetattr(STDIN_FILENO, TCSANOW, &shown);
        raise(signal);
        // The program was stopped, and continues now.
        hide();
        catchIt(signal);
    }

    std::array<struct sigaction, kSignals.size()> m_knew{};
};

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
    const QString backup = address.isServer() ? QString() : database::sql::newestSound(address.file);
    if (backup.isEmpty())
        return {};
    return "the newest sound backup is " + backup.toStdString() + ", and \"cusp db restore\" brings it back";
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
    const bool mayCreate = how == Opening::Create || how == Opening::ToFill;
    if (!mayCreate && !address.isServer() && !QFileInfo::exists(address.file))
        return core::unexpected(ErrorCode::FileMissing, "database " + address.file.toStdString() +
                                                            ": there is no such file; \"cusp db init\" creates one");
    if (mayCreate)
        makeDataFolder(address);
    OpenSchool open;
    database::sql::Database::Options options;
    options.mayMigrate = how == Opening::Migrate || mayCreate;
    options.isToBeFilled = how == Opening::ToFill;
    options.mayCreate = mayCreate;
    auto database = database::sql::Database::open(address, options);
    if (!database)
        return tl::unexpected(database.error());
    // Only reading a backup does not need the key of a station.
    const QString keyFile = stationKeyOf(address);
    open.hasStationKey = how != Opening::ToLook || QFileInfo::exists(keyFile);
    auto key = open.hasStationKey ? database::StationKey::readOrMake(keyFile)
                                  : core::Result<database::StationKey>(database::StationKey::make());
    if (!key)
        return tl::unexpected(key.error());
    open.database = std::move(*database);
    if (!open.database->notice().empty())
        warn({open.database->notice()});
    const QSqlDatabase db = open.database->handle();
    open.school = std::make_unique<database::sql::DatabaseContext>(
        database::sql::DatabaseContext{db, *key, database::sql::clockOf(db)});
    return open;
}

void addPersonOption(QCommandLineParser& parser)
{
    parser.addOption({QStringLiteral("as"),
                      QStringLiteral("Who does it; the password is asked for, or read from standard input."),
                      QStringLiteral("NAME")});
}

std::optional<int> refuseNobody(const QCommandLineParser& parser)
{
    if (!parser.value(QStringLiteral("as")).isEmpty())
        return std::nullopt;
    return wrongUsage(QStringLiteral("that needs a login; say who does it with --as NAME (the password is asked for)"));
}

core::Result<database::Login> logIn(const QCommandLineParser& parser, const OpenSchool& school)
{
    const std::string name = parser.value(QStringLiteral("as")).toStdString();
    const auto password = askSecret("Password: ");
    if (!password)
        return tl::unexpected(password.error());
    auto session = database::sql::Logins::login(*school.school, name, password->text());
    if (!session && session.error().code == ErrorCode::NewPassword)
        return core::unexpected(ErrorCode::NewPassword,
                                "the one-time code is right; log in with it in Cusp's window, choose a password there, "
                                "and try again");
    return session;
}

core::Result<database::Secret> askSecret(const char* question)
{
    std::optional<HiddenTyping> hidden;
    if (isatty(STDIN_FILENO) != 0) {
        std::fputs(question, stderr);
        hidden.emplace();
    }
    std::string line;
    const bool isGiven = static_cast<bool>(std::getline(std::cin, line));
    if (hidden)
        std::fputc('\n', stderr);
    if (!isGiven)
        return core::unexpected(ErrorCode::FileEmpty, "no password was given, so nothing was done");
    if (!line.empty() && line.back() == '\r')  // the line is from a file written on Windows
        line.pop_back();
    database::Secret secret(line);
    database::wipe(line);
    return secret;
}

}  // namespace cli
