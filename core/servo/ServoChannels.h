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

/// Gives the servo another tooth, which it then owns. Undo and reload give it a restored copy of the same tooth.
struct SwapTooth
{
    contact::LiveTooth* tooth = nullptr;
    std::uint64_t generation = 0;  ///< of the ReplaceTooth that the tooth belongs to
    std::uint64_t serial = 0;      ///< number of this swap; patches carry it, so that late ones of an older swap are
                                   ///< ignored
    bool anew = false;             ///< a new tooth, not an undo step
    std::uint64_t tick = 0;  ///< tick of the attempt after which the tooth was in this state; for a new tooth, the tick
                             ///< from which the servo counts on
    bool resumed = false;    ///< a new tooth for an attempt that was begun before
    ServoTick* servo = nullptr;  ///< for a new tooth, owned: computes from now on; null: no change
};
/// Commands from the session to the servo.
using ServoCommand = std::variant<SwapTooth, SetBur, SetDrill, SetHandpiece, SetFixture, BringHome, SetParameter>;
static_assert(std::is_trivially_copyable_v<ServoCommand>);

/// One event of a recording, in the order in which they happened. Aids and notes come from the session, all others from
/// the servo.
struct ServoEvent
{
    enum class Kind : std::uint8_t {
        Tick,       ///< a step with `deviceMm` and `dtUs`
        NoDevice,   ///< a step without a reading
        Drill,      ///< value: 0 off, 1 on
        Bur,        ///< value: index into burs()
        Spring,     ///< value: stiffness from now on, per cent of the force law's
        Restore,    ///< value: the tick after which the restored tooth had its state
        Home,       ///< the device starts to lead the hand to its start
        Aids,       ///< value: the aids in use from now on, bits of servo::Aid. Ignored by the servo
        Note,       ///< value: a code that the ui stores with this moment. Ignored by the servo
        Resume,     ///< resumed after the program had ended: with a new servo, on the tooth as it was
        Handpiece,  ///< value: index into the settings' handpieces
        Number,     ///< value: a parameter of the servo from now on (ServoParameters.h, packed)
        Speed,      ///< value: speed of the turning bur from now on, per cent of its full speed
        Begin,      ///< a new tooth; value: its generation. Ends the recording before it
    };
    Kind kind = Kind::Tick;
    std::uint16_t dtUs = 1000;
    glm::vec3 deviceMm{0.0F};
    std::uint64_t value = 0;
    bool operator==(const ServoEvent&) const = default;
};

/// One slot for every tile of the largest grid: the servo sends a group of patches as a whole or not yet.
inline constexpr std::size_t kServoPatches = 4096;

/// The channels between servo and session.
struct ServoChannels
{
    rt::SpscQueue<ServoCommand, 64> commands;                    ///< session -> servo
    rt::SpscQueue<contact::LiveTooth*, 64> retired;              ///< servo -> session: teeth to be freed
    rt::SpscQueue<ServoTick*, 8> retiredServos;                  ///< servo -> session: to be freed
    rt::SpscQueue<const guidance::Fixture*, 8> retiredFixtures;  ///< servo -> session: to be freed
    rt::SpscQueue<TilePatch, kServoPatches> patches;             ///< servo -> session
    rt::SpscQueue<ServoEvent, 16384> events;                     ///< servo -> session: room for 16 s at 1 kHz
};

}  // namespace core::servo
