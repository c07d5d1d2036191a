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

/// All settings on which a tick depends. Stored in a recording, so that a replay computes the same.
struct ServoSettings
{
    /// The handpieces to choose from, at most kMostHandpieces; an attempt begins with the first.
    std::vector<settings::Handpiece> handpieces = std::vector<settings::Handpiece>(1);
    std::string method = "continuous";
    contact::ForceSettings force;
    settings::HardnessPreset hardness;
    settings::BreakOff breakOff;
    bool operator==(const ServoSettings&) const = default;
};

/// Computes one servo tick from one device position: contact, cutting, force. Has no device, queue or clock, so that
/// the servo loop and a replay run the same code with bit-identical results.
///
/// Servo thread (or the one thread of a replay). After construction nothing allocates, locks or throws.
class ServoTick
{
public:
    /// @param settings  the method must exist and the values must be valid: see makeServoTick()
    ServoTick(std::unique_ptr<contact::ContactMethod> method, ServoSettings settings);

    /// Replaces the tooth and returns the old one, which the caller frees. Constant time.
    /// @param anew  a new tooth: moves the bur to the device and sets force and removed volumes to zero
    /// @param tick  for a new tooth: the number before that of the next step
    contact::LiveTooth* swapTooth(contact::LiveTooth* tooth, bool anew, std::uint64_t tick = 0) noexcept;
    void setBur(std::size_t index) noexcept;
    void setDrill(bool on) noexcept { m_state.drillOn = on; }
    /// Sets the speed of the turning bur, per cent of its full speed, 1 to 100, as a pedal requests it.
    void setSpeed(std::uint64_t percent) noexcept { m_drill.setSpeedShare(static_cast<double>(percent) / 100.0); }
    /// Selects a handpiece of the settings. Does nothing if there is none of this index.
    void setHandpiece(std::size_t index) noexcept;
    /// Copies hand, bur and drill from the state of another servo. Call before the first tooth.
    void beginAs(const ServoState& left) noexcept;
    /// Sets the stiffness, per cent of the settings: what is stable in a loop with more delay.
    void setSpring(std::uint64_t percent) noexcept { m_force.setShare(0.01 * static_cast<double>(percent)); }

    /// Sets a parameter (ServoParameters.h). Does nothing if it is not valid.
    void setNumber(const SetParameter& number) noexcept;

    /// Leads the hand to its start over the tooth, if the device has a work area (contact::WorkArea).
    void bringHome() noexcept { m_workArea.bringHome(); }

    /// Computes one tick. There must be a tooth. The work is bounded: it neither allocates, locks nor throws, looks at
    /// no more columns than LiveTooth::columnsRoom() holds, and tries a limited number of advances (Drill).
    /// @param device  null: no reading in this tick. A position that is not finite, is more than a metre away or is
    ///                farther from the last than a hand can move is treated as null. For less than 10 ms the hand is
    ///                assumed to rest. After that, or if there was no reading before, the device is lost: no force, and
    ///                nothing moves
    void step(const glm::vec3* device, std::chrono::microseconds dt) noexcept;

    /// Returns the state after the last step. `tick` counts the steps of the attempt; the loop sets the fields about
    /// its channels.
    [[nodiscard]] const ServoState& state() const noexcept { return m_state; }
    /// Returns the columns that the last step lowered.
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
    contact::ForceSettings m_firstForce;       ///< before setNumber(); every new tooth begins with it
    settings::HardnessPreset m_firstHardness;  ///< likewise
    std::unique_ptr<contact::ContactMethod> m_method;
    contact::ForceLaw m_force;
    contact::WorkArea m_workArea;
    contact::BurVibration m_vibration;
    cutting::Drill m_drill;
    contact::LiveTooth* m_tooth = nullptr;
    ServoState m_state;
    cutting::CutRect m_changed;
    std::chrono::microseconds m_unread{0};  ///< time without a usable reading
    bool m_restart = true;
    bool m_wasLost = false;
    bool m_groundIsNew = false;  ///< the tooth or the bur was replaced since the last step
    bool m_mayAct = false;       ///< the bur has been outside the tooth since the tooth began
};

/// Checks the settings and builds the servo. The error names the first invalid setting.
[[nodiscard]] Result<std::unique_ptr<ServoTick>> makeServoTick(const ServoSettings& settings);

}  // namespace core::servo
