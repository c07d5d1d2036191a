// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSettings>
#include <QString>

namespace ui::kit {

/// What the window remembers from run to run: ~/.config/cusp/cusp.conf.
[[nodiscard]] QSettings memory();

/// A yes or no as it was kept. Only the words that are written there count, since to Qt any word is a yes; for all
/// else the answer is `otherwise`.
[[nodiscard]] bool recalled(const QSettings& kept, const QString& key, bool otherwise);

}  // namespace ui::kit
