// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/teeth/LaidSolid.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

namespace core::teeth {

LaidSolid::LaidSolid(const LaidTooth& laid, Height roof, Height floor) : m_laid(laid), m_roof(roof), m_floor(floor)
{
    const terrain::Grid& grid = laid.own.grid;
    for (std::size_t k = 0; k < grid.count(); ++k) {
        const terrain::ColumnLayers& column = laid.own.layers[k];
        if (!(column.*m_roof > column.*m_floor))
            continue;
        for (const float z : {column.*m_floor, column.*m_roof}) {
            const glm::dvec3 point = laid.cutMm(glm::dvec3(grid.nodeMm(k), z));
            m_lowMm = glm::min(m_lowMm, point - grid.cellMm);
            m_highMm = glm::max(m_highMm, point + grid.cellMm);
        }
    }
}

std::optional<std::pair<float, float>> LaidSolid::along(glm::dvec2 atMm, float top, float bottom) const
{
    constexpr double kThinWallMm = 0.2;  ///< a wall thinner than this between two stretches is removed
    if (!(atMm.x >= m_lowMm.x && atMm.x <= m_highMm.x && atMm.y >= m_lowMm.y && atMm.y <= m_highMm.y))
        return std::nullopt;
    const auto highest = static_cast<double>(top);
    const double step = 0.5 * m_laid.own.grid.cellMm;
    std::optional<double> roof;
    double floor = 0.0;
    for (double z = std::min(highest, m_highMm.z); z >= std::max(static_cast<double>(bottom), m_lowMm.z); z -= step) {
        if (holds(m_laid.ownMm({atMm, z}))) {
            roof = roof.value_or(z);
            floor = z;
        } else if (roof && floor - z > kThinWallMm) {
            break;
        }
    }
    if (!roof || !(*roof > floor))
        return std::nullopt;
    if (*roof > highest - 2.5 * step)
        roof = highest;
    return std::pair(static_cast<float>(*roof), static_cast<float>(floor));
}

/// Roof and floor are linear between the surrounding nodes that have the layer. The outline is half way to the nodes
/// without it.
bool LaidSolid::holds(const glm::dvec3& ownMm) const
{
    const terrain::Grid& grid = m_laid.own.grid;
    const glm::dvec2 at = grid.latticeOf(glm::dvec2(ownMm));
    const glm::dvec2 corner = glm::floor(at);
    double weights = 0.0;
    double roof = 0.0;
    double floor = 0.0;
    for (int n = 0; n < 4; ++n) {
        const int i = static_cast<int>(corner.x) + n % 2;
        const int j = static_cast<int>(corner.y) + n / 2;
        if (!grid.contains(i, j))
            continue;
        const terrain::ColumnLayers& column = m_laid.own.layers[grid.index(i, j)];
        if (!(column.*m_roof > column.*m_floor))
            continue;
        const double weight = (1.0 - std::abs(at.x - i)) * (1.0 - std::abs(at.y - j));
        weights += weight;
        roof += weight * static_cast<double>(column.*m_roof);
        floor += weight * static_cast<double>(column.*m_floor);
    }
    return weights >= 0.5 && ownMm.z * weights <= roof && ownMm.z * weights >= floor;
}

}  // namespace core::teeth
