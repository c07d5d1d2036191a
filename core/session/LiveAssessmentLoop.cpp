// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/LiveAssessmentLoop.h"

#include <utility>

namespace core::session {

void LiveAssessmentLoop::watch(std::uint64_t generation, Examination examination)
{
    const std::lock_guard lock(m_mutex);
    m_watchedGeneration = generation;
    m_examination = std::move(examination);
    m_generation = 0;
}

Findings LiveAssessmentLoop::findings() const
{
    const std::lock_guard lock(m_mutex);
    if (m_generation == 0 || !m_examiner)
        return {};
    return found();
}

Findings LiveAssessmentLoop::found() const
{
    return {m_generation,       m_replayer->tick(),     m_examiner->process(), m_examiner->infractions(),
            m_examiner->aids(), m_examiner->practised()};
}

void LiveAssessmentLoop::tick(std::chrono::microseconds)
{
    // Replays one piece at a time, so that a request waits for a few milliseconds at most.
    for (;;) {
        const std::lock_guard lock(m_mutex);
        const RecordedPart part = m_session.recordedSince(m_generation, m_events);
        if (part.generation == 0)
            return;
        if (part.generation != m_generation) {
            const auto recording = m_session.recordingSoFar();
            if (!recording)
                return;
            startOver(*recording, part.generation);
            continue;
        }
        if (part.events.empty())
            return;
        take(part.events);
    }
}

std::optional<AttemptSnapshot> LiveAssessmentLoop::conclude()
{
    const std::lock_guard lock(m_mutex);
    auto recording = m_session.recordingSoFar();
    if (!recording)
        return std::nullopt;
    // Begins again if the tooth has changed since the last run.
    if (const std::uint64_t generation = m_session.recordedGeneration(); generation != m_generation)
        startOver(*recording, generation);
    while (m_generation != 0 && m_events < recording->events()) {
        std::vector<servo::ServoEvent> events = recording->eventsSince(m_events);
        take(events);
    }
    if (!m_replayer || !m_examiner)
        return std::nullopt;
    terrain::Tooth tooth = m_replayer->tooth().tooth();
    return AttemptSnapshot{std::move(*recording), std::move(tooth), found()};
}

/// Begins with a recording. The events that it already contains will be replayed.
void LiveAssessmentLoop::startOver(const recording::Recording& recording, std::uint64_t generation)
{
    m_events = 0;
    m_replayer.reset();
    m_examiner.reset();
    m_generation = 0;
    auto replayer = recording::Replayer::make(recording);
    if (!replayer)
        return;  // the servo runs with these settings, so they are valid
    m_generation = generation;
    m_replayer = std::move(*replayer);
    // The examination of a new tooth is set when the tooth is opened. Until then an empty one is used.
    m_examiner.emplace(generation == m_watchedGeneration ? m_examination : Examination{}, recording.anatomy());
}

void LiveAssessmentLoop::take(const std::vector<servo::ServoEvent>& events)
{
    for (const servo::ServoEvent& event : events) {
        if (!play(event)) {
            m_generation = 0;  // startOver() reads all moments of the recording again
            return;
        }
        ++m_events;
    }
}

/// Replays an event. Returns false if it returns to a moment that is no longer stored.
bool LiveAssessmentLoop::play(const servo::ServoEvent& event)
{
    if (event.kind == servo::ServoEvent::Kind::Restore && !m_replayer->knows(event.value)) {
        auto moment = m_session.restored(event.value);
        if (!moment)
            return false;
        m_replayer->learn(event.value, std::move(*moment));
    }
    m_replayer->play(event);
    m_examiner->take(event, *m_replayer);
    return true;
}

}  // namespace core::session
