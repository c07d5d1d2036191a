// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <glm/vec2.hpp>

namespace core::preparation {

/// Where the axis of an upright bur may go while it cuts a pocket, seen from above, mm. What it cuts is all within its
/// radius of there: so a shape made of such a region has no corner that the bur cannot reach.
class AxisRegion
{
public:
    /// @param corners  of a convex polygon, counter-clockwise; two are a line
    void addPolygon(std::vector<glm::dvec2> corners);
    void addBox(glm::dvec2 low, glm::dvec2 high);
    /// All that is within `halfWidth` of a circle.
    void addRing(glm::dvec2 middle, double radius, double halfWidth);

    /// From a point to the region, 0 inside, mm. Exact.
    [[nodiscard]] double distance(glm::dvec2 point) const;

private:
    struct Ring
    {
        glm::dvec2 middle;
        double radius;
        double halfWidth;
    };
    std::vector<std::vector<glm::dvec2>> m_polygons;
    std::vector<Ring> m_rings;
};

/// Height above the floor of what a bur of this radius leaves `distance` away from where its axis went: its end is a
/// flat disc with a rounded rim (bur::Bur::undersideMm). distance <= radiusMm.
[[nodiscard]] double riseBeside(double distance, double radiusMm, double cornerMm);

}  // namespace core::preparation
