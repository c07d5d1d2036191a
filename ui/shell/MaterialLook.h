// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QBrush>
#include <QColor>

#include "core/terrain/Tooth.h"

namespace ui::shell {

/// Natural tooth colours, or four that everyone can tell apart, with patterns on what matters most (courseware.md,
/// section 5.1: colours of Okabe and Ito).
enum class MaterialPalette { Natural, ColourBlind };

/// How a material is painted on the screen's flat pictures.
struct MaterialLook
{
    QColor fill;
    QColor letter;                         ///< of its letter on that fill, and of the pattern
    Qt::BrushStyle pattern = Qt::NoBrush;  ///< over the fill
};

[[nodiscard]] MaterialLook materialLook(core::terrain::Material material,
                                        MaterialPalette palette = MaterialPalette::Natural);

}  // namespace ui::shell
