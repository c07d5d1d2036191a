// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <csignal>

namespace cli {

/// While it lives, a signal that ends the program (Ctrl-C, kill, a terminal that is closed) is only noted, so that long
/// work can stop in order and leave nothing half behind; a second one ends it at once. What has come ends the program
/// when this goes, so it is made before all else that has to be tidied. Of one function at a time, on the main thread.
class StopSignal
{
public:
    StopSignal();
    ~StopSignal();
    StopSignal(const StopSignal&) = delete;
    StopSignal& operator=(const StopSignal&) = delete;

    /// Whether one has come.
    [[nodiscard]] static bool hasCome() { return s_came != 0; }

private:
    static constexpr std::array kSignals{SIGINT, SIGTERM, SIGHUP};
    static inline volatile std::sig_atomic_t s_came = 0;  ///< for a handler, which is given nothing else

    std::array<struct sigaction, kSignals.size()> m_knew{};
};

}  // namespace cli
