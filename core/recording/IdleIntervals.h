// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/servo/ServoChannels.h"

namespace core::recording {

/// Which part of a recording is no work at the attempt: its student was elsewhere, as notes on it say.
class IdleIntervals
{
public:
    /// Every event, in order.
    void hear(const servo::ServoEvent& event)
    {
        if (event.kind == servo::ServoEvent::Kind::Note &&
            (event.value == servo::kRestNote || event.value == servo::kWorkNote))
            m_rests = event.value == servo::kRestNote;
        if (event.kind == servo::ServoEvent::Kind::Resume)  // whoever takes it up again is there
            m_rests = false;
    }
    /// Whatever a note says, what is cut is cut in the attempt.
    [[nodiscard]] bool leaveOut(const servo::ServoState& state) const { return m_rests && !state.cutting; }

private:
    bool m_rests = false;
};

}  // namespace core::recording
