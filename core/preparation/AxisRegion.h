// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <glm/vec2.hpp>

namespace core::preparation {

/// The region in which the axis of an upright bur moves while it cuts a pocket, seen from above, mm. The bur cuts all
/// within its radius of the region, so the shape has no corner that the bur cannot reach.
class AxisRegion
{
public:
    /// Adds a convex polygon.
    /// @param corners  counter-clockwise; two are a line
    void addPolygon(std::vector<glm::dvec2> corners);
    void addBox(glm::dvec2 low, glm::dvec2 high);
    /// Adds all points within `halfWidth` of a circle.
    void addRing(glm::dvec2 middle, double radius, double halfWidth);

    /// Returns the distance from a point to the region, mm; 0 inside. Exact.
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

/// Returns the height above the floor that a bur of this radius leaves at a distance from the path of its axis: its end
/// is a flat disc with a rounded rim (bur::Bur::undersideMm). distance <= radiusMm.
[[nodiscard]] double riseBeside(double distance, double radiusMm, double cornerMm);

}  // namespace core::preparation
