// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include <QImage>

#include "core/imaging/Radiograph.h"

namespace ui::inside {

/// Pixel size of a displayed film: smaller than half a cell of the usual grid.
inline constexpr double kFilmPixelMm = 0.05;

/// Returns whether a tooth belongs to the upper jaw. Its films are shown crown down, as its crown points in the mouth.
[[nodiscard]] bool isUpper(int fdi);

/// Returns a developed film as a film scanner reads it, in grey: white where no radiation came through. The grey of the
/// screen is linear in optical density, in a window from 0.6 to that of the air beside the tooth (2.95 at most), and
/// not in transmitted light: film scanners do this, and it looks like a light box, which is ten times as bright as a
/// screen. This affects the display only; core::imaging computes the densities. The film of an upper tooth is flipped
/// vertically, mesial stays at the left. The exposure is relative to the usual one for the thickness of the first
/// tooth. Needs no window; any thread. Takes 30 to 100 ms at kFilmPixelMm, longest for a bitewing.
[[nodiscard]] QImage radiographPicture(std::span<const core::imaging::XrayedTooth> teeth,
                                       const core::imaging::Beam& beam, const core::imaging::FilmArea& area,
                                       double pixelMm, const core::imaging::Exposure& exposure);

}  // namespace ui::inside
