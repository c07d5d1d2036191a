// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/replay/ReplayLoop.h"

#include <algorithm>

namespace app {
namespace {

/// A few milliseconds of work.
constexpr std::uint64_t kTicksABeat = 1000;

}  // namespace

void ReplayLoop::tick(std::chrono::microseconds dt)
{
    const double lengthS = m_attempt->lengthS();
    const double wishedS = m_wishedS.exchange(-1.0, std::memory_order_relaxed);
    if (wishedS >= 0.0)
        m_atS = wishedS;
    else if (!m_paused.load(std::memory_order_relaxed) && m_atS <= m_attempt->readyS())
        m_atS += std::chrono::duration<double>(dt).count() * m_speed.load(std::memory_order_relaxed);
    m_atS = std::min(m_atS, lengthS);
    m_attempt->show(m_atS);
    if (m_beside)
        m_beside->show(lengthS > 0.0 ? m_atS / lengthS * m_beside->lengthS() : 0.0);
    if (m_guide != nullptr)
        lead();
    m_isAtEnd.store(m_atS >= lengthS, std::memory_order_relaxed);
    if (m_atS >= lengthS && !m_paused.exchange(true, std::memory_order_relaxed))
        m_ended.store(true, std::memory_order_release);
}

void ReplayLoop::lead()
{
    m_guide->aim.publish({++m_aims, (m_beside ? *m_beside : *m_attempt).tipMm()});
    const haptics::GuideState& state = m_guide->state.latest();
    if (state.ticks == 0)
        return;
    m_attempt->setHand(state.present ? std::optional(state.tipMm) : std::nullopt);
    m_hand.store(!state.present    ? Hand::Lost
                 : state.leading   ? Hand::Led
                 : state.wasPushed ? Hand::Pushed
                                   : Hand::Free,
                 std::memory_order_relaxed);
}

void ReplayLoop::setPaused(bool paused)
{
    if (!paused && m_isAtEnd.load(std::memory_order_relaxed))
        seek(0.0);
    m_paused.store(paused, std::memory_order_relaxed);
}

void ReplayLoop::prepare()
{
    static_cast<void>(m_attempt->prepare(kTicksABeat));
    if (m_beside)
        static_cast<void>(m_beside->prepare(kTicksABeat));
}

void ReplayLoop::goToEnd()
{
    while (m_attempt->prepare(kTicksABeat)) {
    }
    seek(m_attempt->lengthS());
    tick({});
}

}  // namespace app
