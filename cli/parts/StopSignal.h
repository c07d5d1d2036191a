// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <csignal>

namespace cli {

/// Delays signals that end the program (Ctrl-C, kill, a closed terminal) while it exists, so that a long operation can
/// stop in order and leave no partial results. A second signal ends the program at once. The destructor ends the
/// program if a signal has arrived, so create this object before all others that need cleanup. Only one may exist at a
/// time, in the main thread.
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
    static inline volatile std::sig_atomic_t s_came = 0;  ///< static, because the signal handler has no other access

    std::array<struct sigaction, kSignals.size()> m_knew{};
};

}  // namespace cli
