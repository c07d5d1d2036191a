// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

#include <QStringList>

#include "cli/parts/ExitCode.h"

/// The program without its window. Commands need no display; figures go to
/// stdout, errors to stderr in one sentence.
namespace cli {

/// What a command needs to draw: nothing, Qt's widgets for charts but no screen, or a display with OpenGL, if there is
/// one.
enum class Draws { Nothing, Charts, Tooth };

struct Command
{
    const char* name;
    const char* summary;                       ///< one line for `cusp help`
    int (*run)(const QStringList& arguments);  ///< arguments after the command's name; returns an ExitCode
    Draws draws = Draws::Nothing;
    const char* drawingPart = nullptr;  ///< the only part or option of it that draws; null: all of it
};

/// All of them, in the order `cusp help` shows. To add one: XCommand.cpp with a function, and a line in Commands.cpp.
[[nodiscard]] std::span<const Command> commands();

/// Runs the command that the command line names, or prints help or version. Nothing when the window is to open: no
/// argument, or an option that is the window's.
[[nodiscard]] std::optional<int> run(int& argc, char** argv);

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
