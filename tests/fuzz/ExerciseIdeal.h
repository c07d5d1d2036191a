// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace fuzz {

/// Reads bytes as a captured ideal and, where they are one, shows it and marks by it. Aborts if what was promised does
/// not hold.
void exerciseIdeal(std::string_view bytes);

/// The same bytes with size and checksum set to match, so that a fuzzer gets behind them.
[[nodiscard]] std::string idealWithChecksum(std::string_view bytes);

/// The same bytes with what follows the header packed, and what is packed taken apart.
[[nodiscard]] std::string packedIdeal(std::string_view bytes);
[[nodiscard]] std::string unpackedIdeal(std::string_view bytes);

}  // namespace fuzz
