// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>

namespace app::cli::bench {

/// The same picture in a quarter of the bytes: what QSvgGenerator writes of a graphics scene is mostly groups with
/// nothing in them and attributes that are so anyway.
/// @param svg     as QSvgGenerator writes it, with one font family throughout
/// @param family  of the fonts; who looks at the picture may not have it, so others are named behind it
[[nodiscard]] QByteArray compacted(const QByteArray& svg, const QString& family);

}  // namespace app::cli::bench
