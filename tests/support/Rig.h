// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "core/base/Rng.h"
#include "core/servo/ServoState.h"
#include "core/session/SessionChannels.h"
#include "core/session/SessionLoop.h"
#include "haptics/ServoLoop.h"

namespace support {

/// A device whose position is set by the test.
class HeldDevice final : public haptics::HapticDevice
{
public:
    glm::vec3 tipMm{0.0F, 0.0F, 5.0F};
    bool present = true;
    float delayS = 0.0F;
    std::optional<bool> pedal;
    std::uint8_t speedPercent = 100;
    glm::dvec3 forceN{0.0};  ///< last force given to the hand

    haptics::DeviceSample exchange(const glm::dvec3& forceOnHandN) noexcept override
    {
        forceN = forceOnHandN;
        return {tipMm, present, delayS, pedal, speedPercent};
    }
};

/// A servo tick with a tooth and without a loop or device. The test sets the position of the bur. The drill is on.
struct Bench
{
    std::unique_ptr<core::contact::LiveTooth> tooth;
    std::unique_ptr<core::servo::ServoTick> servo;

    Bench(const core::terrain::Tooth& begun, const char* bur, const core::servo::ServoSettings& settings = {});
    const core::servo::ServoState& step(const glm::dvec3& device, int dtUs = 1000) const;
    [[nodiscard]] const core::servo::ServoState& state() const { return servo->state(); }
};

/// Servo and session loop joined as in the program, but run step by step in one thread.
struct Rig
{
    explicit Rig(const core::servo::ServoSettings& settings = {},
                 std::chrono::microseconds period = std::chrono::milliseconds(1),
                 const core::session::SessionMemory& memory = {});

    /// Hands a new tooth to the session and lets both loops begin with it. Leaves one tick on the recording.
    void open(const std::shared_ptr<const core::terrain::ToothAnatomy>& anatomy, std::uint64_t generation = 1,
              const std::string& lesson = {});
    /// Like open(), but with the drill on.
    void drill(const std::shared_ptr<const core::terrain::ToothAnatomy>& anatomy, std::uint64_t generation = 1,
               const std::string& lesson = {});
    /// Resumes an attempt made elsewhere; otherwise like open().
    void resume(const core::recording::Recording& recording, std::uint64_t generation = 1);
    void send(core::session::SessionCommand command);
    /// Sends a command and runs until both loops have executed it.
    void give(core::session::SessionCommand command);
    /// Runs the servo, and the session after every tenth tick, as in the program.
    void run(int ticks, std::chrono::microseconds dt = std::chrono::milliseconds(1));
    /// Presses straight down at (x, y) with about this force, through the spring, for some ticks.
    void lean(double x, double y, double newtons, int ticks);
    /// Follows a hand for some ticks.
    void follow(class RestlessHand& hand, int ticks);
    /// Lifts off and waits until the stroke has ended and all reports have arrived.
    void lift();
    /// Runs the session until no event and no patch is left.
    void settle();

    [[nodiscard]] const core::terrain::Tooth& live() const { return servo->tooth()->tooth(); }
    [[nodiscard]] std::uint64_t liveHash() const { return core::terrain::stateHash(live()); }
    [[nodiscard]] std::uint64_t mirrorHash() const { return core::terrain::stateHash(session->toothSoFar().value()); }

    core::servo::ServoSettings settings;
    std::chrono::microseconds period;
    std::unique_ptr<core::servo::ServoChannels> servoLinks;
    std::unique_ptr<core::session::UiChannels> uiLinks;
    HeldDevice device;
    std::unique_ptr<core::session::SessionLoop> session;
    std::unique_ptr<haptics::ServoLoop> servo;  ///< destroyed before the session, as in the program
    std::uint64_t beats = 0;
};

/// A restless hand: it moves at random, by a seed, over and in the tooth, smoothly enough to cut and roughly enough to
/// find errors.
class RestlessHand
{
public:
    explicit RestlessHand(std::uint64_t seed, double reachMm = 3.0) : m_rng(seed), m_reachMm(reachMm) {}
    /// Returns the position at the next tick.
    [[nodiscard]] glm::vec3 next();

private:
    core::Rng m_rng;
    double m_reachMm;
    glm::dvec3 m_atMm{0.0, 0.0, 1.0};
    glm::dvec3 m_speed{0.0};
};

}  // namespace support
