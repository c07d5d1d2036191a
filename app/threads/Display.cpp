// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/threads/Display.h"

#include <QCoreApplication>
#include <QProcess>
#include <QStandardPaths>

namespace app {
namespace {

/// Asked for by scripts that want no window; neither can draw with OpenGL.
bool isBlind(const QString& platform)
{
    return platform == u"offscreen" || platform == u"minimal";
}

}  // namespace

bool hasDisplay()
{
    return !qEnvironmentVariableIsEmpty("DISPLAY") || !qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY");
}

int runOnDisplay(const QStringList& arguments, bool quiet)
{
    QString program = QCoreApplication::applicationFilePath();
    QStringList all = arguments;
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
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    if (isBlind(environment.value(QStringLiteral("QT_QPA_PLATFORM"))))
        environment.remove(QStringLiteral("QT_QPA_PLATFORM"));
    process.setProcessEnvironment(environment);
    if (!quiet)
        process.setProcessChannelMode(QProcess::ForwardedChannels);
    process.start(program, all);
    if (!process.waitForFinished(-1) || process.exitStatus() != QProcess::NormalExit)
        return -1;
    return process.exitCode();
}

}  // namespace app
