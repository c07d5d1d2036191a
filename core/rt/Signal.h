// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <chrono>
#include <semaphore>

namespace core::rt {

/// Wakes one thread when another has new data for it. Signals raised before a wait count as one. Publish the data
/// first, through a TripleBuffer or a queue.
class Signal
{
public:
    /// Raises the signal. Never waits. Any thread.
    void raise() noexcept
    {
        if (!m_isRaised.exchange(true, std::memory_order_acq_rel))
            m_semaphore.release();
    }

    /// Waits until the signal is raised or until `due`. Returns whether it was raised. One thread.
    [[nodiscard]] bool waitUntil(std::chrono::steady_clock::time_point due)
    {
        if (!m_semaphore.try_acquire_until(due))
            return false;
        // A raise() from here on wakes the next wait, and data written before an earlier raise() can be read after this
        // line.
        m_isRaised.store(false, std::memory_order_release);
        return true;
    }

private:
    std::counting_semaphore<> m_semaphore{0};
    std::atomic<bool> m_isRaised{false};
};

}  // namespace core::rt
