// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QIcon>
#include <QPalette>
#include <QPixmap>
#include <QString>

namespace ui::kit {

/// Returns a line drawing (ui/assets/icons/<name>.svg) in the text colour of the palette, faint when disabled. Rendered
/// from vectors at every size and screen density. Null if there is no such drawing.
[[nodiscard]] QIcon lineIcon(const QString& name, const QPalette& palette);

/// Returns the same drawing in one colour, as a square of `sizePx`, for a label.
[[nodiscard]] QPixmap linePixmap(const QString& name, const QColor& colour, int sizePx, double devicePixelRatio);

}  // namespace ui::kit
