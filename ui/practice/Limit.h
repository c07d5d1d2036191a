// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <QColor>

namespace ui::practice {

/// Distances to tissue that must be preserved at which a bur counts as near, and as touching, mm.
inline constexpr double kNearLimitMm = 0.3;
inline constexpr double kAtLimitMm = 0.05;

/// Returns the colour of a bur at this distance from tissue that must be preserved. The three colours differ in
/// lightness as well as in hue.
/// @param marginMm  empty: no limit is near; the result is invalid and the bur has its steel colour
[[nodiscard]] inline QColor limitColour(const std::optional<double>& marginMm)
{
    if (!marginMm)
        return {};
    return *marginMm < kAtLimitMm     ? QColor(0xD8, 0x30, 0x20)
           : *marginMm < kNearLimitMm ? QColor(0xF2, 0xB0, 0x30)
                                      : QColor(0x2F, 0xA6, 0x9A);
}

}  // namespace ui::practice
