// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <variant>

#include <glm/vec3.hpp>

#include "core/contact/LiveTooth.h"
#include "core/rt/SpscQueue.h"
#include "core/servo/ServoState.h"

namespace core::servo {

class ServoTick;

/// Another tooth for the servo; the pointer owns. Undo and reload hand over a restored copy of the same tooth.
struct SwapTooth
{
    contact::LiveTooth* tooth = nullptr;
    std::uint64_t generation = 0;  ///< of the ReplaceTooth it goes back to
    std::uint64_t serial = 0;      ///< of this hand-over; patches carry it, so that late ones are told apart
    bool anew = false;             ///< a tooth to begin with, not a step back
    std::uint64_t tick =
        0;                 ///< of the attempt, after which the tooth stood like this; anew, the servo counts on from it
    bool resumed = false;  ///< anew, but in the middle of an attempt that was begun before
    ServoTick* servo = nullptr;  ///< anew, owned: what computes from now on; null: as before
};
/// Session to servo.
using ServoCommand = std::variant<SwapTooth, SetBur, SetDrill, SetHandpiece, SetFixture, BringHome, SetParameter>;
static_assert(std::is_trivially_copyable_v<ServoCommand>);

/// One thing that happened to the servo, or to the student while it worked, in the order in which it happened: what a
/// recording is made of. Aids and notes come from the session, the rest from the servo.
struct ServoEvent
{
    enum class Kind : std::uint8_t {
        Tick,       ///< a step with `deviceMm` and `dtUs`
        NoDevice,   ///< a step without a reading
        Drill,      ///< value: 0 off, 1 on
        Bur,        ///< value: index into burs()
        Spring,     ///< value: per cent of the stiffness that the force law has from now on
        Restore,    ///< value: the tick after which the tooth stood that is put back
        Home,       ///< the hand is to be led home from now on
        Aids,       ///< value: the aids in use from now on, bits of servo::Aid. Nothing to the servo
        Note,       ///< value: what the ui wants remembered of this moment. Nothing to the servo
        Resume,     ///< taken up again after the program had ended: with a new servo, on the tooth as it stands
        Handpiece,  ///< value: index into the settings' handpieces
        Number,     ///< value: a number of the settings from now on (ServoParameters.h, packed)
        Speed,      ///< value: per cent of its full speed at which the bur turns from now on, while it turns
        Begin,      ///< a new tooth; value: its generation. Ends the recording before it
    };
    Kind kind = Kind::Tick;
    std::uint16_t dtUs = 1000;
    glm::vec3 deviceMm{0.0F};
    std::uint64_t value = 0;
    bool operator==(const ServoEvent&) const = default;
};

/// Room for every tile of the largest grid: the servo sends a group of patches whole or waits.
inline constexpr std::size_t kServoPatches = 4096;

/// The channels between servo and session.
struct ServoChannels
{
    rt::SpscQueue<ServoCommand, 64> commands;                    ///< session -> servo
    rt::SpscQueue<contact::LiveTooth*, 64> retired;              ///< servo -> session: teeth to be freed
    rt::SpscQueue<ServoTick*, 8> retiredServos;                  ///< servo -> session: to be freed
    rt::SpscQueue<const guidance::Fixture*, 8> retiredFixtures;  ///< servo -> session: to be freed
    rt::SpscQueue<TilePatch, kServoPatches> patches;             ///< servo -> session
    rt::SpscQueue<ServoEvent, 16384> events;  ///< servo -> session: 16 s at 1 kHz before anything is lost
};

}  // namespace core::servo
