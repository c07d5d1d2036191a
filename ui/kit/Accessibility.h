// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QWidget;

namespace ui::kit {

/// Has a screen reader say what a widget shows now, wherever the focus is. Ui thread.
///
/// Qt 6.4 sends this on to the reader on Windows and macOS, but not over AT-SPI. There a reader says the description of
/// the widget with the focus when that changes: give the words to the button that was pressed as well.
void announce(QWidget& widget);

}  // namespace ui::kit
