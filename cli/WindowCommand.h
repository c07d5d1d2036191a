// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace cli {

/// Opens the window and runs until it is closed. Returns the exit code. Explains wrong usage on stderr.
int runWindow(int& argc, char** argv);

/// Returns the options that runWindow() accepts, with explanations, one per line.
[[nodiscard]] QString windowOptionsHelp();

}  // namespace cli
