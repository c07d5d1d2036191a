// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/LiveAssessor.h"

#include <utility>

namespace core::session {

LiveAssessor::LiveAssessor(const Examination& examination, std::shared_ptr<const terrain::ToothAnatomy> anatomy)
    : m_meter(std::make_unique<grading::ProcessMeter>(examination.rules.forceLimitN.value_or(kUsualForceLimitN))),
      m_referee(examination.rules, std::move(anatomy), examination.ideal)
{
    if (examination.exercise)
        m_exercise.emplace(*examination.exercise);
}

std::optional<grading::Practised> LiveAssessor::practised() const
{
    return m_exercise ? std::optional(m_exercise->practised()) : std::nullopt;
}

void LiveAssessor::take(const servo::ServoEvent& event, const recording::Replayer& replayed)
{
    const terrain::Tooth& tooth = replayed.tooth().tooth();
    if (event.kind == servo::ServoEvent::Kind::Restore) {
        m_meter->undone();
        m_referee.restored(tooth);
    }
    if (event.kind == servo::ServoEvent::Kind::Aids)
        m_aids |= static_cast<std::uint8_t>(event.value);
    if (event.kind == servo::ServoEvent::Kind::Note && m_exercise)
        m_exercise->noted(event.value);
    m_rests.hear(event);
    if (!recording::isStep(event))
        return;
    const std::chrono::microseconds dt(event.dtUs);
    if (m_rests.leaveOut(replayed.state())) {
        if (m_left.empty() || m_left.back().after != m_worked)
            m_left.push_back({m_worked});
        m_left.back().length += dt;
        m_leftOut = true;
    } else {
        if (std::exchange(m_leftOut, false))
            m_meter->interrupted();
        m_worked += dt;
        m_meter->take(replayed.state(), dt);
        if (m_exercise)
            m_exercise->take(replayed.state(), dt);
    }
    for (const grading::Infraction& infraction : m_referee.look(replayed.state(), replayed.changed(), tooth, dt))
        m_infractions.push_back(infraction);
}

double LiveAssessor::recordedS(double atS) const
{
    double recorded = atS;
    for (const Rest& rest : m_left)
        if (std::chrono::duration<double>(rest.after).count() < atS)
            recorded += std::chrono::duration<double>(rest.length).count();
    return recorded;
}

}  // namespace core::session
