// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "tests/support/falcon/EmulatedFalcon.h"

namespace support {

/// The state of an emulated Falcon in a small text file, for a test in another process. The file is mapped into memory:
/// what the program did last stays there when the program ends or is killed.
///
/// One line for each name with its values, between `begin N` and `end N`. A reader that finds two numbers, or no end,
/// has read while it was written, and reads again. Times are milliseconds of CLOCK_MONOTONIC, -1 before the first.
///
///     serial SERIAL           claimed 0|1     by the program
///     plugged 0|1             mains 0|1
///     firmware 0|1            it runs
///     queries N  loads N      received by the boot loader: queries, complete images
///     image_bytes N           received of the last image
///     requests N  answers N   of the running firmware
///     motors A B C            command in force
///     nonzero_ms_ago MS       before `written_ms`, the last request with a motor command that is not zero; or -1
///     nonzero_ms MS           the same as a time
///     request_ms MS           last request
///     written_ms MS           when this was written
///     leds RED GREEN BLUE     0|1 each
///     homing 0|1              bit of the last request
///     homed A B C             0|1 each
///     counts A B C            of the encoders
///     grip X Y Z              mm, device frame
///     tip X Y Z               mm, tooth frame
///     force X Y Z             newtons, of the motors on the hand, device frame
///     faults N                injected, of all kinds
class StateFile
{
public:
    static constexpr std::size_t kBytes = 2048;

    /// Creates the file, or empties it. Any error ends the program.
    explicit StateFile(const std::string& path);
    ~StateFile();
    StateFile(const StateFile&) = delete;
    StateFile& operator=(const StateFile&) = delete;

    /// Writes the state without allocating.
    void write(const EmulatedFalcon& device, const FalconState& state);

private:
    char* m_text = nullptr;
    unsigned long m_written = 0;
};

}  // namespace support
