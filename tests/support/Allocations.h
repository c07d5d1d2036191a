// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace support {

/// Calls of operator new made so far by the calling thread. Linking test_support replaces the global operators.
[[nodiscard]] long allocationsOnThisThread();

}  // namespace support
