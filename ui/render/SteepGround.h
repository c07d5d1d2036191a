// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <glm/vec2.hpp>

#include "core/terrain/Grid.h"
#include "core/terrain/NodeRect.h"

namespace ui::render {

/// How a wall that follows no line of the lattice is drawn without the lattice's steps. Where ground is steep, the
/// heights are a little blurred, so that the steps run together to one slope, and the nodes on that slope are pulled
/// to its middle, so that it is a wall again. Ground that is not steep stays as it is.
///
/// Keeps its scratch between calls. Ui thread.
class SteepGround
{
public:
    /// How far around a changed node what is drawn changes, nodes.
    static constexpr int kReach = 5;

    explicit SteepGround(const core::terrain::Grid& lattice);

    /// @param tops    heights, kEmptyTop where there is nothing, [side * side]
    /// @param rect    nodes to be brought up to date: grow what has changed by kReach
    /// @param drawn   heights to draw, mm
    /// @param shifts  where from its lattice place each node is drawn, mm; less than half a cell along each axis
    void draw(const std::vector<float>& tops, const core::terrain::NodeRect& rect, std::vector<float>& drawn,
              std::vector<glm::vec2>& shifts);

private:
    void blur(const std::vector<float>& tops, const core::terrain::NodeRect& rect);

    core::terrain::Grid m_lattice;
    // Over the lattice.
    std::vector<float> m_passed;   ///< heights blurred along rows, times the weights of what is there
    std::vector<float> m_weights;  ///< their sum
    std::vector<float> m_blurred;  ///< along columns too
    std::vector<float> m_whole;    ///< 1 where all that the blur takes is there, 0 beside nothing
    std::vector<float> m_low;      ///< lowest within the reach of a wall, along rows
    std::vector<float> m_high;
};

}  // namespace ui::render
