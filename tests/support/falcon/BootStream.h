// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

namespace support::falcon {

/// Returns a boot stream that a Falcon's boot loader accepts, without a real program.
/// @param words  of the first block; the second has three
[[nodiscard]] inline std::vector<std::uint8_t> bootStream(unsigned words = 600)
{
    std::vector<std::uint8_t> bytes;
    const auto add = [&](unsigned word) {
        bytes.push_back(static_cast<std::uint8_t>(word & 0xFFU));
        bytes.push_back(static_cast<std::uint8_t>(word >> 8U));
    };
    add(0x08AA);
    for (int n = 0; n < 8; ++n)
        add(0);
    add(0x003F);
    add(0x8002);
    for (const unsigned size : {words, 3U}) {
        add(size);
        add(0x003F);
        add(0x8000);
        for (unsigned n = 0; n < size; ++n)
            add(n * 7919U & 0xFFFFU);
    }
    add(0);
    return bytes;
}

}  // namespace support::falcon
