// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "core/servo/ServoState.h"

namespace ui::tooth {

/// Collects cut tiles until a group is whole. Patches of an older tooth are dropped; those of a tooth that the view
/// has not been given yet wait, the newest of each tile only, so that none is lost between two threads.
class PatchInbox
{
public:
    /// The tooth that is now shown; what waited for it is in complete() afterwards.
    void setGeneration(std::uint64_t generation);
    void take(const core::servo::TilePatch& patch);

    /// Patches of whole groups, in order; the reader clears them.
    [[nodiscard]] std::vector<core::servo::TilePatch>& complete() { return m_complete; }

private:
    void keepEarly(const core::servo::TilePatch& patch);

    std::uint64_t m_generation = 0;
    std::vector<core::servo::TilePatch> m_group;     ///< of the tooth shown, not closed yet
    std::vector<core::servo::TilePatch> m_complete;  ///< of the tooth shown
    std::uint64_t m_earlyGeneration = 0;
    std::vector<core::servo::TilePatch> m_earlyGroup;
    std::vector<core::servo::TilePatch> m_early;  ///< whole groups of a tooth to come, one patch a tile
};

/// Writes the heights of a tile into a tooth: the bottom of a column that is gone is empty as well.
void write(const core::servo::TilePatch& patch, core::terrain::Tooth& tooth);

}  // namespace ui::tooth
