// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace core::servo {

/// Tells where a stroke ends, and so an undo step: with a pause in cutting. Tick by tick; no allocation.
class StrokeDetector
{
public:
    static constexpr int kPauseTicks = 150;

    /// To be asked after every tick. True when the pause after a stroke has just lasted long enough.
    /// @param cut  material came away in this tick
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
    /// Another tooth, or another moment of it.
    void restart() noexcept { m_inStroke = false; }

    [[nodiscard]] bool isInStroke() const noexcept { return m_inStroke; }
    /// In a stroke: ticks since material last came away.
    [[nodiscard]] int ticksSinceCut() const noexcept { return m_ticksSinceCut; }

private:
    bool m_inStroke = false;
    int m_ticksSinceCut = 0;
};

}  // namespace core::servo
