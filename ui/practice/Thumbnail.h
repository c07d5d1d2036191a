// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>

#include <QImage>

#include "core/terrain/Tooth.h"

namespace ui::practice {

/// Colours of a small picture: materials in the order of core::terrain::Material, what is laid thinly over the cut, and
/// what is beside the tooth.
struct ThumbnailColours
{
    std::array<QRgb, core::terrain::kMaterialCount> materials{};
    QRgb cut = 0;
    QRgb beside = 0;
};

/// A tooth from above, its materials shaded by its slopes and tinted where it was cut: cheap, for lists. 16 bits a
/// pixel. Any thread.
/// @param top  the top map, row by row, mm, of the anatomy's grid
[[nodiscard]] QImage thumbnail(const core::terrain::ToothAnatomy& anatomy, std::span<const float> top, int sidePx,
                               const ThumbnailColours& colours);

}  // namespace ui::practice
