// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <thread>

namespace core::rt {

/// Work that is done in periodic ticks. A thread only drives it (app/threads/LoopThread); tests and headless commands
/// call tick() themselves.
class Loop
{
public:
    Loop() = default;
    Loop(const Loop&) = delete;
    Loop& operator=(const Loop&) = delete;
    virtual ~Loop() = default;

    virtual void begin() {}
    /// Runs one step.
    /// @param dt  time since the last tick: measured if waitForBeat() returned true, otherwise a whole number of
    ///            periods, more than one if beats were missed
    virtual void tick(std::chrono::microseconds dt) = 0;
    /// Waits between two ticks until the next one is due. A loop whose input sets the pace waits for that.
    /// @returns whether the input arrived; that may be somewhat later than `due`
    virtual bool waitForBeat(std::chrono::steady_clock::time_point due)
    {
        std::this_thread::sleep_until(due);
        return false;
    }
    virtual void end() {}
};

}  // namespace core::rt
