// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QPushButton;

namespace ui::devices {

/// Sets whether a button is filled. The filled button of a page is the recommended next step.
void setFilled(QPushButton& button, bool isFilled);

}  // namespace ui::devices
