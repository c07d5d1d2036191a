// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/preparation/AxisRegion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <glm/geometric.hpp>

namespace core::preparation {
namespace {

double distanceToPolygon(const std::vector<glm::dvec2>& corners, glm::dvec2 point)
{
    double nearest = std::numeric_limits<double>::max();
    bool inside = corners.size() > 2;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const glm::dvec2 from = corners[k];
        const glm::dvec2 along = corners[(k + 1) % corners.size()] - from;
        const glm::dvec2 to = point - from;
        const double length = glm::dot(along, along);
        const double share = length > 0.0 ? std::clamp(glm::dot(to, along) / length, 0.0, 1.0) : 0.0;
        const glm::dvec2 off = to - along * share;
        nearest = std::min(nearest, glm::dot(off, off));
        inside = inside && along.x * to.y - along.y * to.x >= 0.0;
    }
    return inside ? 0.0 : std::sqrt(nearest);
}

}  // namespace

void AxisRegion::addPolygon(std::vector<glm::dvec2> corners)
{
    m_polygons.push_back(std::move(corners));
}

void AxisRegion::addBox(glm::dvec2 low, glm::dvec2 high)
{
    addPolygon({low, {high.x, low.y}, high, {low.x, high.y}});
}

void AxisRegion::addRing(glm::dvec2 middle, double radius, double halfWidth)
{
    m_rings.push_back({middle, radius, halfWidth});
}

double AxisRegion::distance(glm::dvec2 point) const
{
    double nearest = std::numeric_limits<double>::max();
    for (const std::vector<glm::dvec2>& polygon : m_polygons)
        nearest = std::min(nearest, distanceToPolygon(polygon, point));
    for (const Ring& ring : m_rings) {
        const glm::dvec2 out = point - ring.middle;
        const double off = std::abs(std::sqrt(glm::dot(out, out)) - ring.radius);
        nearest = std::min(nearest, std::max(0.0, off - ring.halfWidth));
    }
    return nearest;
}

double riseBeside(double distance, double radiusMm, double cornerMm)
{
    const double out = distance - (radiusMm - cornerMm);
    if (!(out > 0.0))
        return 0.0;
    return cornerMm - std::sqrt(std::max(0.0, cornerMm * cornerMm - out * out));
}

}  // namespace core::preparation
