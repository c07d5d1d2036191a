// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/Rig.h"
#include "core/session/SessionChannels.h"

#include <cassert>
#include <cstdlib>

#include <glm/common.hpp>

#include "core/bur/Bur.h"

namespace support {
namespace {

using namespace core::session;
using namespace core::servo;

constexpr std::uint64_t kTicksPerSession = 10;

/// Runs both loops until the session sends the tooth, the servo begins with it, and the session has received that.
void begin(Rig& rig)
{
    rig.session->tick(rig.period);
    rig.servo->tick(rig.period);
    rig.session->tick(rig.period);
}

}  // namespace

Bench::Bench(const core::terrain::Tooth& begun, const char* bur, const ServoSettings& settings)
    : tooth(std::make_unique<core::contact::LiveTooth>(begun)), servo(makeServoTick(settings).value())
{
    servo->setBur(core::bur::findBur(bur).value());
    servo->swapTooth(tooth.get(), true);
    servo->setDrill(true);
}

const ServoState& Bench::step(const glm::dvec3& device, int dtUs) const
{
    const glm::vec3 sample(device);
    servo->step(&sample, std::chrono::microseconds(dtUs));
    return servo->state();
}

Rig::Rig(const ServoSettings& wanted, std::chrono::microseconds beat, const SessionMemory& memory)
    : settings(wanted), period(beat), servoLinks(std::make_unique<ServoChannels>()),
      uiLinks(std::make_unique<UiChannels>()),
      session(std::make_unique<SessionLoop>(*servoLinks, *uiLinks, settings, memory)),
      servo(std::make_unique<haptics::ServoLoop>(device, makeServoTick(settings).value(), *servoLinks, uiLinks->servo,
                                                 period))
{}

void Rig::send(SessionCommand command)
{
    if (!uiLinks->commands.tryPush(std::move(command)))
        std::abort();  // a test must not send more than the queue holds
}

void Rig::open(const std::shared_ptr<const core::terrain::ToothAnatomy>& anatomy, std::uint64_t generation,
               const std::string& lesson)
{
    send(ReplaceTooth{std::make_unique<core::terrain::Tooth>(anatomy), generation, lesson});
    begin(*this);
}

void Rig::resume(const core::recording::Recording& recording, std::uint64_t generation)
{
    send(ResumeAttempt{rebuild(recording).value(), generation});
    begin(*this);
}

void Rig::drill(const std::shared_ptr<const core::terrain::ToothAnatomy>& anatomy, std::uint64_t generation,
                const std::string& lesson)
{
    open(anatomy, generation, lesson);
    send(SetDrill{true});
}

void Rig::give(SessionCommand command)
{
    send(std::move(command));
    run(20);
}

void Rig::run(int ticks, std::chrono::microseconds dt)
{
    for (int k = 0; k < ticks; ++k) {
        servo->tick(dt);
        if (++beats % kTicksPerSession == 0)
            settle();
    }
}

void Rig::lean(double x, double y, double newtons, int ticks)
{
    const double stretch = newtons / settings.force.stiffnessNPerMm;
    for (int k = 0; k < ticks; ++k) {
        device.tipMm = glm::vec3(glm::dvec3(x, y, servo->state().anchorMm.z - stretch));
        run(1);
    }
}

void Rig::follow(RestlessHand& hand, int ticks)
{
    for (int n = 0; n < ticks; ++n) {
        device.tipMm = hand.next();
        run(1);
    }
}

void Rig::lift()
{
    device.tipMm.z = 5.0F;
    run(200);
    settle();
}

void Rig::settle()
{
    session->tick(period);
    for (TilePatch patch; uiLinks->patches.tryPop(patch);) {
        // no view reads them
    }
}

glm::vec3 RestlessHand::next()
{
    for (int axis = 0; axis < 3; ++axis)
        m_speed[axis] = 0.97 * m_speed[axis] + m_rng.uniform(-0.004, 0.004);
    m_atMm += m_speed;
    const glm::dvec3 low(-m_reachMm, -m_reachMm, -3.0);
    const glm::dvec3 high(m_reachMm, m_reachMm, 1.2);
    m_atMm = glm::clamp(m_atMm, low, high);
    return glm::vec3(m_atMm);
}

}  // namespace support
