// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

namespace database {

/// Initialises libsodium. Call it before any function of libsodium; it may be called repeatedly, in any thread.
bool beginSodium();

/// Returns the bytes as lower-case hex digits, two for each.
[[nodiscard]] std::string hexOf(const unsigned char* bytes, std::size_t count);

}  // namespace database
