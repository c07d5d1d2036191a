// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/terrain/Grid.h"

namespace ui::render {

/// What Flanks finds at one node; the slopes point inwards.
struct FlankNode
{
    glm::vec2 upper{0.0F};    ///< slope of the square of the height over the contour, mm
    glm::vec2 lower{0.0F};    ///< of the square of the depth below it, mm
    float contourMm = 0.0F;   ///< height of contour
    glm::vec2 contour{0.0F};  ///< its slope
    float share = 0.0F;       ///< fades out with the distance from the rim
    float upperShare = 0.0F;  ///< and beyond a ridge
    bool isRim = false;
};

/// Where the flanks of an uncut tooth look. Towards the height of contour a flank falls ever steeper, by millimetres
/// within a cell, and slopes between nodes say more of the lattice than of the tooth. But there a flank is round: the
/// square of its height over the contour grows evenly with the distance from the outline, and of that the lattice has
/// the slope right. From it follows a normal at each height of the flank.
///
/// Computed once, for nodes near the rim. Ui thread.
class Flanks
{
public:
    enum class Side : std::uint8_t { Upper, Lower };

    /// @param tops, bottoms  of the uncut tooth, mm, [side * side]; empty where top <= bottom
    /// @param drawnTops, drawnBottoms  the same as drawn: the slopes are computed for these heights
    Flanks(const core::terrain::Grid& lattice, const std::vector<float>& tops, const std::vector<float>& bottoms,
           const std::vector<float>& drawnTops, const std::vector<float>& drawnBottoms);

    /// @param heightMm  height on the flank; on the rim the normal always points straight outwards
    /// @param normal    unit vector; undefined if the share is 0
    /// @return weight of the normal: 1 on a flank, 0 where there is none or the lattice is better
    [[nodiscard]] float normalAt(std::size_t node, Side side, float heightMm, glm::vec3& normal) const;

    /// Returns whether normalAt() has a weight above 0 at some height.
    [[nodiscard]] bool isNear(std::size_t node) const { return m_nodes[node].share > 0.0F; }

private:
    std::vector<FlankNode> m_nodes;
};

}  // namespace ui::render
