// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace core::servo {

/// Detects the end of a stroke, which is also the end of an undo step: nothing has been cut for kPauseTicks ticks.
/// Allocates nothing.
class StrokeDetector
{
public:
    static constexpr int kPauseTicks = 150;

    /// Returns whether a stroke ends in this tick. Call after every tick.
    /// @param cut  material was removed in this tick
    bool endsWith(bool cut) noexcept
    {
        if (cut) {
            m_inStroke = true;
            m_ticksSinceCut = 0;
        } else if (m_inStroke && ++m_ticksSinceCut >= kPauseTicks) {
            m_inStroke = false;
            return true;
        }
        return false;
    }
    /// Forgets a stroke that has not ended, for another tooth or another moment of it.
    void restart() noexcept { m_inStroke = false; }

    [[nodiscard]] bool isInStroke() const noexcept { return m_inStroke; }

private:
    bool m_inStroke = false;
    int m_ticksSinceCut = 0;
};

}  // namespace core::servo
