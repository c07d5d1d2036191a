// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/render/Bleeding.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/common.hpp>

namespace ui::render {
namespace {

using core::terrain::NodeRect;

/// Distance from an opened column up to which blood covers the surface fully, mm.
constexpr float kCoveredMm = 0.15F;

}  // namespace

Bleeding::Bleeding(const core::terrain::Grid& lattice, std::vector<float> uncutTops, std::vector<float> pulpRoofs)
    : m_lattice(lattice), m_uncutTops(std::move(uncutTops)), m_pulpRoofs(std::move(pulpRoofs)),
      m_nodes(m_lattice.count(), 0)
{}

NodeRect Bleeding::update(const std::vector<float>& tops, const NodeRect& rect)
{
    bool isOpenHere = false;
    for (int j = rect.beginJ; j < rect.endJ && !isOpenHere; ++j)
        for (int i = rect.beginI; i < rect.endI && !isOpenHere; ++i)
            isOpenHere = isOpen(tops, m_lattice.index(i, j));
    if (!isOpenHere && !m_hasBlood)
        return {};
    m_hasBlood = true;

    const auto cell = static_cast<float>(m_lattice.cellMm);
    const int reach = static_cast<int>(kReachMm / cell);
    const NodeRect around = grown(rect, reach, m_lattice);
    for (int j = around.beginJ; j < around.endJ; ++j) {
        for (int i = around.beginI; i < around.endI; ++i) {
            const float here = tops[m_lattice.index(i, j)];
            float nearestMm = kReachMm;
            for (int dj = -reach; dj <= reach; ++dj) {
                for (int di = -reach; di <= reach; ++di) {
                    if (!m_lattice.contains(i + di, j + dj))
                        continue;
                    const std::size_t n = m_lattice.index(i + di, j + dj);
                    if (isOpen(tops, n))
                        nearestMm = std::min(nearestMm, std::hypot(cell * static_cast<float>(di),
                                                                   cell * static_cast<float>(dj), tops[n] - here));
                }
            }
            m_nodes[m_lattice.index(i, j)] =
                static_cast<std::uint8_t>(255.0F * (1.0F - glm::smoothstep(kCoveredMm, kReachMm, nearestMm)));
        }
    }
    return around;
}

}  // namespace ui::render
