// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tooth/PatchInbox.h"

#include <algorithm>
#include <utility>

namespace ui::tooth {

void PatchInbox::setGeneration(std::uint64_t generation)
{
    m_generation = generation;
    m_group.clear();
    m_complete.clear();
    if (m_earlyGeneration == generation) {
        m_complete = std::move(m_early);
        m_group = std::move(m_earlyGroup);
    }
    if (m_earlyGeneration <= generation) {
        m_early.clear();
        m_earlyGroup.clear();
    }
}

void PatchInbox::take(const core::servo::TilePatch& patch)
{
    if (patch.toothGeneration > m_generation) {
        keepEarly(patch);
        return;
    }
    if (patch.toothGeneration < m_generation)
        return;
    m_group.push_back(patch);
    if (patch.last) {
        m_complete.insert(m_complete.end(), m_group.begin(), m_group.end());
        m_group.clear();
    }
}

void PatchInbox::keepEarly(const core::servo::TilePatch& patch)
{
    if (patch.toothGeneration < m_earlyGeneration)
        return;
    if (patch.toothGeneration > m_earlyGeneration) {
        m_earlyGeneration = patch.toothGeneration;
        m_early.clear();
        m_earlyGroup.clear();
    }
    m_earlyGroup.push_back(patch);
    if (!patch.last)
        return;
    for (const core::servo::TilePatch& one : m_earlyGroup) {
        const auto same = std::find_if(m_early.begin(), m_early.end(), [&](const core::servo::TilePatch& other) {
            return other.tileX == one.tileX && other.tileY == one.tileY;
        });
        if (same == m_early.end())
            m_early.push_back(one);
        else
            *same = one;
    }
    m_earlyGroup.clear();
}

void write(const core::servo::TilePatch& patch, core::terrain::Tooth& tooth)
{
    using core::servo::kTileSide;
    const core::terrain::Grid& grid = tooth.grid();
    for (int j = 0; j < kTileSide; ++j) {
        for (int i = 0; i < kTileSide; ++i) {
            const int x = patch.tileX * kTileSide + i;
            const int y = patch.tileY * kTileSide + j;
            if (!grid.contains(x, y))
                continue;
            const std::size_t k = grid.index(x, y);
            const float top = patch.top.at(static_cast<std::size_t>(j * kTileSide + i));
            tooth.top[k] = top;
            tooth.bottom[k] = top <= core::terrain::kEmptyTop ? core::terrain::kEmptyBottom : tooth.anatomy->bottom[k];
        }
    }
}

}  // namespace ui::tooth
