// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QThread>
#include <chrono>

#include "core/rt/Loop.h"

namespace app {

/// Runs a core::rt::Loop in a thread of its own: at a fixed period, or when the input of the loop has a beat of its own
/// (Loop::waitForBeat). A beat that comes late is told how many periods it stands for; missed beats are skipped, never
/// caught up in a burst.
class LoopThread final : public QThread
{
    Q_OBJECT

public:
    enum class Urgency { Normal, RealTime };

    /// @param loop  must outlive the thread
    LoopThread(core::rt::Loop& loop, std::chrono::microseconds period, Urgency urgency);
    /// Asks the loop to stop and waits for it.
    ~LoopThread() override;

protected:
    void run() override;

private:
    core::rt::Loop& m_loop;
    std::chrono::microseconds m_period;
    Urgency m_urgency;
};

}  // namespace app
