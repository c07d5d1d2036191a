// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "ui/window/MainWindow.h"

namespace app {

/// Returns whether the page that is open now is still open when the result is called: an answer does not take the user
/// away from another page that they have opened meanwhile.
[[nodiscard]] inline std::function<bool()> pageStaysOpen(const ui::window::MainWindow& window)
{
    return [&window, page = window.page()] { return window.page() == page; };
}

}  // namespace app
