// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

namespace database {

/// To be called before anything of libsodium's is used; it may be called again. Any thread.
bool beginSodium();

/// Two lower-case digits for each byte.
[[nodiscard]] std::string hexOf(const unsigned char* bytes, std::size_t count);

}  // namespace database
