// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "core/base/Rng.h"
#include "core/servo/ServoState.h"
#include "core/session/SessionChannels.h"
#include "core/session/SessionLoop.h"
#include "haptics/ServoLoop.h"

namespace support {

/// A device that is wherever the test has put it.
class HeldDevice final : public haptics::HapticDevice
{
public:
    glm::vec3 tipMm{0.0F, 0.0F, 5.0F};
    bool present = true;
    float delayS = 0.0F;
    std::optional<bool> pedal;
    std::uint8_t speedPercent = 100;
    glm::dvec3 forceN{0.0};  ///< as last given to the hand

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

/// Servo and session loop joined as the program joins them, but beaten by hand in one thread.
struct Rig
{
    explicit Rig(const core::servo::ServoSettings& settings = {},
                 std::chrono::microseconds period = std::chrono::milliseconds(1),
                 const core::session::SessionMemory& memory = {});

    /// Hands a new tooth to the session and lets both loops begin with it. Leaves one tick on the recording.
    void open(const std::shared_ptr<const core::terrain::ToothAnatomy>& anatomy, std::uint64_t generation = 1,
              const std::string& lesson = {});
    /// The same, and the drill is on.
    void drill(const std::shared_ptr<const core::terrain::ToothAnatomy>& anatomy, std::uint64_t generation = 1,
               const std::string& lesson = {});
    /// Goes on with an attempt made elsewhere; as open() otherwise.
    void resume(const core::recording::Recording& recording, std::uint64_t generation = 1);
    void send(core::session::SessionCommand command);
    /// Sends it and beats until both loops have done it.
    void give(core::session::SessionCommand command);
    /// Beats the servo, and the session after every tenth beat, as in the program.
    void run(int ticks, std::chrono::microseconds dt = std::chrono::milliseconds(1));
    /// Leans straight down at (x, y) with about so many newtons against the spring for some ticks.
    void lean(double x, double y, double newtons, int ticks);
    /// Goes where a hand goes, for some ticks.
    void follow(class RestlessHand& hand, int ticks);
    /// Lifts off and waits until the stroke has ended and everything has been told.
    void lift();
    /// Beats the session until no event and no patch is left.
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
    std::unique_ptr<haptics::ServoLoop> servo;  ///< gone before the session, as in the program
    std::uint64_t beats = 0;
};

/// A restless hand: wanders over and in the tooth from a seed, smoothly enough to cut, roughly enough to surprise.
class RestlessHand
{
public:
    explicit RestlessHand(std::uint64_t seed, double reachMm = 3.0) : m_rng(seed), m_reachMm(reachMm) {}
    /// The next position, one tick on.
    [[nodiscard]] glm::vec3 next();

private:
    core::Rng m_rng;
    double m_reachMm;
    glm::dvec3 m_atMm{0.0, 0.0, 1.0};
    glm::dvec3 m_speed{0.0};
};

}  // namespace support
