// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace ui::tooth {

/// Input device with which the user presses the bur onto the tooth when no force device moves it.
enum class PointerKind : std::uint8_t { Mouse, Pen, Keyboard, Gamepad };

/// Returns the name that is stored with an attempt.
[[nodiscard]] constexpr const char* idOf(PointerKind kind)
{
    switch (kind) {
    case PointerKind::Pen:
        return "pen";
    case PointerKind::Keyboard:
        return "keyboard";
    case PointerKind::Gamepad:
        return "gamepad";
    case PointerKind::Mouse:
        break;
    }
    return "mouse";
}

}  // namespace ui::tooth
