// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// With sanitizers a test takes many times as long. It looks for misuse of memory and undefined behaviour there, for
/// which a few of many like cases do; the figures are those of the release build, with all cases.
namespace support {

#ifdef CUSP_SANITIZED
inline constexpr bool kSanitized = true;
#else
inline constexpr bool kSanitized = false;
#endif

/// Whether the n-th of many like cases is tried.
[[nodiscard]] constexpr bool isTried(int n)
{
    return !kSanitized || n % 8 == 0;
}

}  // namespace support
