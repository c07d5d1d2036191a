// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/Commands.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <memory>

#include <QApplication>

#include "app/threads/Display.h"
#include "cli/WindowCommand.h"
#include "cli/parts/Arguments.h"

namespace cli {
namespace {

constexpr Command kCommands[] = {
    {"tooth", "report on a mesh file or on one of our own teeth", toothCommand},
    {"simulate", "drive the servo tick over a device path and write what happened", simulateCommand},
    {"replay", "replay a recording, measure and score it", replayCommand},
    {"render", "draw a tooth, or what an attempt left of it, into a picture", renderCommand, Draws::Tooth},
    {"lesson", "list lessons; check, begin, preview and pack a teacher's own", lessonCommand, Draws::Tooth, "preview"},
    {"preset", "list, check and show hardness presets", presetCommand},
    {"db", "create, check, back up, restore and copy the school's data", dbCommand},
    {"user", "enter people, list, reset and disable them", userCommand},
    {"import", "enter a class list", importCommand},
    {"export", "write the attempts as CSV", exportCommand},
    {"falcon", "find, test and calibrate a Novint Falcon", falconCommand},
    {"track", "find the tag of head tracking in pictures of a camera, a video or a folder; print a tag", trackCommand,
     Draws::Charts, "--print"},
    {"sound", "write what a simulation would sound like into a WAV file", soundCommand},
    {"demo", "let a simulated hand take the decay out of a tooth", demoCommand},
    {"bench", "measure accuracy, speed and memory on this machine", benchCommand, Draws::Charts},
    {"frames", "measure what a frame of the tooth view costs on this display", framesCommand, Draws::Tooth},
};

const Command* findCommand(const QString& name)
{
    const auto* const found =
        std::find_if(std::begin(kCommands), std::end(kCommands), [&](const Command& c) { return name == c.name; });
    return found == std::end(kCommands) ? nullptr : found;
}

int unknownCommand(const QString& name)
{
    return wrongUsage(QStringLiteral("cusp has no command \"%1\"; \"cusp help\" lists those there are").arg(name));
}

/// Message handler: hides Qt's warnings about a failed statement, because the command reports the error in a sentence.
void hearQt(QtMsgType type, const QMessageLogContext& /*where*/, const QString& text)
{
    if (type == QtFatalMsg)
        std::_Exit(failed({core::ErrorCode::BadStructure, text.toStdString()}));
}

/// Creates the application. Charts need Qt's widgets, but must work without a screen. A tooth needs OpenGL.
std::unique_ptr<QCoreApplication> makeApplication(int& argc, char** argv, Draws draws)
{
    if (draws == Draws::Nothing || (draws == Draws::Tooth && !app::hasDisplay())) {
        qInstallMessageHandler(hearQt);
        return std::make_unique<QCoreApplication>(argc, argv);
    }
    if (draws == Draws::Charts)
        qputenv("QT_QPA_PLATFORM", "offscreen");
    const QtMessageHandler handler = qInstallMessageHandler(hearQtStart);
    auto application = std::make_unique<QApplication>(argc, argv);
    qInstallMessageHandler(handler);
    return application;
}

int printHelp()
{
    QString text = QStringLiteral("Cusp, a trainer for tooth preparation.\n\n"
                                  "  cusp [OPTIONS]            opens the window\n"
                                  "  cusp COMMAND [OPTIONS]    works without a display\n"
                                  "  cusp COMMAND --help       explains a command\n"
                                  "  cusp --version            prints the version\n\n"
                                  "Commands:\n");
    for (const Command& command : kCommands)
        text += QStringLiteral("  %1 %2\n").arg(QLatin1String(command.name), -11).arg(QLatin1String(command.summary));
    text += QStringLiteral("\nOptions of the window:\n") + windowOptionsHelp() +
            QStringLiteral("\nExit status: 0 done, 1 the input or the run failed, 2 wrong usage.\n");
    printText(text);
    return kDone;
}

int helpCommand(const QStringList& arguments)
{
    if (arguments.isEmpty())
        return printHelp();
    const Command* const command = findCommand(arguments.front());
    return command != nullptr ? command->run({QStringLiteral("--help")}) : unknownCommand(arguments.front());
}

}  // namespace

void hearQtStart(QtMsgType type, const QMessageLogContext& /*where*/, const QString& text)
{
    // The first line says what is wrong, the others list the plugins of Qt.
    if (type == QtFatalMsg)
        std::_Exit(failed({core::ErrorCode::FileUnreadable, text.section(u'\n', 0, 0).toStdString()}));
}

std::span<const Command> commands()
{
    return kCommands;
}

std::optional<int> run(int& argc, char** argv)
{
    if (argc < 2)
        return std::nullopt;
    if (const auto code = refuseOddNames({argv + 1, static_cast<std::size_t>(argc - 1)}))
        return code;
    const QString first = QString::fromLocal8Bit(argv[1]);
    const bool help = first == u"help" || first == u"--help" || first == u"-h";
    const bool version = first == u"--version" || first == u"-v";
    if (!help && !version && first.startsWith(u'-'))
        return std::nullopt;
    const Command* const command = findCommand(first);
    const bool draws = command != nullptr && (command->drawingPart == nullptr ||
                                              std::any_of(argv + 2, argv + argc, [&](const char* argument) {
                                                  return QByteArrayView(argument).startsWith(command->drawingPart);
                                              }));
    const auto application = makeApplication(argc, argv, draws ? command->draws : Draws::Nothing);
    const QStringList arguments = QCoreApplication::arguments().mid(2);
    if (help)
        return helpCommand(arguments);
    if (version) {
        printText(QStringLiteral("Cusp " CUSP_VERSION "\n"));
        return kDone;
    }
    if (command == nullptr)
        return unknownCommand(first);
    const int exitCode = command->run(arguments);
    if (std::ferror(stdout) != 0)
        return failed({core::ErrorCode::FileUnwritable, "the answer could not be written to standard output"});
    return exitCode;
}

}  // namespace cli
