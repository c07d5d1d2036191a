// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <glm/vec2.hpp>

#include "core/terrain/Grid.h"
#include "core/terrain/NodeRect.h"

namespace ui::render {

/// Removes the steps of the lattice, for drawing, from walls that are not parallel to its rows or columns. On steep
/// ground the heights are slightly blurred, so that the steps become one slope. The nodes on that slope are then moved
/// towards its middle, so that it is a wall again. Other ground is unchanged.
///
/// Reuses its buffers between calls. Ui thread.
class SteepGround
{
public:
    /// Distance in nodes over which a changed node affects the drawn surface.
    static constexpr int kReach = 5;

    explicit SteepGround(const core::terrain::Grid& lattice);

    /// @param tops    heights, kEmptyTop where there is no material, [side * side]
    /// @param rect    nodes to update: the changed ones, extended by kReach
    /// @param drawn   heights for drawing, mm
    /// @param shifts  displacement of each drawn node from its place in the lattice, mm; less than half a cell per axis
    void draw(const std::vector<float>& tops, const core::terrain::NodeRect& rect, std::vector<float>& drawn,
              std::vector<glm::vec2>& shifts);

private:
    void blur(const std::vector<float>& tops, const core::terrain::NodeRect& rect);

    core::terrain::Grid m_lattice;
    // One value per node of the lattice.
    std::vector<float> m_passed;   ///< heights blurred along rows, times the weights of the solid nodes
    std::vector<float> m_weights;  ///< sums of those weights
    std::vector<float> m_blurred;  ///< heights blurred along rows and columns
    std::vector<float> m_whole;    ///< 1 where the whole blur kernel is solid, 0 beside empty nodes
    std::vector<float> m_low;      ///< lowest height within kBlurReach along rows
    std::vector<float> m_high;
};

}  // namespace ui::render
