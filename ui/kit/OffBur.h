// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <QPointF>
#include <QRectF>

namespace ui::kit {

/// Radius of the circle around the bur that overlays leave free, pixels.
inline constexpr double kOffBurPx = 90.0;

/// Returns the usual place of an overlay if it leaves the circle around the bur free, or else the other place. If both
/// cover the circle, returns the one that is farther from the bur.
/// @param bur  empty: there is no bur to keep off
[[nodiscard]] QRectF placeOffBur(const std::optional<QPointF>& bur, const QRectF& usual, const QRectF& other);

}  // namespace ui::kit
