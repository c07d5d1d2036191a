// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QIcon>
#include <QPalette>
#include <QPixmap>
#include <QString>

namespace ui::kit {

/// One of our line drawings (ui/assets/icons/<name>.svg) in the palette's word colour, faint when disabled. Drawn from
/// the vectors at every size and screen density. Null when there is no such drawing.
[[nodiscard]] QIcon lineIcon(const QString& name, const QPalette& palette);

/// The same in one colour, as a picture of side `sizePx` for a label.
[[nodiscard]] QPixmap linePixmap(const QString& name, const QColor& colour, int sizePx, double devicePixelRatio);

}  // namespace ui::kit
