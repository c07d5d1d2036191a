// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

namespace app {

/// Finds a display for a window, and sets QT_QPA_PLATFORM so that Qt opens this display. Qt alone would try only its
/// favourite and abort if that one does not answer. Call it before there is a QGuiApplication, from one thread.
/// @param asked  platforms that the user asks for, as in QT_QPA_PLATFORM; empty: none in particular
/// @return nothing if there is a display; otherwise why there is none, a clause in English
[[nodiscard]] QString whyNoDisplay(const QString& asked);

/// Whether there is a display on which a tooth can be drawn. Otherwise as whyNoDisplay().
[[nodiscard]] bool hasDisplay();

/// Runs this program with other arguments on the available display, or on one of its own from xvfb-run, and waits until
/// it ends: on a busy machine a picture may take minutes. Needs a QCoreApplication.
/// @param quiet  its output is not shown
/// @return its exit code; -1 if it could not be started or crashed
[[nodiscard]] int runOnDisplay(const QStringList& arguments, bool quiet);

}  // namespace app
