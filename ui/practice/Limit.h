// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <QColor>

namespace ui::practice {

/// Nearer than this to what is to be kept the bur is told to be near, and at it, mm.
inline constexpr double kNearLimitMm = 0.3;
inline constexpr double kAtLimitMm = 0.05;

/// The colour of a bur that is so far from what is to be kept; steel (no colour) where nothing is near. The three
/// differ in lightness as well as in hue.
[[nodiscard]] inline QColor limitColour(const std::optional<double>& marginMm)
{
    if (!marginMm)
        return {};
    return *marginMm < kAtLimitMm     ? QColor(0xD8, 0x30, 0x20)
           : *marginMm < kNearLimitMm ? QColor(0xF2, 0xB0, 0x30)
                                      : QColor(0x2F, 0xA6, 0x9A);
}

}  // namespace ui::practice
