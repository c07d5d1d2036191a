// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdio>
#include <cstdlib>

namespace support {

/// Ends the program because it uses libusb or the emulator in a way that is always an error.
[[noreturn]] inline void abortFor(const char* sentence)
{
    std::fprintf(stderr, "Emulated Falcon: %s.\n", sentence);
    std::fflush(stderr);
    std::abort();
}

}  // namespace support
