// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace cli {

/// Exit codes of every headless command.
enum ExitCode : int { kDone = 0, kFailed = 1, kWrongUsage = 2 };

}  // namespace cli
