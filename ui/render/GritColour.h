// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <QColor>

namespace ui::render {

/// Returns the colour of the ring on the shank of a diamond bur, which ISO 6360 defines for its grit. Empty for a
/// carbide bur and for an unknown number.
/// @param grit  as core::bur::Bur::grit
[[nodiscard]] inline std::optional<QColor> gritColour(int grit)
{
    switch (grit) {
    case 504:  // very fine
        return QColor(0xE8, 0xC2, 0x1A);
    case 514:  // fine
        return QColor(0xC8, 0x2A, 0x2A);
    case 524:  // medium
        return QColor(0x1F, 0x5F, 0xC4);
    case 534:  // coarse
        return QColor(0x1E, 0x8A, 0x3C);
    case 544:  // very coarse
        return QColor(0x10, 0x10, 0x12);
    default:
        return std::nullopt;
    }
}

}  // namespace ui::render
