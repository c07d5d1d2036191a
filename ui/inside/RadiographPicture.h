// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include <QImage>

#include "core/imaging/Radiograph.h"

namespace ui::inside {

/// Pixels of a film as it is shown: finer than half a cell of the usual grid.
inline constexpr double kFilmPixelMm = 0.05;

/// Whether a tooth is of the upper jaw: its films hang crown down, as its crown points in the mouth.
[[nodiscard]] bool isUpper(int fdi);

/// A developed film as a film scanner reads it, in grey: white where no radiation came through. The grey of the screen
/// is linear in optical density, within a window from 0.6 to that of the air beside the tooth (2.95 at most), and not
/// in the light that passes: that is how scanners give films, and how they look on a light box, which is ten times as
/// bright as a screen. Only what is shown is chosen here; the densities are core::imaging's. The film of an upper tooth
/// is turned over, mesial stays at the left. The exposure is relative to what is usual for the thickness of the first
/// tooth. Needs no window and may be called on any thread; 30 to 100 ms at kFilmPixelMm, the longest for a bitewing.
[[nodiscard]] QImage radiographPicture(std::span<const core::imaging::XrayedTooth> teeth,
                                       const core::imaging::Beam& beam, const core::imaging::FilmArea& area,
                                       double pixelMm, const core::imaging::Exposure& exposure);

}  // namespace ui::inside
