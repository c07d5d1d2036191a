// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace core::settings {

/// Returns whether a value is within limits; false for NaN.
[[nodiscard]] constexpr bool within(double value, double low, double high) noexcept
{
    return value >= low && value <= high;
}

}  // namespace core::settings
