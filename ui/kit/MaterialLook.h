// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QBrush>
#include <QColor>

#include "core/terrain/Tooth.h"
#include "ui/render/Look.h"

namespace ui::kit {

/// The look of a material in flat pictures: distinct colours after Okabe and Ito, and a pattern for the materials that
/// matter most.
struct MaterialLook
{
    QColor fill;
    QColor letter;                         ///< colour of the material's letter on that fill, and of the pattern
    Qt::BrushStyle pattern = Qt::NoBrush;  ///< over the fill
};

[[nodiscard]] MaterialLook materialLook(core::terrain::Material material,
                                        render::Palette palette = render::Palette::Natural);

}  // namespace ui::kit
