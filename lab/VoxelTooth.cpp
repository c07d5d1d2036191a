// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/VoxelTooth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace lab {
namespace {

constexpr std::size_t kTableSteps = 2048;

}  // namespace

VoxelBur::VoxelBur(const core::bur::Bur& bur)
    : m_radiusMm(bur.headRadiusMm), m_r2ToStep(kTableSteps / (bur.headRadiusMm * bur.headRadiusMm))
{
    for (std::size_t step = 0; step <= kTableSteps; ++step) {
        const double radius = std::min(m_radiusMm, std::sqrt(static_cast<double>(step) / m_r2ToStep));
        m_underMm.push_back(bur.undersideMm(radius));
        m_upperMm.push_back(bur.upperSideMm(radius));
    }
}

VoxelTooth::VoxelTooth(const core::terrain::ToothAnatomy& anatomy) : m_grid(anatomy.grid)
{
    using namespace core::terrain;
    auto low = std::numeric_limits<double>::max();
    auto high = std::numeric_limits<double>::lowest();
    for (std::size_t k = 0; k < m_grid.count(); ++k) {
        if (!(anatomy.top[k] > anatomy.bottom[k]))
            continue;
        low = std::min(low, static_cast<double>(anatomy.bottom[k]));
        high = std::max(high, static_cast<double>(anatomy.top[k]));
    }
    m_lowMm = low;
    m_layers = std::max(1, static_cast<int>(std::ceil((high - low) / m_grid.cellMm)));
    const auto layers = static_cast<std::size_t>(m_layers);
    m_cubes.assign(m_grid.count() * layers, 0);
    for (std::size_t k = 0; k < m_grid.count(); ++k)
        for (std::size_t layer = 0; layer < layers; ++layer) {
            const auto z = static_cast<float>(m_lowMm + (static_cast<double>(layer) + 0.5) * m_grid.cellMm);
            if (z > anatomy.bottom[k] && z <= anatomy.top[k])
                m_cubes[k * layers + layer] =
                    static_cast<std::uint8_t>(1 + static_cast<int>(materialAt(anatomy.layers[k], z)));
        }
}

double VoxelTooth::volumeMm3() const noexcept
{
    const auto there = m_cubes.size() - static_cast<std::size_t>(std::count(m_cubes.begin(), m_cubes.end(), 0));
    return static_cast<double>(there) * m_grid.cellMm * m_grid.cellMm * m_grid.cellMm;
}

template <class Visit>
void VoxelTooth::forEachRun(const VoxelBur& bur, const glm::dvec3& tip, Visit&& visit) const noexcept
{
    const double cell = m_grid.cellMm;
    const glm::dvec2 at = m_grid.latticeOf({tip.x, tip.y});
    const double reach = bur.radiusMm() / cell;
    const double reach2 = bur.radiusMm() * bur.radiusMm();
    const double tipLayer = (tip.z - m_lowMm) / cell - 0.5;  // the number of a layer is that of its centres
    const int firstRow = std::max(0, static_cast<int>(std::ceil(at.y - reach)));
    const int lastRow = std::min(m_grid.side - 1, static_cast<int>(std::floor(at.y + reach)));
    for (int j = firstRow; j <= lastRow; ++j) {
        const double dy = (j - at.y) * cell;
        const double half = std::sqrt(std::max(0.0, reach2 - dy * dy)) / cell;
        const int first = std::max(0, static_cast<int>(std::ceil(at.x - half)));
        const int last = std::min(m_grid.side - 1, static_cast<int>(std::floor(at.x + half)));
        for (int i = first; i <= last; ++i) {
            const double dx = (i - at.x) * cell;
            const double r2 = std::min(dx * dx + dy * dy, reach2);
            const double low = std::max(0.0, std::ceil(tipLayer + bur.underMm(r2) / cell));
            const double high = std::min(m_layers - 1.0, std::floor(tipLayer + bur.upperMm(r2) / cell));
            if (low > high)
                continue;
            const std::size_t column = m_grid.index(i, j) * static_cast<std::size_t>(m_layers);
            visit(column + static_cast<std::size_t>(low), column + static_cast<std::size_t>(high) + 1);
        }
    }
}

std::size_t VoxelTooth::overlap(const VoxelBur& bur, const glm::dvec3& tip) const noexcept
{
    std::size_t there = 0;
    forEachRun(bur, tip, [&](std::size_t first, std::size_t last) {
        for (std::size_t k = first; k < last; ++k)
            there += m_cubes[k] != 0 ? 1 : 0;
    });
    return there;
}

core::terrain::PerMaterial VoxelTooth::remove(const VoxelBur& bur, const glm::dvec3& tip) noexcept
{
    std::array<std::size_t, core::terrain::kMaterialCount + 1> gone{};
    forEachRun(bur, tip, [&](std::size_t first, std::size_t last) {
        for (std::size_t k = first; k < last; ++k)
            if (m_cubes[k] != 0) {
                ++gone[m_cubes[k]];
                m_cubes[k] = 0;
            }
    });
    core::terrain::PerMaterial mm3{};
    for (std::size_t m = 0; m < mm3.size(); ++m)
        mm3[m] = static_cast<double>(gone[m + 1]) * m_grid.cellMm * m_grid.cellMm * m_grid.cellMm;
    return mm3;
}

}  // namespace lab
