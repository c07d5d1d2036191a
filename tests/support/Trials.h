// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdlib>
#include <string_view>

/// How many of many like cases a test tries. The ordinary run tries a share of them, with the same assertions;
/// CUSP_NIGHTLY=1 tries all. With sanitizers a test takes many times as long and looks for misuse of memory and
/// undefined behaviour, for which the share does: there CUSP_NIGHTLY counts for nothing.
namespace support {

#ifdef CUSP_SANITIZED
inline constexpr bool kSanitized = true;
#else
inline constexpr bool kSanitized = false;
#endif

[[nodiscard]] inline bool isNightly()
{
    const char* set = kSanitized ? nullptr : std::getenv("CUSP_NIGHTLY");
    return set != nullptr && std::string_view(set) == "1";
}

[[nodiscard]] inline int trials(int quick, int nightly)
{
    return isNightly() ? nightly : quick;
}

/// Whether the n-th of many like cases is tried: each at night, else one in seven. Few sweeps have a side of seven, so
/// that what is tried lies all over them.
[[nodiscard]] inline bool isTried(int n)
{
    return isNightly() || n % 7 == 0;
}

}  // namespace support
