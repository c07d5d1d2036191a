// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/devices/StopForces.h"

#include <array>
#include <csignal>

#include "haptics/falcon/FalconDevice.h"

namespace app {
namespace {

constexpr std::array kDeadly{SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGTERM, SIGINT, SIGHUP, SIGQUIT};
constexpr std::size_t kStackBytes = 64 * 1024;

/// Handles a signal: sets the forces to zero and raises the signal again. Because of SA_RESETHAND the signal then has
/// its default effect, as soon as this returns.
void stopForces(int signal)
{
    haptics::falcon::letGoOfAll();
    static_cast<void>(std::raise(signal));
}

}  // namespace

void stopForcesOnSignals()
{
    // The handler needs a stack of its own, because the signal may come from a stack overflow.
    static std::array<char, kStackBytes> stack;
    stack_t own{};
    own.ss_sp = stack.data();
    own.ss_size = stack.size();
    static_cast<void>(sigaltstack(&own, nullptr));
    for (const int signal : kDeadly) {
        struct sigaction known
        {};
        if (sigaction(signal, nullptr, &known) != 0 || known.sa_handler != SIG_DFL)
            continue;
        struct sigaction ours
        {};
        ours.sa_handler = stopForces;
        ours.sa_flags = static_cast<int>(SA_RESETHAND | SA_ONSTACK);
        static_cast<void>(sigaction(signal, &ours, nullptr));
    }
}

}  // namespace app
