// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

namespace app {

/// Whether Qt finds a display to open. Asked before there is an application: without one Qt would abort with a message
/// of its own.
[[nodiscard]] bool hasDisplay();

/// Runs this very program with other arguments on the display there is, or on one of its own from xvfb-run, and waits
/// for it. Needs a QCoreApplication.
/// @param quiet  what it says is kept from the user
/// @return its exit code; -1 if it could not be run, crashed or took longer than two minutes
[[nodiscard]] int runOnDisplay(const QStringList& arguments, bool quiet);

}  // namespace app
