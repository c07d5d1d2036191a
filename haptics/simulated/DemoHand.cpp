// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/simulated/DemoHand.h"

#include <algorithm>
#include <cmath>

namespace haptics {
namespace {

using core::terrain::ColumnLayers;

constexpr double kPushN = 1.0;
constexpr float kLeftMm = 0.03F;    ///< thinner decay than this is let be
constexpr int kMostPatience = 400;  ///< decisions before a column is given up
constexpr double kHoverMm = 0.8;
constexpr double kOverMm = 0.3;

bool hasDecay(const core::terrain::Tooth& tooth, std::size_t k)
{
    const ColumnLayers& layers = tooth.anatomy->layers[k];
    return tooth.isSolid(k) && layers.cariesRoof > layers.cariesFloor && tooth.top[k] > layers.cariesFloor + kLeftMm;
}

}  // namespace

core::session::PointerInput DemoHand::decide(const core::session::ServoState& state, const core::terrain::Tooth& tooth)
{
    const core::terrain::Grid& grid = tooth.grid();
    m_givenUp.resize(grid.count(), false);
    const glm::dvec2 bur(state.anchorMm.x, state.anchorMm.y);

    if (m_hasAim && (!hasDecay(tooth, m_aim) || ++m_patience > kMostPatience)) {
        m_givenUp[m_aim] = hasDecay(tooth, m_aim);
        m_hasAim = false;
    }
    if (!m_hasAim) {
        double nearest = 1.0e9;
        for (int j = 0; j < grid.side; ++j) {
            for (int i = 0; i < grid.side; ++i) {
                const std::size_t k = grid.index(i, j);
                if (m_givenUp[k] || !hasDecay(tooth, k))
                    continue;
                const glm::dvec2 apart = grid.nodeMm(i, j) - bur;
                const double distance = apart.x * apart.x + apart.y * apart.y;
                if (distance < nearest) {
                    nearest = distance;
                    m_aim = k;
                    m_hasAim = true;
                }
            }
        }
        m_patience = 0;
    }

    core::session::PointerInput want;
    want.pushForceN = kPushN;
    want.hoverMm = kHoverMm;
    want.targetMm = bur;
    m_done = !m_hasAim;
    if (m_hasAim) {
        const auto side = static_cast<std::size_t>(grid.side);
        want.targetMm = grid.nodeMm(static_cast<int>(m_aim % side), static_cast<int>(m_aim / side));
        const glm::dvec2 apart = want.targetMm - bur;
        // Lean only over the place itself: on the way the bur would cut sound tissue.
        want.pushing = std::sqrt(apart.x * apart.x + apart.y * apart.y) < kOverMm;
    }
    return want;
}

}  // namespace haptics
