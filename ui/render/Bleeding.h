// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "core/terrain/NodeRect.h"

namespace ui::render {

/// Finds where an opened pulp bleeds. A column that was cut down to the pulp is smaller than anything that can be seen,
/// so a point of blood covers the surface around it.
///
/// All maps have one value per node of the lattice, row by row, i fastest; heights are in mm. Ui thread.
class Bleeding
{
public:
    /// Distance in any direction from an opened column up to which there is blood. It makes the smallest point half a
    /// millimetre wide.
    static constexpr float kReachMm = 0.25F;

    /// @param uncutTops  heights of the uncut surface
    /// @param pulpRoofs  heights of the roof of the pulp; kEmptyTop where there is none
    Bleeding(const core::terrain::Grid& lattice, std::vector<float> uncutTops, std::vector<float> pulpRoofs);

    /// Finds the blood around nodes whose height has changed. Returns the nodes on which the blood has changed.
    [[nodiscard]] core::terrain::NodeRect update(const std::vector<float>& tops, const core::terrain::NodeRect& rect);

    /// Returns the amount of blood on each node: 0 is none, 255 covers the surface.
    [[nodiscard]] const std::vector<std::uint8_t>& nodes() const { return m_nodes; }

private:
    [[nodiscard]] bool isOpen(const std::vector<float>& tops, std::size_t k) const
    {
        return tops[k] <= m_pulpRoofs[k] && tops[k] < m_uncutTops[k];
    }

    core::terrain::Grid m_lattice;
    std::vector<float> m_uncutTops;
    std::vector<float> m_pulpRoofs;
    std::vector<std::uint8_t> m_nodes;
    bool m_hasBlood = false;
};

}  // namespace ui::render
