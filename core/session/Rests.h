// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/Links.h"

namespace core::session {

/// Which part of a recording is no work at the attempt: its student was elsewhere, as notes on it say.
class Rests
{
public:
    /// Every event, in order.
    void hear(const ServoEvent& event)
    {
        if (event.kind == ServoEvent::Kind::Note && (event.value == kRestNote || event.value == kWorkNote))
            m_rests = event.value == kRestNote;
        if (event.kind == ServoEvent::Kind::Resume)  // whoever takes it up again is there
            m_rests = false;
    }
    /// Whatever a note says, what is cut is cut in the attempt.
    [[nodiscard]] bool leaveOut(const ServoState& state) const { return m_rests && !state.cutting; }

private:
    bool m_rests = false;
};

}  // namespace core::session
