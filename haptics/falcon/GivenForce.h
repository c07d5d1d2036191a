// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>

#include <glm/vec3.hpp>

#include "core/rt/Signal.h"
#include "core/rt/TripleBuffer.h"

namespace haptics::falcon {

/// Passes the servo's force to the device thread, with the reading that it answers.
class GivenForce
{
public:
    using Clock = std::chrono::steady_clock;

    struct Value
    {
        glm::dvec3 forceN{0.0};       ///< on the hand, tooth frame
        Clock::time_point given{};    ///< before the first force: the clock's epoch
        Clock::time_point answers{};  ///< when the reading was requested
    };

    /// Servo thread: sets the force. Never waits.
    void give(const Value& value) noexcept
    {
        m_value.publish(value);
        m_hasNew.raise();
    }

    /// Device thread: waits for a force that answers a reading requested at `request` or later. Returns false if
    /// `until` is reached first.
    ///
    /// Ignores signals of older forces: otherwise the force sent would always be one exchange late.
    [[nodiscard]] bool waitFor(Clock::time_point request, Clock::time_point until)
    {
        while (latest().answers < request)
            if (!m_hasNew.waitUntil(until))
                return false;
        return true;
    }

    /// Device thread: returns the newest force. Valid until the next call.
    [[nodiscard]] const Value& latest() noexcept { return m_value.latest(); }

private:
    core::rt::TripleBuffer<Value> m_value;
    core::rt::Signal m_hasNew;
};

}  // namespace haptics::falcon
