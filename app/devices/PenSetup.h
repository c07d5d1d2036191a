// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/window/MainWindow.h"

namespace app {

/// Connects the card of the pen with the view of the tooth, and saves the pressure curve on this computer. Ui thread.
void connectPen(ui::window::MainWindow& window);

}  // namespace app
