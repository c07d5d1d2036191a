// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/ReplayLoop.h"

namespace app {

using namespace core::session;
using core::history::TiledHeights;

core::Result<std::unique_ptr<ReplayLoop>> ReplayLoop::make(const core::recording::Recording& recording, UiLinks& links,
                                                           std::uint64_t generation)
{
    auto servo = core::recording::Replayer::make(recording);
    if (!servo)
        return tl::unexpected(servo.error());
    return std::unique_ptr<ReplayLoop>(new ReplayLoop(recording, links, generation, std::move(*servo)));
}

ReplayLoop::ReplayLoop(const core::recording::Recording& recording, UiLinks& links, std::uint64_t generation,
                       core::recording::Replayer servo)
    : m_links(links), m_generation(generation), m_servo(std::move(servo)), m_shown(m_servo.heights()),
      m_removed(recording.anatomy())
{
    recording.forEach([this](const ServoEvent& event) { m_events.push_back(event); });
    m_session.toothGeneration = generation;
    m_session.wholeMm3 = core::terrain::volumes(m_servo.tooth().tooth());
}

void ReplayLoop::tick(std::chrono::microseconds dt)
{
    if (!m_paused.load(std::memory_order_relaxed))
        m_due += dt * m_speed.load(std::memory_order_relaxed);
    while (m_next < m_events.size() && m_played < m_due)
        if (const ServoEvent& event = m_events[m_next++]; m_servo.play(event))
            m_played += std::chrono::microseconds(event.dtUs);
    sendPatches();
    publish();
    if (m_next == m_events.size() && m_toSend.empty())
        m_finished.store(true, std::memory_order_release);
}

void ReplayLoop::sendPatches()
{
    if (m_toSend.empty()) {
        const TiledHeights& newest = m_servo.heights();
        const std::vector<TilePatch> group = patchesBetween(m_shown, newest, m_servo.tick(), m_generation);
        m_toSend.assign(group.begin(), group.end());
        m_shown = newest;
    }
    while (!m_toSend.empty() && m_links.patches.tryPush(m_toSend.front()))
        m_toSend.pop_front();
}

void ReplayLoop::publish()
{
    ServoState& state = m_links.servo.back();
    state = m_servo.state();
    state.toothGeneration = m_generation;
    m_links.servo.publish();
    const core::history::Removed& removed = m_removed.of(m_servo.heights());
    m_session.removedMm3 = removed.volumesMm3;
    m_session.overcutMm3 = removed.overcutMm3;
    m_session.perforated = removed.perforated;
    m_session.recordedS = std::chrono::duration<double>(m_played).count();
    m_links.session.publish(m_session);
}

}  // namespace app
