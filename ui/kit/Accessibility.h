// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QWidget;

namespace ui::kit {

/// Announces a widget's name and description to a screen reader, wherever the focus is. Ui thread.
///
/// Qt 6.4 forwards this to the reader on Windows and macOS, but not over AT-SPI. There a reader speaks the description
/// of the focused widget when that changes: also set the text as the description of the button that was pressed.
void announce(QWidget& widget);

}  // namespace ui::kit
