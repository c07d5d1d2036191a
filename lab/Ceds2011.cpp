// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/Ceds2011.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace lab {
namespace {

glm::dvec3 shortened(const glm::dvec3& v, double longest)
{
    const double length = glm::length(v);
    return length > longest ? v * (longest / length) : v;
}

}  // namespace

Ceds2011::Ceds2011(const CedsFigures& figures, const core::settings::HardnessPreset& hardness)
    : m_figures(figures), m_drill(hardness, {})
{}

core::contact::LiveTooth* Ceds2011::swapTooth(core::contact::LiveTooth* tooth) noexcept
{
    core::contact::LiveTooth* old = m_tooth;
    m_tooth = tooth;
    m_lattice.toothChanged();
    m_drill.rest();
    return old;
}

void Ceds2011::step(const glm::vec3* device, std::chrono::microseconds dt) noexcept
{
    ++m_state.tick;
    m_state.cutting = false;
    if (device == nullptr) {
        m_state.forceN = glm::dvec3(0.0);
        m_state.touching = false;
        return;
    }
    const glm::dvec3 before = m_restart ? glm::dvec3(*device) : m_state.deviceMm;
    m_state.deviceMm = glm::dvec3(*device);
    if (m_restart)
        m_lattice.restart(m_state.deviceMm);
    m_restart = false;
    const double seconds = static_cast<double>(dt.count()) * 1.0e-6;
    m_state.anchorMm = m_lattice.update(*m_tooth, m_state.deviceMm);
    glm::dvec3 stretch = m_state.anchorMm - m_state.deviceMm;
    m_state.touching = glm::dot(stretch, stretch) > 0.0;
    if (m_state.drillOn && m_state.touching) {
        const double pull = std::min(m_figures.stiffnessNPerMm * glm::length(stretch), m_figures.clampN);
        const core::cutting::Cut cut =
            m_drill.cut(*m_tooth, m_state.anchorMm, m_lattice.cutTowards(m_state.deviceMm), pull, seconds);
        m_state.cutting = !cut.changed.isEmpty();
        for (std::size_t m = 0; m < cut.removedMm3.size(); ++m)
            m_state.removedMm3[m] += cut.removedMm3[m];
    } else {
        m_drill.rest();
    }
    glm::dvec3 wanted = m_figures.stiffnessNPerMm * stretch;
    if (m_state.touching && seconds > 0.0)
        wanted -= shortened((0.001 * m_figures.frictionNSPerM / seconds) * (m_state.deviceMm - before),
                            m_figures.frictionMostN);
    wanted = shortened(wanted, m_figures.clampN);
    m_state.forceN += shortened(wanted - m_state.forceN, m_figures.slewNPerS * seconds);
}

}  // namespace lab
