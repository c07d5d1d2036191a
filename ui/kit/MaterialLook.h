// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QBrush>
#include <QColor>

#include "core/terrain/Tooth.h"
#include "ui/render/Look.h"

namespace ui::kit {

/// How a material is painted on the screen's flat pictures: distinct colours after Okabe and Ito, with patterns on what
/// matters most.
struct MaterialLook
{
    QColor fill;
    QColor letter;                         ///< of its letter on that fill, and of the pattern
    Qt::BrushStyle pattern = Qt::NoBrush;  ///< over the fill
};

[[nodiscard]] MaterialLook materialLook(core::terrain::Material material,
                                        render::Palette palette = render::Palette::Natural);

}  // namespace ui::kit
