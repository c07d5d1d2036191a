// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace support {

/// Returns how many mutexes the calling thread has locked, and condition variables it has waited for, so far. Using
/// this function in a test puts counters before pthread_mutex_lock and similar functions. It is always 0 under
/// sanitizers, which need their own.
[[nodiscard]] long locksOnThisThread();

}  // namespace support
