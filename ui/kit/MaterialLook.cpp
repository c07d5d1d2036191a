// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/MaterialLook.h"

#include <array>

namespace ui::kit {
namespace {

struct Look
{
    QRgb fill;
    QRgb letter;
    Qt::BrushStyle pattern;
};

/// In the order of core::terrain::Material: decay, enamel, dentin, pulp.
constexpr std::array<Look, core::terrain::kMaterialCount> kNatural{{{0xFF5B3A1E, 0xFFFFFFFF, Qt::NoBrush},
                                                                    {0xFFF2ECDF, 0xFF1A2223, Qt::NoBrush},
                                                                    {0xFFE2B964, 0xFF1A2223, Qt::NoBrush},
                                                                    {0xFFC75A62, 0xFFFFFFFF, Qt::NoBrush}}};
constexpr std::array<Look, core::terrain::kMaterialCount> kColourBlind{{{0xFF0072B2, 0xFFFFFFFF, Qt::BDiagPattern},
                                                                        {0xFFF0E442, 0xFF1A2223, Qt::NoBrush},
                                                                        {0xFFE69F00, 0xFF1A2223, Qt::FDiagPattern},
                                                                        {0xFFCC79A7, 0xFF1A2223, Qt::Dense6Pattern}}};

}  // namespace

MaterialLook materialLook(core::terrain::Material material, render::Palette palette)
{
    const Look& look =
        (palette == render::Palette::Natural ? kNatural : kColourBlind).at(static_cast<std::size_t>(material));
    return {QColor(look.fill), QColor(look.letter), look.pattern};
}

}  // namespace ui::kit
