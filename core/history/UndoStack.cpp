// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/history/UndoStack.h"

namespace core::history {

/// Bytes of the tiles that a moment does not share with the one before it.
std::size_t UndoStack::costOf(std::size_t index) const
{
    return sizeof(Tile) * m_moments[index].top.tilesNotIn(index == 0 ? TiledHeights{} : m_moments[index - 1].top);
}

void UndoStack::restart(ToothMoment first)
{
    m_moments.clear();
    m_moments.push_back(std::move(first));
    m_at = 0;
    m_bytes = costOf(0);
}

void UndoStack::push(ToothMoment moment)
{
    while (m_moments.size() > m_at + 1) {
        m_bytes -= costOf(m_moments.size() - 1);
        m_moments.pop_back();
    }
    m_moments.push_back(std::move(moment));
    ++m_at;
    m_bytes += costOf(m_at);
    while (m_bytes > m_limitBytes && m_at > 1) {
        // The oldest goes; what it alone held is counted from now on to the one that follows it.
        m_bytes -= costOf(0) + costOf(1);
        m_moments.pop_front();
        --m_at;
        m_bytes += costOf(0);
    }
}

bool UndoStack::undo()
{
    if (m_at == 0)
        return false;
    --m_at;
    return true;
}

bool UndoStack::redo()
{
    if (redoSteps() == 0)
        return false;
    ++m_at;
    return true;
}

}  // namespace core::history
