// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <memory>
#include <vector>

#include "core/contact/BurVibration.h"
#include "core/contact/ContactMethod.h"
#include "core/contact/ForceLaw.h"
#include "core/contact/LiveTooth.h"
#include "core/contact/WorkArea.h"
#include "core/cutting/Drill.h"
#include "core/servo/ServoState.h"
#include "core/settings/BreakOff.h"

namespace core::servo {

inline constexpr std::size_t kMostHandpieces = 8;

/// Everything that decides what a tick computes. Stored in a recording, so that a replay computes the same.
struct ServoSettings
{
    /// Those at hand, at most kMostHandpieces; an attempt begins with the first.
    std::vector<settings::Handpiece> handpieces = std::vector<settings::Handpiece>(1);
    std::string method = "continuous";
    contact::ForceSettings force;
    settings::HardnessPreset hardness;
    settings::BreakOff breakOff;
    bool operator==(const ServoSettings&) const = default;
};

/// What one servo tick computes from one device position: contact, cutting, force. No device, no queue, no clock, so
/// the servo loop and a replay run the very same code to the very same bits.
///
/// Servo thread (or the one thread of a replay). After construction nothing allocates, locks or throws.
class ServoTick
{
public:
    /// @param settings  method name must exist and values be checked: see makeServoTick()
    ServoTick(std::unique_ptr<contact::ContactMethod> method, ServoSettings settings);

    /// Takes another tooth and gives the old one back for its owner to free. Constant time.
    /// @param anew  a tooth to begin with: bur to the device, force and removed volumes to zero
    /// @param tick  anew: the number that the next step's follows
    contact::LiveTooth* swapTooth(contact::LiveTooth* tooth, bool anew, std::uint64_t tick = 0) noexcept;
    void setBur(std::size_t index) noexcept;
    void setDrill(bool on) noexcept { m_state.drillOn = on; }
    /// Sets the speed of the bur from now on, per cent of its full speed, 1 to 100: what a pedal asks for.
    void setSpeed(std::uint64_t percent) noexcept { m_drill.setSpeedShare(static_cast<double>(percent) / 100.0); }
    /// Another of the settings' handpieces; nothing where there is none of this number.
    void setHandpiece(std::size_t index) noexcept;
    /// Before the first tooth: hand, bur and drill as another servo leaves them.
    void beginAs(const ServoState& left) noexcept;
    /// The spring from now on as per cent of the settings: what a loop with more delay still holds.
    void setSpring(std::uint64_t percent) noexcept { m_force.setShare(0.01 * static_cast<double>(percent)); }

    /// One of the settings' numbers (ServoParameters.h) from now on; nothing where it may not be that.
    void setNumber(const SetParameter& number) noexcept;

    /// Leads the hand home over the tooth, if the device has a work area (contact::WorkArea).
    void bringHome() noexcept { m_workArea.bringHome(); }

    /// One tick. A tooth must be there.
    /// @param device  null: no reading this tick. So counts a position that is not finite, is more than a metre away or
    ///                cannot have been come to by a hand. For less than 10 ms the hand is taken to rest where it was;
    ///                after that, or when there was none before, the device is lost: no force, and nothing moves
    void step(const glm::vec3* device, std::chrono::microseconds dt) noexcept;

    /// As of the last step. `tick` counts steps of the attempt; links' fields are not filled here.
    [[nodiscard]] const ServoState& state() const noexcept { return m_state; }
    /// Columns that the last step lowered.
    [[nodiscard]] const cutting::CutRect& changed() const noexcept { return m_changed; }
    [[nodiscard]] const contact::LiveTooth* tooth() const noexcept { return m_tooth; }
    [[nodiscard]] const ServoSettings& settings() const noexcept { return m_settings; }

private:
    void cut(const glm::dvec3& reached, double forceN, double seconds) noexcept;
    void lose() noexcept;
    [[nodiscard]] bool leapt(const glm::dvec3& device, double seconds) const noexcept;
    void letGo() noexcept;
    [[nodiscard]] glm::dvec3 around(const glm::dvec3& contactN, double seconds) noexcept;
    void describe() noexcept;
    void takeNumbers() noexcept;

    ServoSettings m_settings;
    contact::ForceSettings m_firstForce;       ///< before setNumber(): every tooth taken anew begins with it
    settings::HardnessPreset m_firstHardness;  ///< the same
    std::unique_ptr<contact::ContactMethod> m_method;
    contact::ForceLaw m_force;
    contact::WorkArea m_workArea;
    contact::BurVibration m_vibration;
    cutting::Drill m_drill;
    contact::LiveTooth* m_tooth = nullptr;
    ServoState m_state;
    cutting::CutRect m_changed;
    std::chrono::microseconds m_unread{0};  ///< for so long no reading could be used
    bool m_restart = true;
    bool m_wasLost = false;
    bool m_groundIsNew = false;  ///< another state of the tooth or another bur since the last step
    bool m_mayAct = false;       ///< the bur has been free since the tooth was taken anew
};

/// Checks the settings, then builds. The error names the first thing wrong.
[[nodiscard]] Result<std::unique_ptr<ServoTick>> makeServoTick(const ServoSettings& settings);

}  // namespace core::servo
