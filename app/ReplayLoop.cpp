// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/ReplayLoop.h"

#include <algorithm>

namespace app {

using namespace core::session;
using core::history::TiledHeights;

core::Result<std::unique_ptr<ReplayLoop>> ReplayLoop::make(const core::recording::Recording& recording, UiLinks& links,
                                                           std::uint64_t generation)
{
    auto servo = makeServoTick(recording.settings());
    if (!servo)
        return tl::unexpected(servo.error());
    return std::unique_ptr<ReplayLoop>(new ReplayLoop(recording, links, generation, std::move(*servo)));
}

ReplayLoop::ReplayLoop(const core::recording::Recording& recording, UiLinks& links, std::uint64_t generation,
                       std::unique_ptr<ServoTick> servo)
    : m_anatomy(recording.anatomy()), m_links(links), m_generation(generation), m_servo(std::move(servo)),
      m_tooth(std::make_unique<core::contact::LiveTooth>(core::terrain::Tooth(m_anatomy))),
      m_shown(m_anatomy->grid, m_anatomy->top), m_newest(m_shown), m_removed(m_anatomy)
{
    recording.forEach([this](const ServoEvent& event) {
        m_events.push_back(event);
        if (event.kind == ServoEvent::Kind::Restore)
            m_restored.insert(event.value);
    });
    m_moments.emplace_back(0, m_shown);
    m_servo->swapTooth(m_tooth.get(), true);
    m_session.toothGeneration = generation;
    m_session.wholeMm3 = core::terrain::volumes(m_tooth->tooth());
}

void ReplayLoop::tick(std::chrono::microseconds dt)
{
    if (!m_paused.load(std::memory_order_relaxed))
        m_due += dt * m_speed.load(std::memory_order_relaxed);
    while (m_next < m_events.size() && m_played < m_due)
        play(m_events[m_next++]);
    sendPatches();
    publish();
    if (m_next == m_events.size() && m_toSend.empty())
        m_finished.store(true, std::memory_order_release);
}

void ReplayLoop::play(const ServoEvent& event)
{
    switch (event.kind) {
    case ServoEvent::Kind::Tick:
    case ServoEvent::Kind::NoDevice:
        m_played += std::chrono::microseconds(event.dtUs);
        m_servo->step(event.kind == ServoEvent::Kind::Tick ? &event.deviceMm : nullptr,
                      std::chrono::microseconds(event.dtUs));
        if (m_restored.contains(++m_tick)) {
            m_newest.update(m_tooth->tooth().top);
            m_moments.emplace_back(m_tick, m_newest);
        }
        break;
    case ServoEvent::Kind::Drill:
        m_servo->setDrill(event.value != 0);
        break;
    case ServoEvent::Kind::Bur:
        m_servo->setBur(static_cast<std::size_t>(event.value));
        break;
    case ServoEvent::Kind::Home:
        m_servo->bringHome();
        break;
    case ServoEvent::Kind::Spring:
        m_servo->setSpring(event.value);
        break;
    case ServoEvent::Kind::Restore: {
        const auto moment = std::find_if(m_moments.rbegin(), m_moments.rend(),
                                         [&](const auto& known) { return known.first == event.value; });
        // A recording was checked when it was read: whatever it goes back to lies behind it.
        auto restored =
            std::make_unique<core::contact::LiveTooth>(core::terrain::restored(m_anatomy, moment->second.flat()));
        m_servo->swapTooth(restored.get(), false);
        m_tooth = std::move(restored);
        break;
    }
    case ServoEvent::Kind::Begin:
        break;
    }
}

void ReplayLoop::sendPatches()
{
    if (m_toSend.empty()) {
        m_newest.update(m_tooth->tooth().top);
        const std::vector<TilePatch> group = patchesBetween(m_shown, m_newest, m_tick, m_generation);
        m_toSend.assign(group.begin(), group.end());
        m_shown = m_newest;
    }
    while (!m_toSend.empty() && m_links.patches.tryPush(m_toSend.front()))
        m_toSend.pop_front();
}

void ReplayLoop::publish()
{
    ServoState& state = m_links.servo.back();
    state = m_servo->state();
    state.toothGeneration = m_generation;
    m_links.servo.publish();
    const core::history::Removed& removed = m_removed.of(m_newest);
    m_session.removedMm3 = removed.volumesMm3;
    m_session.overcutMm3 = removed.overcutMm3;
    m_session.perforated = removed.perforated;
    m_session.recordedS = std::chrono::duration<double>(m_played).count();
    m_links.session.publish(m_session);
}

}  // namespace app
