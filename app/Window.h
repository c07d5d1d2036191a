// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace app {

/// Opens the window and runs until it is closed. Options: --tooth FILE|FDI and how to read it, --recording FILE,
/// --device pointer|simulated, --db FILE, --theme light|dark, --language CODE. Returns the exit code; wrong usage is
/// explained on stderr.
int runWindow(int& argc, char** argv);

}  // namespace app
