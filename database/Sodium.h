// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

namespace database {

/// Initialises libsodium. Call before any of its functions; repeated calls are allowed. Any thread.
bool beginSodium();

/// Returns two lower-case digits for each byte.
[[nodiscard]] std::string hexOf(const unsigned char* bytes, std::size_t count);

}  // namespace database
