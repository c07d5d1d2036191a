// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

/// Text comparison for all searches of the program.
namespace ui::text {

/// Returns text without case, accents and character width, so that "linea" finds "Línea".
[[nodiscard]] QString plain(const QString& words);

/// Returns whether a part occurs in the whole. An empty part always does.
[[nodiscard]] bool holds(const QString& all, const QString& part);
/// Returns whether each of the words, separated by spaces, occurs.
[[nodiscard]] bool holdsEach(const QString& all, const QString& words);

}  // namespace ui::text
