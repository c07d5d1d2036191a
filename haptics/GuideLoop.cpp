// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/GuideLoop.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

namespace haptics {
namespace {

/// Time for which a missing or impossible reading counts as a hand at rest, as in the servo (core::servo::ServoTick).
constexpr double kPassedOverS = 0.01;
constexpr float kFarthestMm = 1000.0F;

bool isPlausible(const glm::vec3& tip)
{
    // The comparison is also false for NaN.
    return std::abs(tip.x) <= kFarthestMm && std::abs(tip.y) <= kFarthestMm && std::abs(tip.z) <= kFarthestMm;
}

}  // namespace

/// Returns the position between the last two targets, interpolated over time.
glm::dvec3 GuideLoop::aimNow(double seconds) noexcept
{
    const auto at = [this] { return glm::mix(m_from, m_aim.tipMm, m_share); };
    m_share = std::min(1.0, m_share + seconds / std::chrono::duration<double>(GuideAim::kBeat).count());
    if (const GuideAim& newest = m_links.aim.latest(); newest.number != m_aim.number) {
        m_from = m_aim.number == 0 ? newest.tipMm : at();
        m_aim = newest;
        m_share = 0.0;
    }
    return at();
}

void GuideLoop::tick(std::chrono::microseconds dt) noexcept
{
    // Limits the step, so that the anchor does not jump after a pause of the thread.
    const double seconds = std::min(0.004, static_cast<double>(dt.count()) * 1.0e-6);
    const glm::dvec3 aim = aimNow(seconds);
    const DeviceSample sample = m_device.exchange(m_forceN);
    const bool isRead = sample.present && isPlausible(sample.tipInToothMm);
    m_unreadS = isRead ? 0.0 : m_unreadS + seconds;
    if (isRead)
        m_lastMm = glm::dvec3(sample.tipInToothMm);
    const bool wanted = m_links.wanted.load(std::memory_order_relaxed);
    if (m_unreadS >= kPassedOverS) {
        m_guide.drop();
        m_forceN = glm::dvec3(0.0);
    } else {
        if (wanted && !m_wasWanted && m_aim.number != 0)
            m_guide.takeUp();
        if (!wanted)
            m_guide.letGo();
        m_forceN = m_guide.update(m_lastMm, aim, seconds);
    }
    m_device.give(m_forceN);
    m_wasWanted = wanted && m_aim.number != 0;
    m_links.state.publish({++m_ticks, isRead, m_guide.isLeading(), m_guide.wasPushed(), m_lastMm, m_forceN});
}

void GuideLoop::end()
{
    static_cast<void>(m_device.exchange(glm::dvec3(0.0)));
    m_device.give(glm::dvec3(0.0));
}

}  // namespace haptics
