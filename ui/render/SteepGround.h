// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <glm/vec2.hpp>

#include "core/terrain/Grid.h"
#include "core/terrain/NodeRect.h"

namespace ui::render {

/// Removes the steps of the lattice from walls that do not follow its lines, for drawing. On steep ground, the heights
/// are slightly blurred, so that the steps become one slope, and the nodes on that slope are moved towards its middle,
/// so that it is a wall again. Other ground is unchanged.
///
/// Keeps its buffers between calls. Ui thread.
class SteepGround
{
public:
    /// Distance over which a changed node affects the drawn surface, nodes.
    static constexpr int kReach = 5;

    explicit SteepGround(const core::terrain::Grid& lattice);

    /// @param tops    heights, kEmptyTop where there is no material, [side * side]
    /// @param rect    nodes to update: what has changed, grown by kReach
    /// @param drawn   heights for drawing, mm
    /// @param shifts  displacement of each drawn node from its place in the lattice, mm; less than half a cell per axis
    void draw(const std::vector<float>& tops, const core::terrain::NodeRect& rect, std::vector<float>& drawn,
              std::vector<glm::vec2>& shifts);

private:
    void blur(const std::vector<float>& tops, const core::terrain::NodeRect& rect);

    core::terrain::Grid m_lattice;
    // Over the lattice.
    std::vector<float> m_passed;   ///< heights blurred along rows, times the weights of the solid nodes
    std::vector<float> m_weights;  ///< their sum
    std::vector<float> m_blurred;  ///< also along columns
    std::vector<float> m_whole;    ///< 1 where the whole blur kernel is solid, 0 beside empty nodes
    std::vector<float> m_low;      ///< lowest within the reach of a wall, along rows
    std::vector<float> m_high;
};

}  // namespace ui::render
