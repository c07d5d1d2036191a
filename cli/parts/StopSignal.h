// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <csignal>

namespace cli {

/// While it exists, a signal that ends the program (Ctrl-C, kill, a closed terminal) is only recorded, so that long
/// work can stop in order and leave no partial results; a second signal ends the program at once. A recorded signal
/// ends the program when this object is destroyed, so create it before all other objects that need cleanup. For one
/// function at a time, on the main thread.
class StopSignal
{
public:
    StopSignal();
    ~StopSignal();
    StopSignal(const StopSignal&) = delete;
    StopSignal& operator=(const StopSignal&) = delete;

    /// Returns whether a signal has arrived.
    [[nodiscard]] static bool hasCome() { return s_came != 0; }

private:
    static constexpr std::array kSignals{SIGINT, SIGTERM, SIGHUP};
    static inline volatile std::sig_atomic_t s_came = 0;  ///< static, because a signal handler has no other access

    std::array<struct sigaction, kSignals.size()> m_knew{};
};

}  // namespace cli
