// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <deque>

#include "core/history/TiledHeights.h"

namespace core::history {

/// One moment of a tooth that can be gone back to.
struct ToothMoment
{
    TiledHeights top;
    std::uint64_t tick = 0;  ///< of the attempt, after which the tooth stood like this; 0 is the uncut tooth
};

/// The moments between strokes, in order, with a place among them. Session thread.
class UndoStack
{
public:
    /// Memory that moments may hold before the oldest are forgotten.
    static constexpr std::size_t kDefaultLimitBytes = std::size_t{64} * 1024 * 1024;

    explicit UndoStack(std::size_t limitBytes = kDefaultLimitBytes) : m_limitBytes(limitBytes) {}

    /// Forgets everything and begins with this moment.
    void restart(ToothMoment first);
    /// A stroke has ended here. What could have been redone is gone.
    void push(ToothMoment moment);

    [[nodiscard]] int undoSteps() const { return static_cast<int>(m_at); }
    [[nodiscard]] int redoSteps() const
    {
        return m_moments.empty() ? 0 : static_cast<int>(m_moments.size() - 1 - m_at);
    }
    /// Where we are. There is always one after restart().
    [[nodiscard]] const ToothMoment& current() const { return m_moments[m_at]; }
    /// One step back or forward; false if there is none.
    bool undo();
    bool redo();
    [[nodiscard]] std::size_t bytes() const { return m_bytes; }

private:
    [[nodiscard]] std::size_t costOf(std::size_t index) const;

    std::size_t m_limitBytes;
    std::deque<ToothMoment> m_moments;
    std::size_t m_at = 0;
    std::size_t m_bytes = 0;
};

}  // namespace core::history
