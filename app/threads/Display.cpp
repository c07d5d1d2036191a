// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/threads/Display.h"

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <future>
#include <iterator>
#include <memory>
#include <thread>

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QLibrary>
#include <QLibraryInfo>
#include <QProcess>
#include <QStandardPaths>

namespace app {
namespace {

const QString kX11 = QStringLiteral("xcb");
const QString kWayland = QStringLiteral("wayland");
constexpr std::chrono::seconds kPatience(10);
constexpr const char* kChoice = "QT_QPA_PLATFORM";

/// Returns the name of a platform, without the options behind a colon.
QString nameOf(const QString& platform)
{
    return platform.section(u':', 0, 0);
}

/// Scripts that want no window ask for these platforms. None can draw with OpenGL.
bool isBlind(const QString& platform)
{
    return QStringList{QStringLiteral("offscreen"), QStringLiteral("minimal"), QStringLiteral("minimalegl"),
                       QStringLiteral("vnc"), QStringLiteral("linuxfb")}
        .contains(nameOf(platform));
}

/// Returns whether Qt has a plugin for a platform. It cannot be told if the environment names other folders of plugins.
bool hasPlugin(const QString& platform)
{
    if (qEnvironmentVariableIsSet("QT_PLUGIN_PATH") || qEnvironmentVariableIsSet("QT_QPA_PLATFORM_PLUGIN_PATH"))
        return true;
    const QDir plugins(QLibraryInfo::path(QLibraryInfo::PluginsPath) + QStringLiteral("/platforms"));
    return !plugins.entryList({QStringLiteral("libq%1.so").arg(platform), QStringLiteral("libq%1-*.so").arg(platform)})
                .isEmpty();
}

/// Returns why no window can be opened on the X server that DISPLAY names; empty if one can.
QString whyNoX11()
{
    const QString display = qEnvironmentVariable("DISPLAY");
    if (display.isEmpty())
        return QStringLiteral("there is no display");
    struct Connection;
    QLibrary library(QStringLiteral("xcb"), 1);
    const auto connectTo = reinterpret_cast<Connection* (*)(const char*, int*)>(library.resolve("xcb_connect"));
    const auto errorOf = reinterpret_cast<int (*)(Connection*)>(library.resolve("xcb_connection_has_error"));
    const auto disconnect = reinterpret_cast<void (*)(Connection*)>(library.resolve("xcb_disconnect"));
    if (!hasPlugin(kX11) || connectTo == nullptr || errorOf == nullptr || disconnect == nullptr)
        return QStringLiteral("Qt cannot open windows under X11 (Debian package libqt6gui6)");
    // The other end of a frozen tunnel (ssh -X) accepts the connection and never answers.
    const auto isThere = std::make_shared<std::promise<bool>>();
    std::future<bool> answer = isThere->get_future();
    std::thread([=] {
        Connection* const connection = connectTo(nullptr, nullptr);  // never null
        isThere->set_value(errorOf(connection) == 0);
        disconnect(connection);
    }).detach();
    if (answer.wait_for(kPatience) != std::future_status::ready)
        return QStringLiteral("the X server at DISPLAY=%1 does not answer").arg(display);
    return answer.get() ? QString() : QStringLiteral("no X server lets this program in at DISPLAY=%1").arg(display);
}

/// Returns why no window can be opened on the Wayland server that the environment names; empty if one can.
QString whyNoWayland()
{
    if (qEnvironmentVariableIsSet("WAYLAND_SOCKET"))  // an open connection, given by the server
        return {};
    const QString display = qEnvironmentVariable("WAYLAND_DISPLAY");
    if (display.isEmpty())
        return QStringLiteral("there is no display");
    if (!hasPlugin(kWayland))
        return QStringLiteral("Qt cannot open windows under Wayland (Debian package qt6-wayland)");
    // As libwayland does: a name is in XDG_RUNTIME_DIR, which has to be an absolute path.
    const QByteArray path = QFile::encodeName(
        display.startsWith(u'/') ? display : qEnvironmentVariable("XDG_RUNTIME_DIR") + u'/' + display);
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    bool isThere = false;
    if (path.startsWith('/') && path.size() < static_cast<qsizetype>(sizeof(address.sun_path))) {
        std::memcpy(address.sun_path, path.constData(), static_cast<std::size_t>(path.size()));
        const int connection = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
        isThere = connect(connection, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) == 0;
        close(connection);
    }
    return isThere ? QString() : QStringLiteral("no Wayland server answers at WAYLAND_DISPLAY=%1").arg(display);
}

/// Returns whether a window can be opened on a platform of Qt. Platforms beside X11 and Wayland need no server.
bool isOpenable(const QString& platform)
{
    const QString name = nameOf(platform);
    if (name == kX11)
        return whyNoX11().isEmpty();
    if (name.startsWith(kWayland))
        return whyNoWayland().isEmpty();
    return !name.isEmpty() && hasPlugin(name);
}

QStringList openable(const QStringList& platforms)
{
    QStringList found;
    std::copy_if(platforms.begin(), platforms.end(), std::back_inserter(found), isOpenable);
    return found;
}

void choose(const QStringList& platforms)
{
    qputenv(kChoice, platforms.join(u';').toLocal8Bit());
}

}  // namespace

QString whyNoDisplay(const QString& asked)
{
    if (const QStringList found = openable(asked.split(u';')); !found.isEmpty()) {
        choose(found);
        return {};
    }
    QString x11 = whyNoX11();
    QString wayland = whyNoWayland();
    if (x11.isEmpty() && wayland.isEmpty()) {
        qunsetenv(kChoice);  // Qt takes the one of the desktop
        return {};
    }
    if (x11.isEmpty() || wayland.isEmpty()) {
        choose({x11.isEmpty() ? kX11 : kWayland});
        return {};
    }
    if (qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY") || x11 == wayland)
        return x11;
    return qEnvironmentVariableIsEmpty("DISPLAY") ? wayland : x11 + QStringLiteral(", and ") + wayland;
}

bool hasDisplay()
{
    const QString asked = qEnvironmentVariable(kChoice);
    return whyNoDisplay(isBlind(asked) ? QString() : asked).isEmpty();
}

int runOnDisplay(const QStringList& arguments, bool quiet)
{
    QString program = QCoreApplication::applicationFilePath();
    QStringList all = arguments;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    if (isBlind(environment.value(QLatin1String(kChoice))))
        environment.remove(QLatin1String(kChoice));
    if (!hasDisplay()) {
        const QString xvfb = QStandardPaths::findExecutable(QStringLiteral("xvfb-run"));
        if (xvfb.isEmpty())
            return -1;
        // A server that resets when its last client goes signals xvfb-run, whose tidying then ends in code 5.
        const QString server = QStringLiteral("-screen 0 1280x800x24 -noreset");
        all = QStringList{QStringLiteral("-a"), QStringLiteral("-s"), server, program} + arguments;
        program = xvfb;
    }
    QProcess process;
    process.setProcessEnvironment(environment);
    if (!quiet)
        process.setProcessChannelMode(QProcess::ForwardedChannels);
    process.start(program, all);
    if (!process.waitForFinished(-1) || process.exitStatus() != QProcess::NormalExit)
        return -1;
    return process.exitCode();
}

}  // namespace app
