// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

#include <QStringList>
#include <QtGlobal>

#include "cli/parts/ExitCode.h"

/// The commands of the program. They need no window; results go to stdout, errors to stderr in one sentence.
namespace cli {

/// What a command needs for drawing: nothing, Qt's widgets for charts without a screen, or a display with OpenGL, if
/// there is one.
enum class Draws { Nothing, Charts, Tooth };

struct Command
{
    const char* name;
    const char* summary;                       ///< one line for `cusp help`
    int (*run)(const QStringList& arguments);  ///< arguments after the command's name; returns an ExitCode
    Draws draws = Draws::Nothing;
    const char* drawingPart = nullptr;  ///< the only subcommand or option that draws; null: the whole command
};

/// Returns all commands, in the order of `cusp help`. To add a command, create XCommand.cpp with a function and add a
/// line to Commands.cpp.
[[nodiscard]] std::span<const Command> commands();

/// Runs the command of the command line, or prints help or version. Empty if the window has to be opened: without
/// arguments, or with an option of the window.
[[nodiscard]] std::optional<int> run(int& argc, char** argv);

/// Message handler for the start of a QApplication: hides Qt's messages about the desktop, and ends the program with
/// one sentence where Qt would abort.
void hearQtStart(QtMsgType type, const QMessageLogContext& where, const QString& text);

// One function per command, each in its own file.
int toothCommand(const QStringList& arguments);
int simulateCommand(const QStringList& arguments);
int replayCommand(const QStringList& arguments);
int renderCommand(const QStringList& arguments);
int demoCommand(const QStringList& arguments);
int benchCommand(const QStringList& arguments);
int framesCommand(const QStringList& arguments);
int lessonCommand(const QStringList& arguments);
int dbCommand(const QStringList& arguments);
int userCommand(const QStringList& arguments);
int importCommand(const QStringList& arguments);
int exportCommand(const QStringList& arguments);
int presetCommand(const QStringList& arguments);
int falconCommand(const QStringList& arguments);
int trackCommand(const QStringList& arguments);
int soundCommand(const QStringList& arguments);

}  // namespace cli
