// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

class QWidget;

/// Makes the arrows and the A button of a gamepad work in the window like Tab, the arrow keys and the space bar.
namespace ui::window {

enum class PadArrow : std::uint8_t { Up, Down, Left, Right };

/// Goes to the next or previous control; inside a list, a menu that is open, or a group of which one is chosen, to the
/// next entry. Left and right change a slider, a number or a choice.
/// @param window  where the first control is looked for if none has the focus
void stepByPad(QWidget& window, PadArrow arrow);

/// Presses the control that has the focus.
void chooseByPad();

/// Closes an open menu or list, or answers a question with "stay", like Esc. Returns false if there is neither.
bool closeByPad();

}  // namespace ui::window
