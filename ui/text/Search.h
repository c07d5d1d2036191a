// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

/// How every search of the program compares words.
namespace ui::text {

/// As searches see it: without case, accents and the width of letters, so that "linea" finds "Línea".
[[nodiscard]] QString plain(const QString& words);

/// Whether a part occurs somewhere in all. Nothing occurs everywhere.
[[nodiscard]] bool holds(const QString& all, const QString& part);
/// Whether each of the words, parted by spaces, does.
[[nodiscard]] bool holdsEach(const QString& all, const QString& words);

}  // namespace ui::text
