// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/servo/ServoChannels.h"

namespace core::recording {

/// Detects the idle intervals of a recording, which do not count as working time, by its notes.
class IdleIntervals
{
public:
    /// Processes an event. Call for every event, in order.
    void hear(const servo::ServoEvent& event)
    {
        if (event.kind == servo::ServoEvent::Kind::Note &&
            (event.value == servo::kRestNote || event.value == servo::kWorkNote))
            m_rests = event.value == servo::kRestNote;
        if (event.kind == servo::ServoEvent::Kind::Resume)  // whoever takes it up again is there
            m_rests = false;
    }
    /// Returns whether the current step does not count. A step that cuts always counts.
    [[nodiscard]] bool leaveOut(const servo::ServoState& state) const { return m_rests && !state.cutting; }

private:
    bool m_rests = false;
};

}  // namespace core::recording
