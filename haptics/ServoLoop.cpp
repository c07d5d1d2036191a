// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/ServoLoop.h"
#include "core/rt/TripleBuffer.h"
#include "core/servo/ServoState.h"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/servo/ServoParameters.h"

namespace haptics {
namespace {

using namespace core::servo;

/// Number of ticks between two groups of patches: the view gets a new surface 125 times a second.
constexpr int kTicksPerGroup = 8;
constexpr int kMaxTiles = (core::terrain::kMaxGridSide / kTileSide) * (core::terrain::kMaxGridSide / kTileSide);
static_assert(kMaxTiles <= kServoPatches, "a group goes whole or not at all");
constexpr std::size_t kMostEventsPerCommand = 7;

/// Largest delay at which the shipped stiffness is stable in every hand. The permitted stiffness is proportional to one
/// over the delay: twice the delay allows half of it (docs/facts/haptics.md, section 2.2).
constexpr float kHeldDelayS = 0.002F;
/// A device with a longer delay counts as lost. When it is back, that delay does not soften the spring.
constexpr float kLongestDelayS = 0.02F;
constexpr double kForgottenS = 1.0;  ///< time over which a delay is forgotten
constexpr std::uint64_t kSpringStepPercent = 5;

constexpr double kFixtureComesS = 0.3;
constexpr double kFeltN = 0.1;

glm::dvec3 clamped(const glm::dvec3& forceN, double mostN) noexcept
{
    const double newtons = std::sqrt(glm::dot(forceN, forceN));
    return newtons > mostN ? forceN * (mostN / newtons) : forceN;
}

}  // namespace

ServoLoop::ServoLoop(HapticDevice& device, std::unique_ptr<ServoTick> tick, ServoChannels& links,
                     core::rt::TripleBuffer<ServoState>& state, std::chrono::microseconds period)
    : m_device(device), m_tick(std::move(tick)), m_links(links), m_stateOut(state), m_period(period),
      m_isDirty(kMaxTiles, 0)
{
    assert(m_tick != nullptr);
    assert(period > std::chrono::microseconds::zero() && period <= std::chrono::milliseconds(50));
    m_dirty.reserve(kMaxTiles);
}

ServoLoop::~ServoLoop()
{
    delete m_tick->tooth();
    for (ServoCommand command; m_links.commands.tryPop(command);)
        if (const auto* swap = std::get_if<SwapTooth>(&command)) {
            delete swap->tooth;
            delete swap->servo;
        } else if (const auto* held = std::get_if<SetFixture>(&command)) {
            delete held->fixture;
        }
}

void ServoLoop::record(const ServoEvent& event) noexcept
{
    // After a missing event, a recording could not be replayed. It ends here; the next tooth begins a new one.
    if ((m_health & kRecordGap) != 0 || !m_links.events.tryPush(event))
        m_health |= kRecordGap;
}

void ServoLoop::apply(const SwapTooth& swap) noexcept
{
    // tick() has checked that the queue has room for the old tooth
    if (core::contact::LiveTooth* old = m_tick->swapTooth(swap.tooth, swap.anew, swap.tick))
        static_cast<void>(m_links.retired.tryPush(old));
    if (swap.servo != nullptr) {
        swap.servo->beginAs(m_tick->state());
        swap.servo->setSpring(m_springPercent);
        swap.servo->setSpeed(m_speedPercent);
        static_cast<void>(swap.servo->swapTooth(swap.tooth, swap.anew, swap.tick));
        static_cast<void>(m_links.retiredServos.tryPush(m_tick.release()));
        m_tick.reset(swap.servo);
    }
    m_generation = swap.generation;
    m_serial = swap.serial;
    for (const std::uint16_t tile : m_dirty)
        m_isDirty[tile] = 0;
    m_dirty.clear();
    m_tilesPerSide = (swap.tooth->grid().side + kTileSide - 1) / kTileSide;
    m_stroke.restart();
    m_strokeEnded = false;
    m_health &= ~static_cast<std::uint32_t>(kPatchQueueFull);
    if (!swap.anew) {
        record({ServoEvent::Kind::Restore, 0, glm::vec3(0.0F), swap.tick});
        return;
    }
    m_health = 0;
    record({ServoEvent::Kind::Begin, 0, glm::vec3(0.0F), swap.generation});
    if (swap.resumed)
        record({ServoEvent::Kind::Resume, 0, glm::vec3(0.0F), 0});
    record({ServoEvent::Kind::Bur, 0, glm::vec3(0.0F), m_tick->state().burIndex});
    record({ServoEvent::Kind::Drill, 0, glm::vec3(0.0F), m_tick->state().drillOn ? 1U : 0U});
    if (const std::uint8_t handpiece = m_tick->state().handpieceIndex; handpiece != 0)
        record({ServoEvent::Kind::Handpiece, 0, glm::vec3(0.0F), handpiece});
    if (m_springPercent != 100)
        record({ServoEvent::Kind::Spring, 0, glm::vec3(0.0F), m_springPercent});
    if (m_speedPercent != 100)
        record({ServoEvent::Kind::Speed, 0, glm::vec3(0.0F), m_speedPercent});
}

void ServoLoop::apply(const SetBur& bur) noexcept
{
    if (bur.index >= core::bur::burs().size())
        return;
    m_tick->setBur(bur.index);
    record({ServoEvent::Kind::Bur, 0, glm::vec3(0.0F), bur.index});
}

void ServoLoop::apply(const SetDrill& drill) noexcept
{
    m_drillIsOn = drill.on;
    turnBur(m_drillIsOn && !m_pedalIsUp);
}

/// Starts and stops the bur with the pedal, if the device has one.
void ServoLoop::followPedal(const std::optional<bool>& pedal) noexcept
{
    m_pedalIsUp = pedal && !*pedal;
    const bool turns = m_drillIsOn && !m_pedalIsUp;
    if (pedal && turns != m_tick->state().drillOn)
        turnBur(turns);
}

void ServoLoop::setSpeed(std::uint64_t percent) noexcept
{
    if (percent == m_speedPercent || percent < 1 || percent > 100)
        return;
    m_speedPercent = percent;
    m_tick->setSpeed(percent);
    record({ServoEvent::Kind::Speed, 0, glm::vec3(0.0F), percent});
}

void ServoLoop::turnBur(bool on) noexcept
{
    m_tick->setDrill(on);
    record({ServoEvent::Kind::Drill, 0, glm::vec3(0.0F), on ? 1U : 0U});
}

void ServoLoop::apply(const SetHandpiece& handpiece) noexcept
{
    if (handpiece.index >= m_tick->settings().handpieces.size())
        return;
    m_tick->setHandpiece(handpiece.index);
    record({ServoEvent::Kind::Handpiece, 0, glm::vec3(0.0F), handpiece.index});
}

void ServoLoop::apply(const SetParameter& number) noexcept
{
    if (!core::servo::isServoNumber(number))
        return;
    m_tick->setNumber(number);
    record({ServoEvent::Kind::Number, 0, glm::vec3(0.0F), core::servo::packNumber(number)});
}

void ServoLoop::apply(const SetFixture& fixture) noexcept
{
    // tick() has checked that the queue has room for the old fixture
    if (m_fixture)
        static_cast<void>(m_links.retiredFixtures.tryPush(m_fixture.release()));
    m_fixture.reset(fixture.fixture);
    m_fixtureShare = 0.0;
}

/// Adds the forces on the hand other than contact. They are not recorded, because only the path of the hand depends on
/// them.
void ServoLoop::guide(double seconds) noexcept
{
    m_guideN = glm::dvec3(0.0);
    const ServoState& state = m_tick->state();
    if (!m_fixture || (state.health & (kDeviceLost | kBegunInside | kLedHome)) != 0) {
        m_fixtureShare = 0.0;
        return;
    }
    m_fixtureShare = std::min(1.0, m_fixtureShare + seconds / kFixtureComesS);
    // The fixture is a spring like that of contact, so a long delay limits its stiffness in the same way.
    const double share = m_fixtureShare * 0.01 * static_cast<double>(m_springPercent);
    m_guideN = share * m_fixture->forceN(state.deviceMm, state.burIndex);
}

void ServoLoop::apply(const BringHome&) noexcept
{
    m_tick->bringHome();
    record({ServoEvent::Kind::Home, 0, glm::vec3(0.0F), 0});
}

/// Softens the spring within ticks if the device answers late, and stiffens it gradually when the device is in time
/// again. A single late answer has no effect: all of the last few must be late. A tick without a measured delay has no
/// effect.
void ServoLoop::watchDelay(float delayS, double seconds) noexcept
{
    if (!(delayS > 0.0F))
        return;
    m_lateS[m_nextLate++ % m_lateS.size()] = std::min(delayS, kLongestDelayS);
    const float now = *std::min_element(m_lateS.begin(), m_lateS.end());
    const auto forgotten = static_cast<float>(std::min(1.0, seconds / kForgottenS));
    m_delayS = std::max(now, m_delayS + (now - m_delayS) * forgotten);
    const float share = m_delayS > kHeldDelayS ? kHeldDelayS / m_delayS : 1.0F;
    const auto steps = static_cast<std::uint64_t>(share * 100.0F) / kSpringStepPercent;
    setSpring(std::max<std::uint64_t>(1, steps) * kSpringStepPercent);
}

/// Forgets the delays of a lost device, because the next device may be another one.
void ServoLoop::forgetDelay() noexcept
{
    m_lateS = {};
    m_delayS = 0.0F;
    setSpring(100);
}

void ServoLoop::setSpring(std::uint64_t percent) noexcept
{
    if (percent == m_springPercent)
        return;
    m_springPercent = percent;
    m_tick->setSpring(percent);
    record({ServoEvent::Kind::Spring, 0, glm::vec3(0.0F), percent});
}

void ServoLoop::carryOutCommands() noexcept
{
    // Takes a command only if the queues have room for every object that it may send back and for its events.
    for (ServoCommand command; m_links.retired.space() > 0 && m_links.retiredServos.space() > 0 &&
                               m_links.retiredFixtures.space() > 0 && m_links.events.space() >= kMostEventsPerCommand &&
                               m_links.commands.tryPop(command);)
        std::visit([this](const auto& known) { apply(known); }, command);
}

/// Returns whether the loop rests. At the start of a rest, it sets the force to zero and silences the handpiece.
bool ServoLoop::rest() noexcept
{
    const bool rests = m_restWanted.load(std::memory_order_acquire);
    if (rests && !m_rests.load(std::memory_order_relaxed)) {
        m_device.give(glm::dvec3(0.0));
        if (m_soundOut != nullptr)
            m_soundOut->publish({});
    }
    m_rests.store(rests, std::memory_order_release);
    return rests;
}

void ServoLoop::tick(std::chrono::microseconds dt) noexcept
{
    carryOutCommands();
    if (rest())
        return;
    m_missedPeriods += static_cast<std::uint64_t>(std::max<std::int64_t>(0, dt / m_period - 1));
    const std::chrono::microseconds step = std::min(dt, std::max(kLongestStep, m_period));
    m_device.seeBur(m_tick->state().anchorMm);
    const DeviceSample sample =
        m_device.exchange(clamped(m_tick->state().forceN + m_guideN, m_tick->settings().force.clampN));
    const auto taken = std::chrono::steady_clock::now().time_since_epoch();
    if (m_tick->tooth() != nullptr) {
        if (sample.present)
            watchDelay(sample.delayS, static_cast<double>(step.count()) * 1.0e-6);
        setSpeed(sample.speedPercent);
        followPedal(sample.pedal);
        m_tick->step(sample.present ? &sample.tipInToothMm : nullptr, step);
        record({sample.present ? ServoEvent::Kind::Tick : ServoEvent::Kind::NoDevice,
                static_cast<std::uint16_t>(step.count()), sample.tipInToothMm, 0});
        if ((m_tick->state().health & kDeviceLost) != 0)
            forgetDelay();
        const bool cut = !m_tick->changed().isEmpty();
        if (cut)
            markDirty(m_tick->changed());
        guide(static_cast<double>(step.count()) * 1.0e-6);
        // With a pedal, a stroke lasts until the pedal is released, even if the hand pauses. So one press is one step
        // of undo.
        const bool isHeld = m_stroke.isInStroke() && sample.pedal.value_or(false) && m_tick->state().drillOn;
        m_strokeEnded = m_stroke.endsWith(cut || isHeld) || m_strokeEnded;
        if (++m_ticksSinceSent >= kTicksPerGroup || m_strokeEnded)
            sendPatches();
    }

    m_device.give(clamped(m_tick->state().forceN + m_guideN, m_tick->settings().force.clampN));
    const ServoState& state = m_tick->state();
    m_trail[m_nextPose++ % m_trail.size()] = {std::chrono::nanoseconds(taken).count(), state.deviceMm, state.anchorMm};
    ServoState& out = m_stateOut.back();
    out = state;
    out.trail = m_trail;
    out.drillSwitchedOn = m_drillIsOn || state.drillOn;
    out.toothGeneration = m_generation;
    out.missedPeriods = m_missedPeriods;
    out.health |= m_health | (m_springPercent < 100 ? core::servo::kLoopIsSlow : 0U) |
                  (glm::dot(m_guideN, m_guideN) > kFeltN * kFeltN ? core::servo::kHeldInside : 0U);
    m_stateOut.publish();
    if (m_soundOut != nullptr)
        m_soundOut->publish(m_sound.update(state, m_tick->settings().handpieces[state.handpieceIndex],
                                           static_cast<double>(step.count()) * 1.0e-6));
}

void ServoLoop::markDirty(const core::cutting::CutRect& rect) noexcept
{
    for (int y = rect.j0 / kTileSide; y <= rect.j1 / kTileSide; ++y) {
        for (int x = rect.i0 / kTileSide; x <= rect.i1 / kTileSide; ++x) {
            const auto tile = static_cast<std::uint16_t>(y * m_tilesPerSide + x);
            if (m_isDirty[tile] != 0)
                continue;
            m_isDirty[tile] = 1;
            assert(m_dirty.size() < m_dirty.capacity());
            m_dirty.push_back(tile);  // within the reserved capacity: at most one entry a tile
        }
    }
}

void ServoLoop::sendPatches() noexcept
{
    // The last group of a stroke must be sent even if all its tiles are sent already: the first tile is then sent
    // again.
    if (m_dirty.empty() && m_strokeEnded) {
        m_isDirty[0] = 1;
        m_dirty.push_back(0);
    }
    if (m_dirty.empty())
        return;
    m_health &= ~static_cast<std::uint32_t>(kPatchQueueFull);
    if (m_links.patches.space() < m_dirty.size()) {
        m_health |= kPatchQueueFull;  // the tiles stay dirty and are sent later
        return;
    }
    m_ticksSinceSent = 0;
    const core::terrain::Tooth& tooth = m_tick->tooth()->tooth();
    const int side = tooth.grid().side;
    for (std::size_t n = 0; n < m_dirty.size(); ++n) {
        const int tile = m_dirty[n];
        m_isDirty[static_cast<std::size_t>(tile)] = 0;
        m_patch.tick = m_tick->state().tick;
        m_patch.toothGeneration = m_serial;
        m_patch.tileX = static_cast<std::uint16_t>(tile % m_tilesPerSide);
        m_patch.tileY = static_cast<std::uint16_t>(tile / m_tilesPerSide);
        m_patch.last = n + 1 == m_dirty.size();
        m_patch.strokeEnded = m_patch.last && m_strokeEnded;
        const int firstI = m_patch.tileX * kTileSide;
        const int firstJ = m_patch.tileY * kTileSide;
        const int columns = std::min(kTileSide, side - firstI);
        for (int j = firstJ; j < std::min(firstJ + kTileSide, side); ++j)
            std::copy_n(tooth.top.begin() + static_cast<std::ptrdiff_t>(tooth.grid().index(firstI, j)), columns,
                        m_patch.top.begin() + static_cast<std::ptrdiff_t>((j - firstJ) * kTileSide));
        static_cast<void>(m_links.patches.tryPush(m_patch));
    }
    m_dirty.clear();
    m_strokeEnded = false;
}

}  // namespace haptics
