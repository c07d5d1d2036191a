// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QJsonObject>
#include <QStringList>

/// The built program, run as a user runs it: in its own process, with stdout and stderr separate.
namespace support {

/// The result of a run.
struct Ending
{
    int exitCode = -1;  ///< -1: killed by a signal
    QByteArray out;
    QByteArray error;
    long peakMiB = 0;

    /// Returns stdout as a JSON object; empty if it is none.
    [[nodiscard]] QJsonObject json() const;
    /// Returns whether stderr is one line, "cusp: " and a sentence with its full stop, and stdout is empty.
    [[nodiscard]] bool isOneSentence() const;
};

/// Runs cusp to its end without a display.
/// @param environment  "NAME=value" each, on top of this process's own
/// @param input  its standard input
[[nodiscard]] Ending runCusp(const QStringList& arguments, const QStringList& environment = {},
                             const QByteArray& input = {});

/// Checks that the program ended with exit code 0. A failure names the line of the call; Clang 14 has no
/// std::source_location.
void expectDone(const Ending& ending, const char* file = __builtin_FILE(), int line = __builtin_LINE());
/// Checks that the program ended with this exit code and one sentence that contains these words.
void expectRefusal(const Ending& ending, const QByteArray& words = {}, int exitCode = 1,
                   const char* file = __builtin_FILE(), int line = __builtin_LINE());

}  // namespace support
