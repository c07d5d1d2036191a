// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

class QWidget;

/// Lets the arrows and buttons of a gamepad act in the window like Tab, the arrow keys, the space bar and Esc.
namespace ui::window {

enum class PadArrow : std::uint8_t { Up, Down, Left, Right };

/// Moves the focus to the next or previous control. In a list, an open menu, or a group of exclusive buttons, moves to
/// the next or previous entry. Left and right change the value of a slider, a spin box or a combo box.
/// @param window  its first control gets the focus if no control has it
void stepByPad(QWidget& window, PadArrow arrow);

/// Presses the control that has the focus.
void chooseByPad();

/// Closes an open menu or list, or cancels an open question, like Esc. Returns false if there is neither.
bool closeByPad();

}  // namespace ui::window
