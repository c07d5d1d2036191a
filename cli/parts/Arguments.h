// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdio>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <QCommandLineParser>
#include <QJsonArray>
#include <QJsonObject>
#include <QSize>
#include <QStringList>

#include "core/base/Result.h"
#include "core/teeth/ToothBuilder.h"

/// What the headless commands share: parsing, messages, and the options that every command with a tooth takes.
namespace cli {

/// Parses the arguments after the command's name, with --help added. Returns an exit code when the command is over:
/// help was printed, or the usage was wrong and has been explained.
/// @param usage  the line after "Usage: ", such as "cusp tooth FILE|FDI [OPTIONS]"
/// @param repeatable  the option that may have several values, where there is one
[[nodiscard]] std::optional<int> parse(QCommandLineParser& parser, const QStringList& arguments, const QString& usage,
                                       const QString& repeatable = {});

/// Adds --json.
void addJson(QCommandLineParser& parser);

/// A subcommand, such as "list" in "cusp lesson list".
struct CommandPart
{
    const char* name;
    const char* summary;
    int (*run)(const QStringList& arguments);
};

/// Runs the subcommand that is named by the first argument. Prints the list of subcommands for "--help", and an error
/// if there is no such subcommand.
/// @param command  name of the command, such as "lesson"
/// @returns the exit status of the program
int runPart(const QString& command, std::span<const CommandPart> parts, const QStringList& arguments);

/// Adds --grid --unit --up --fdi --frame --seed --layers --caries --lies --tilt --site --extent: how a tooth is read or
/// made.
void addToothOptions(QCommandLineParser& parser);

/// Their values, or a sentence about the first that is wrong: a matter for wrongUsage(). Wrong are also the number of a
/// tooth that cannot be made, and for one that can, options that are about a file.
[[nodiscard]] core::Result<core::teeth::BuildOptions> toothOptions(const QCommandLineParser& parser,
                                                                   const core::teeth::ToothSource& source);

/// Adds --bur, with the ids of all burs in its help.
/// @param value  what the help calls the value, such as "NAME"
/// @param more   what else the value may be, such as "or a file"; may be empty
void addBurOption(QCommandLineParser& parser, const QString& value, const QString& more = {});

/// Adds --device: what moves the bur.
void addDeviceOption(QCommandLineParser& parser);

/// Whether it is the simulated Falcon, or a sentence.
[[nodiscard]] core::Result<bool> wantsSimulatedDevice(const QCommandLineParser& parser);

/// A whole number within [low, high] given to an option, or a sentence.
[[nodiscard]] core::Result<qint64> wholeNumber(const QCommandLineParser& parser, const QString& option, qint64 low,
                                               qint64 high);

/// Says that a name cannot be opened, and gives the exit code, where an argument is not UTF-8: Qt would make another
/// name of it, under which there is no file.
[[nodiscard]] std::optional<int> refuseOddNames(std::span<char* const> arguments);

/// With a question mark for each control character: words out of a file shall not steer a terminal.
[[nodiscard]] QString printable(QString text);

/// Prints the sentence to stderr and returns the exit code that goes with it.
int wrongUsage(const QString& sentence);
int failed(const core::Error& error);

/// Prints each to stderr, on a line of its own: what went well enough to go on.
void warn(const std::vector<std::string>& warnings);

/// The figures that a command answers with. They go to stderr where stdout carries something else.
void printText(const QString& text, std::FILE* stream = stdout);
void printJson(const QJsonObject& object, std::FILE* stream = stdout);
[[nodiscard]] QJsonArray toJsonArray(const std::vector<std::string>& sentences);

/// A size such as 1280x800, each 16 to 8192 pixels.
[[nodiscard]] std::optional<QSize> pictureSize(const QString& text);

}  // namespace cli
