// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace app {

/// Makes a signal that ends the program (a crash, Ctrl+C, the end of the session) set the force of every device to zero
/// first. Signals that somebody else handles already are left to them. Main thread, before a device is started.
///
/// Not covered: SIGKILL, which no program can handle, and a crash in the device's own thread.
void stopForcesOnSignals();

}  // namespace app
