// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace ui::kit {

/// Returns the user's documents folder, or the home folder if there is none.
[[nodiscard]] QString documentsFolder();

}  // namespace ui::kit
