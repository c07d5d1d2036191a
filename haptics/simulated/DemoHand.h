// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/session/Links.h"
#include "core/terrain/Tooth.h"

namespace haptics {

/// A tireless student: takes out decay column by column, always going for the nearest that is left. For the
/// demonstration and for long runs; it steers a PointerDevice as a mouse would.
class DemoHand
{
public:
    /// What the hand wants now, given the bur and the tooth. Call once every few ticks.
    [[nodiscard]] core::session::PointerInput decide(const core::session::ServoState& state,
                                                     const core::terrain::Tooth& tooth);

    /// True when no decay is left, or what is left does not yield.
    [[nodiscard]] bool isDone() const { return m_done; }

private:
    bool m_done = false;
    int m_patience = 0;  ///< decisions spent on the present column
    std::size_t m_aim = 0;
    bool m_hasAim = false;
    std::vector<bool> m_givenUp;
};

}  // namespace haptics
