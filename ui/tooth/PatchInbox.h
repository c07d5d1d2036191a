// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "core/servo/ServoState.h"

namespace ui::tooth {

/// Collects patches of cut tiles until a group is complete. Drops patches of an older tooth. Stores patches of a tooth
/// that the view has not received yet, the newest of each tile, so that none is lost between two threads.
class PatchInbox
{
public:
    /// Sets the tooth that is shown. Stored patches of it are then in complete().
    void setGeneration(std::uint64_t generation);
    void take(const core::servo::TilePatch& patch);

    /// Returns the patches of complete groups, in order. The caller clears them.
    [[nodiscard]] std::vector<core::servo::TilePatch>& complete() { return m_complete; }

private:
    void keepEarly(const core::servo::TilePatch& patch);

    std::uint64_t m_generation = 0;
    std::vector<core::servo::TilePatch> m_group;     ///< patches of the shown tooth; the group is not complete yet
    std::vector<core::servo::TilePatch> m_complete;  ///< patches of the shown tooth, in complete groups
    std::uint64_t m_earlyGeneration = 0;
    std::vector<core::servo::TilePatch> m_earlyGroup;
    std::vector<core::servo::TilePatch> m_early;  ///< complete groups of a tooth to come, one patch per tile
};

/// Writes the heights of a tile into a tooth. The bottom of a removed column becomes empty as well.
void write(const core::servo::TilePatch& patch, core::terrain::Tooth& tooth);

}  // namespace ui::tooth
