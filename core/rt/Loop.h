// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>

namespace core::rt {

/// Work done in beats. A thread is a shell around it (app/LoopThread); tests and headless commands call tick()
/// themselves.
class Loop
{
public:
    Loop() = default;
    Loop(const Loop&) = delete;
    Loop& operator=(const Loop&) = delete;
    virtual ~Loop() = default;

    virtual void begin() {}
    /// @param dt  since the last tick, a whole number of periods: more than one when beats were missed
    virtual void tick(std::chrono::microseconds dt) = 0;
    virtual void end() {}
};

}  // namespace core::rt
