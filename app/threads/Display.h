// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

namespace app {

/// Whether Qt finds a display to open. Asked before there is an application: without one Qt would abort with a message
/// of its own.
[[nodiscard]] bool hasDisplay();

/// Runs this program with other arguments on the available display, or on one of its own from xvfb-run, and waits until
/// it ends: on a busy machine a picture may take minutes. Needs a QCoreApplication.
/// @param quiet  its output is not shown
/// @return its exit code; -1 if it could not be started or crashed
[[nodiscard]] int runOnDisplay(const QStringList& arguments, bool quiet);

}  // namespace app
