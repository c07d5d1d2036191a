// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace app {

/// Installs handlers for the signals that end the program (a crash, Ctrl+C, the end of the session). They set the force
/// of every device to zero first. Signals that already have another handler keep it. Call it in the main thread, before
/// a device is started.
///
/// Does not cover SIGKILL, which no program can handle, and a crash in the device's own thread.
void stopForcesOnSignals();

}  // namespace app
