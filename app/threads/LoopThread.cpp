// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/threads/LoopThread.h"

#include <pthread.h>
#include <sched.h>

#include <algorithm>

namespace app {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::microseconds kShortestStep{1};

LoopThread::LoopThread(core::rt::Loop& loop, std::chrono::microseconds period, Urgency urgency)
    : m_loop(loop), m_period(period), m_urgency(urgency)
{}

LoopThread::~LoopThread()
{
    requestInterruption();
    wait();
}

void LoopThread::run()
{
    if (m_urgency == Urgency::RealTime) {
        // Refused without the right to it, and then the loop runs like any thread: missed periods are counted and
        // shown.
        sched_param parameter{};
        parameter.sched_priority = 10;
        static_cast<void>(pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameter));
    }
    m_loop.begin();
    auto due = Clock::now();
    std::chrono::microseconds step = m_period;
    while (!isInterruptionRequested()) {
        const auto begun = Clock::now();
        m_loop.tick(step);
        due += m_period;
        step = m_period;
        if (const auto now = Clock::now(); now > due) {
            const auto missed = (now - due) / m_period;
            due += missed * m_period;
            step += missed * m_period;
        }
        if (m_loop.waitForBeat(due)) {
            due = Clock::now();
            step = std::max(kShortestStep, std::chrono::duration_cast<std::chrono::microseconds>(due - begun));
        }
    }
    m_loop.end();
}

}  // namespace app
