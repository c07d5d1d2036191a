// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/attempt/SimulatedHand.h"

#include <utility>

#include "app/attempt/Demonstration.h"

namespace app {
namespace {

constexpr int kDecidePeriodMs = 16;

}  // namespace

SimulatedHand::SimulatedHand(const AttemptContext& context, AttemptController& attempts,
                             core::rt::TripleBuffer<core::servo::PointerInput>& input)
    : m_context(context), m_input(input)
{
    m_timer.setInterval(kDecidePeriodMs);
    connect(&m_timer, &QTimer::timeout, this, &SimulatedHand::decide);
    connect(&m_context.devices, &DeviceController::inUseChanged, this, &SimulatedHand::follow);
    connect(&attempts, &AttemptController::loaded, this, [this] { m_hand.reset(); });
    follow();
}

void SimulatedHand::follow()
{
    if (m_context.devices.isSimulated())
        m_timer.start();
    else
        m_timer.stop();
}

void SimulatedHand::decide()
{
    const core::servo::ServoState& state = m_context.channels.servo.latest();
    if (const auto ledTo = m_leadMm ? m_leadMm() : std::nullopt)
        m_input.publish({.targetMm = glm::dvec2(*ledTo), .hoverMm = ledTo->z, .pushing = false});
    const auto tooth = m_context.session.toothSoFar();
    const lessons::Assignment& assignment = m_context.attempt.assignment();
    if (m_context.attempt.isResting() || assignment.exercise || !tooth || tooth->anatomy != assignment.anatomy)
        return;
    if (!m_hand || std::exchange(m_bur, state.burIndex) != state.burIndex)
        m_hand = handFor(assignment, state.burIndex);
    m_input.publish(m_hand->decide(state, *tooth));
}

}  // namespace app
