// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdlib>
#include <string_view>

/// The number of similar cases that a test tries. The usual run tries a share of them with the same assertions;
/// CUSP_NIGHTLY=1 tries all. With sanitizers a test takes many times as long, and the share is enough to find memory
/// errors and undefined behaviour; CUSP_NIGHTLY then has no effect.
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

/// Returns whether the n-th of many similar cases is tried: each at night, otherwise one in seven. Few sweeps have a
/// side of seven, so the tried cases are spread over all of them.
[[nodiscard]] inline bool isTried(int n)
{
    return isNightly() || n % 7 == 0;
}

}  // namespace support
