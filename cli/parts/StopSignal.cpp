// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/parts/StopSignal.h"

#include <cstdio>

namespace cli {

StopSignal::StopSignal()
{
    struct sigaction ours
    {};
    ours.sa_handler = [](int signal) { s_came = signal; };
    ours.sa_flags = SA_RESTART | SA_RESETHAND;
    for (std::size_t k = 0; k < kSignals.size(); ++k) {
        sigaction(kSignals[k], &ours, &m_knew[k]);
        // A signal that is ignored (nohup) stays ignored, so that the program survives it.
        if (m_knew[k].sa_handler == SIG_IGN)
            sigaction(kSignals[k], &m_knew[k], nullptr);
    }
}

StopSignal::~StopSignal()
{
    for (std::size_t k = 0; k < kSignals.size(); ++k)
        sigaction(kSignals[k], &m_knew[k], nullptr);
    if (!hasCome())
        return;
    std::fflush(nullptr);  // the signal may arrive after all work is done, with output still buffered
    std::raise(s_came);
}

}  // namespace cli
