// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSettings>
#include <QString>

namespace ui::kit {

/// Returns the settings that are stored between runs (~/.config/cusp/cusp.conf on Linux).
[[nodiscard]] QSettings memory();

/// Returns a stored boolean. Any value except "true" and "false" counts as missing, because Qt converts every other
/// word to true.
/// @param otherwise  returned if the key is missing
[[nodiscard]] bool recalled(const QSettings& kept, const QString& key, bool otherwise);

}  // namespace ui::kit
