// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "tests/support/falcon/EmulatedFalcon.h"

namespace support {

/// Controls emulated Falcons by lines of text, for a test that runs in another process than the program with the
/// emulator. One command a line; words are separated by spaces; an empty line or one that begins with # does nothing:
///
///     plug SERIAL [fast]        plugs a device in; a new one gets a medium hand. The commands below are about the
///                               device that was plugged in last. fast: bytes take no time
///     unplug
///     usb off|on                off: libusb_init fails
///     deny  allow               permission to open it
///     busy  free                another program has claimed it
///     firmware                  the firmware runs, as if another program had loaded it
///     power off|on              off: the firmware is gone, and there is no mains power
///     mains off|on              the adapter alone
///     boot [zero] [stray] [try N] [echo N]   see BootOptions
///     hand none|light|medium|firm
///     grip X Y Z [SECONDS]      mm, device frame: where the hand, or without one the grip, moves
///     tip X Y Z [SECONDS]       the same in the tooth frame
///     press plus|forward|centre|minus
///     release plus|forward|centre|minus
///     faults SHARE              of the exchanges, all kinds together
///     scale COMMANDS            motor command per Nm of a leg's torque
///     at open|claim|query|autobaud|image|homing|exchange N unplug|power|replug
///                               what happens at the N-th occurrence from now on
class Commands
{
public:
    explicit Commands(EmulatedBus& bus) : m_bus(bus) {}

    /// Executes a line. Returns false if it is no command, or if there is no device for it.
    bool obey(const std::string& line);
    /// Returns the device that was plugged in last; null before.
    [[nodiscard]] EmulatedFalcon* device() const { return m_device; }

private:
    bool plug(const std::string& serial, const std::string& pace);

    EmulatedBus& m_bus;
    EmulatedFalcon* m_device = nullptr;
};

}  // namespace support
