// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace support {

/// Mutexes and condition variables that the calling thread has locked or waited for so far: including this header's
/// function in a test puts counters before pthread_mutex_lock and its kin. Always 0 under sanitizers, which need their
/// own.
[[nodiscard]] long locksOnThisThread();

}  // namespace support
