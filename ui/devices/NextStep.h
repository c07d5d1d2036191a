// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QPushButton;

namespace ui::devices {

/// Fills a button, or empties it: the filled one of a page is its next step.
void setFilled(QPushButton& button, bool isFilled);

}  // namespace ui::devices
