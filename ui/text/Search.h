// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

/// Text comparison for all searches of the program.
namespace ui::text {

/// Returns text in lower case, without accents and in normal character width, so that "linea" finds "Línea".
[[nodiscard]] QString plain(const QString& words);

/// Returns whether `all` contains `part`. An empty part is always contained.
[[nodiscard]] bool holds(const QString& all, const QString& part);
/// Returns whether `all` contains each of the words, which are separated by spaces.
[[nodiscard]] bool holdsEach(const QString& all, const QString& words);

}  // namespace ui::text
