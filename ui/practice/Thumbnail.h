// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>

#include <QImage>

#include "core/terrain/Tooth.h"

namespace ui::practice {

/// Colours of a small picture: one for each core::terrain::Material, the tint of cut surfaces, and the background.
struct ThumbnailColours
{
    std::array<QRgb, core::terrain::kMaterialCount> materials{};
    QRgb cut = 0;
    QRgb beside = 0;
};

/// Draws a tooth from above, shaded by slope and tinted where it was cut. It is fast enough for lists, and the image
/// has 16 bits per pixel. Any thread.
/// @param top  top map on the anatomy's grid, row by row, mm
[[nodiscard]] QImage thumbnail(const core::terrain::ToothAnatomy& anatomy, std::span<const float> top, int sidePx,
                               const ThumbnailColours& colours);

}  // namespace ui::practice
