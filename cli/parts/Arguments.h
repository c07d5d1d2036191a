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

/// Functions for the headless commands: parsing, messages, and the options for teeth.
namespace cli {

/// Parses the arguments after the command's name, with --help added. Returns an exit code if the command is finished:
/// it has printed help, or has explained wrong usage.
/// @param usage  the line after "Usage: ", such as "cusp tooth FILE|FDI [OPTIONS]"
/// @param repeatable  the option that may be given several times, if there is one
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

/// Prints an error and returns an exit code if there is an argument that belongs to no option, for a command that takes
/// none.
[[nodiscard]] std::optional<int> refuseWords(const QCommandLineParser& parser);

/// Adds the options that determine how a tooth is read or generated: --grid --unit --up --fdi --frame --seed --layers
/// --caries --lies --tilt --site --extent.
void addToothOptions(QCommandLineParser& parser);

/// Returns the values of these options, or an error about the first wrong one, for wrongUsage(). Also an error: the
/// number of a tooth that cannot be generated, and options for files with a generated tooth.
[[nodiscard]] core::Result<core::teeth::BuildOptions> toothOptions(const QCommandLineParser& parser,
                                                                   const core::teeth::ToothSource& source);

/// Adds --bur, with the ids of all burs in its help.
/// @param value  name of the value in the help, such as "NAME"
/// @param more   other possible values, such as "or a file"; may be empty
void addBurOption(QCommandLineParser& parser, const QString& value, const QString& more = {});

/// Adds --device: the hand that moves the bur.
/// @param ids  of the hands that can be chosen
void addDeviceOption(QCommandLineParser& parser, const QStringList& ids);

/// Returns the id of the hand; empty if none was given. UnknownName for any other than these.
[[nodiscard]] core::Result<QString> chosenDevice(const QCommandLineParser& parser, const QStringList& ids);

/// Returns a whole number within [low, high] from an option, or an error.
[[nodiscard]] core::Result<qint64> wholeNumber(const QCommandLineParser& parser, const QString& option, qint64 low,
                                               qint64 high);

/// Prints an error and returns an exit code if an argument is not valid UTF-8. Qt would convert it to the name of
/// another file.
[[nodiscard]] std::optional<int> refuseOddNames(std::span<char* const> arguments);

/// Replaces control characters by question marks: text from a file must not control a terminal.
[[nodiscard]] QString printable(QString text);

/// Print the sentence to stderr and return the exit code.
int wrongUsage(const QString& sentence);
int failed(const core::Error& error);

/// Prints each warning to stderr, on its own line.
void warn(const std::vector<std::string>& warnings);

/// Print the results of a command; to stderr if stdout has other contents.
void printText(const QString& text, std::FILE* stream = stdout);
void printJson(const QJsonObject& object, std::FILE* stream = stdout);
[[nodiscard]] QJsonArray toJsonArray(const std::vector<std::string>& sentences);

/// Parses a size such as 1280x800, each 16 to 8192 pixels.
[[nodiscard]] std::optional<QSize> pictureSize(const QString& text);

}  // namespace cli
