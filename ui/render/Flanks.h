// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/terrain/Grid.h"

namespace ui::render {

/// The result for one node. Slopes point inwards.
struct FlankNode
{
    glm::vec2 upper{0.0F};    ///< slope of the square of the height above the contour, mm
    glm::vec2 lower{0.0F};    ///< slope of the square of the depth below the contour, mm
    float contourMm = 0.0F;   ///< height of contour at the node
    glm::vec2 contour{0.0F};  ///< slope of the height of contour
    float share = 0.0F;       ///< weight; decreases with the distance from the rim
    float upperShare = 0.0F;  ///< weight on the upper side; also decreases beyond a ridge
    bool isRim = false;
};

/// Normals on the flanks of an uncut tooth. Towards the height of contour a flank becomes steeper and falls by
/// millimetres within a cell, so slopes between nodes depend more on the lattice than on the tooth. But a flank is
/// round there: the square of its height above the contour grows linearly with the distance from the outline, and the
/// lattice gives that slope correctly. The normal at each height of the flank follows from it.
///
/// Computed once, for nodes near the rim. Ui thread.
class Flanks
{
public:
    enum class Side : std::uint8_t { Upper, Lower };

    /// @param tops, bottoms  of the uncut tooth, mm, [side * side]; empty where top <= bottom
    /// @param drawnTops, drawnBottoms  the heights that are drawn, for which the slopes are computed
    Flanks(const core::terrain::Grid& lattice, const std::vector<float>& tops, const std::vector<float>& bottoms,
           const std::vector<float>& drawnTops, const std::vector<float>& drawnBottoms);

    /// @param heightMm  height on the flank; on the rim the normal always points straight outwards
    /// @param normal    unit vector; undefined if the returned weight is 0
    /// @return weight of the normal: 1 on a flank; 0 if there is no flank or the lattice is more accurate
    [[nodiscard]] float normalAt(std::size_t node, Side side, float heightMm, glm::vec3& normal) const;

    /// Returns whether normalAt() returns a weight above 0 for some height.
    [[nodiscard]] bool isNear(std::size_t node) const { return m_nodes[node].share > 0.0F; }

private:
    std::vector<FlankNode> m_nodes;
};

}  // namespace ui::render
