// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>

#include <glm/vec3.hpp>

#include "core/rt/Signal.h"
#include "core/rt/TripleBuffer.h"

namespace haptics::falcon {

/// The force that the servo gives to the device thread, and the reading that it answers.
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

    /// Servo thread. Never waits.
    void give(const Value& value) noexcept
    {
        m_value.publish(value);
        m_hasNew.raise();
    }

    /// Device thread. Waits for a force that answers a reading that was requested at `request` or later. False if the
    /// time has come first.
    ///
    /// A signal may still be there from an older force. It does not count: the force sent would always be one exchange
    /// late.
    [[nodiscard]] bool waitFor(Clock::time_point request, Clock::time_point until)
    {
        while (latest().answers < request)
            if (!m_hasNew.waitUntil(until))
                return false;
        return true;
    }

    /// Device thread. Valid until its next call.
    [[nodiscard]] const Value& latest() noexcept { return m_value.latest(); }

private:
    core::rt::TripleBuffer<Value> m_value;
    core::rt::Signal m_hasNew;
};

}  // namespace haptics::falcon
