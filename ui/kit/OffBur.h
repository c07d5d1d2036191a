// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <QPointF>
#include <QRectF>

namespace ui::kit {

/// Radius of the circle around the bur that overlays do not cover, pixels.
inline constexpr double kOffBurPx = 90.0;

/// Returns the usual place of an overlay if it does not cover the circle around the bur, otherwise the other place. If
/// both cover the circle, returns the one farther from the bur.
/// @param bur  position of the bur; empty: there is none
[[nodiscard]] QRectF placeOffBur(const std::optional<QPointF>& bur, const QRectF& usual, const QRectF& other);

}  // namespace ui::kit
