// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

namespace app {

/// Finds a display for a window, and sets QT_QPA_PLATFORM so that Qt opens this display. Otherwise Qt would try a
/// single display and abort if it does not answer. Call this before a QGuiApplication is created, from one thread.
/// @param asked  the platforms that the user prefers, as in QT_QPA_PLATFORM; empty: no preference
/// @return an empty string if there is a display; otherwise the reason why there is none, in English
[[nodiscard]] QString whyNoDisplay(const QString& asked);

/// Whether there is a display on which a tooth can be drawn. Otherwise as whyNoDisplay().
[[nodiscard]] bool hasDisplay();

/// Runs this program with other arguments on the available display, or on one of its own from xvfb-run, and waits until
/// it ends: on a busy machine a picture may take minutes. Needs a QCoreApplication.
/// @param quiet  its output is not shown
/// @return its exit code; -1 if it could not be started or crashed
[[nodiscard]] int runOnDisplay(const QStringList& arguments, bool quiet);

}  // namespace app
