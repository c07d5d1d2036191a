// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace ui::kit {

/// Where files of the user's own are looked for first: his documents, or his home where he has no such folder.
[[nodiscard]] QString documentsFolder();

}  // namespace ui::kit
