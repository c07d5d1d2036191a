// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <string_view>

#include <QtGlobal>

#include "core/base/Result.h"

/// Checks that print the actual value when they fail.
namespace support {

inline constexpr double kPi = 3.14159265358979323846;  // moc of Qt 6.4 cannot parse <numbers>
inline constexpr double kDegree = kPi / 180.0;

[[nodiscard]] inline bool near(double actual, double expected, double tolerance = 1.0e-9)
{
    const bool isNear = std::abs(actual - expected) <= tolerance;
    if (!isNear)
        qWarning("%.9g is not %.9g", actual, expected);
    return isNear;
}

[[nodiscard]] inline bool between(double value, double low, double high)
{
    const bool isBetween = value > low && value < high;
    if (!isBetween)
        qWarning("%.9g is not between %.9g and %.9g", value, low, high);
    return isBetween;
}

/// Returns whether a result is no error; otherwise prints the error.
template <class T>
[[nodiscard]] bool succeeds(const core::Result<T>& result)
{
    if (!result)
        qWarning("%s", result.error().detail.c_str());
    return result.has_value();
}

/// Returns whether a result is an error with this code.
template <class T>
[[nodiscard]] bool isRefused(const core::Result<T>& result, core::ErrorCode code)
{
    const bool is = !result && result.error().code == code;
    if (!is)
        qWarning("%s", result ? "it was not refused" : result.error().detail.c_str());
    return is;
}

/// Returns whether a result is an error whose sentence contains these words.
template <class T>
[[nodiscard]] bool isRefused(const core::Result<T>& result, std::string_view words)
{
    const bool is = !result && result.error().detail.find(words) != std::string::npos;
    if (!is)
        qWarning("%s", result ? "it was not refused" : result.error().detail.c_str());
    return is;
}

}  // namespace support
