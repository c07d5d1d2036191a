// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include <QImage>

#include "core/imaging/Radiograph.h"

namespace ui::inside {

/// Pixel size of a displayed film, mm: smaller than half a cell of the usual grid.
inline constexpr double kFilmPixelMm = 0.05;

/// Returns whether a tooth belongs to the upper jaw. Its films are shown with the crown at the bottom, as in the mouth.
[[nodiscard]] bool isUpper(int fdi);

/// Returns a developed film in grey as a film scanner reads it: white where no radiation came through. As in film
/// scanners, grey is linear in optical density and not in transmitted light, in a window from 0.6 to the density of the
/// air beside the tooth (2.95 at most). It then looks as on a light box, which is ten times as bright as a screen. This
/// affects the display only; core::imaging computes the densities. The film of an upper tooth is flipped vertically;
/// mesial stays at the left. The exposure is relative to the usual one for the thickness of the first tooth. Needs no
/// window; any thread. Takes 30 to 100 ms at kFilmPixelMm, longest for a bitewing.
[[nodiscard]] QImage radiographPicture(std::span<const core::imaging::XrayedTooth> teeth,
                                       const core::imaging::Beam& beam, const core::imaging::FilmArea& area,
                                       double pixelMm, const core::imaging::Exposure& exposure);

}  // namespace ui::inside
