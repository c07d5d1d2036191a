// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/teeth/TissueFigures.h"

#include <algorithm>

namespace core::teeth {
namespace {

/// The extent and the number of the columns that are higher than a level, mm.
struct Outline
{
    double width = 0.0;
    double depth = 0.0;
    int columns = 0;
};

Outline outlineAbove(const terrain::Grid& grid, std::span<const float> top, double level)
{
    int lowI = grid.side;
    int highI = -1;
    int lowJ = grid.side;
    int highJ = -1;
    Outline outline;
    for (int j = 0; j < grid.side; ++j) {
        for (int i = 0; i < grid.side; ++i) {
            if (!(static_cast<double>(top[grid.index(i, j)]) > level))
                continue;
            lowI = std::min(lowI, i);
            highI = std::max(highI, i);
            lowJ = std::min(lowJ, j);
            highJ = std::max(highJ, j);
            ++outline.columns;
        }
    }
    outline.width = std::max(0, highI - lowI + 1) * grid.cellMm;
    outline.depth = std::max(0, highJ - lowJ + 1) * grid.cellMm;
    return outline;
}

/// Returns the number of a tooth of the table that is similar to this crown. The limits are half way between the means
/// of the table.
int guess(const terrain::Grid& grid, std::span<const float> top, double highest)
{
    const Outline crown = outlineAbove(grid, top, highest - 6.5);
    const Outline upper = outlineAbove(grid, top, highest - 3.0);
    // The section of a molar or a premolar near its top fills the outline; that of a front tooth does not.
    if (upper.columns > 0.75 * crown.columns) {
        if (crown.width * crown.depth >= 74.0)
            return crown.depth > crown.width ? 26 : 36;
        return crown.depth > 8.5 ? 25 : 35;
    }
    const Outline edge = outlineAbove(grid, top, highest - 1.0);
    if (edge.width < 0.6 * crown.width)
        return crown.width > 7.25 ? 23 : 33;
    return crown.width > 7.5 ? 21 : crown.width > 6.0 ? 22 : 31;
}

/// Returns the number of the same tooth on the left side. The table has only that side; the right side is its mirror
/// image.
int onTheLeft(int fdi)
{
    const int quadrant = fdi / 10;
    return (quadrant == 1 || quadrant == 2 ? 20 : quadrant == 3 || quadrant == 4 ? 30 : 0) + fdi % 10;
}

ToothKind kindOf(int fdi)
{
    switch (fdi % 10) {
    case 1:
    case 2:
        return ToothKind::Incisor;
    case 3:
        return ToothKind::Canine;
    case 4:
    case 5:
        return ToothKind::Premolar;
    default:
        return ToothKind::Molar;
    }
}

TissueFigures ofKind(ToothKind kind)
{
    TissueFigures figures;
    figures.kind = kind;
    switch (kind) {
    case ToothKind::Incisor:
    case ToothKind::Canine:
        figures.enamelPerHeight = kind == ToothKind::Incisor ? 0.13 : 0.16;
        figures.cuspEnamel = kind == ToothKind::Incisor ? 1.3 : 1.7;
        figures.edgeEnamel = kind == ToothKind::Incisor ? 2.0 : 0.0;
        figures.pulpWall = 2.2;
        figures.tipToHorn = 6.6;
        figures.hornHeight = 0.3;
        break;
    case ToothKind::Premolar:
        figures.enamelPerHeight = 0.265;
        figures.cuspEnamel = 2.3;
        figures.fossaEnamel = 1.25;
        figures.pulpWall = 1.9;
        figures.tipToHorn = 5.75;
        figures.hornHeight = 0.7;
        break;
    case ToothKind::Molar:
        figures.enamelPerHeight = 0.32;
        figures.cuspEnamel = 2.45;
        figures.fossaEnamel = 1.75;
        figures.pulpWall = 2.3;
        figures.tipToHorn = 6.1;
        figures.hornHeight = 1.0;
        figures.fossaToPulp = 4.7;
        figures.chamberHeight = 1.75;
        break;
    }
    figures.mesialWall = figures.pulpWall;
    figures.distalWall = figures.pulpWall;
    return figures;
}

}  // namespace

TissueFigures figuresFor(int fdi, const terrain::Grid& grid, std::span<const float> top)
{
    const auto highest = static_cast<double>(*std::max_element(top.begin(), top.end()));
    auto sizes = findToothSizes(onTheLeft(fdi));
    if (!sizes)
        sizes = findToothSizes(guess(grid, top, highest));
    TissueFigures figures = ofKind(kindOf(sizes->fdi));
    figures.sizes = *sizes;
    // The chamber of a lower molar is in the mesial part of the crown, over two mesial canals.
    if (sizes->fdi == 36) {
        figures.mesialWall = 1.5;
        figures.distalWall = 2.5;
        figures.pulpTaperDeg = 8.0;
    }
    if (sizes->fdi == 36 || sizes->fdi == 37)
        figures.mesialCanals = 2;

    // A crown that is wider than the mean is also higher. The outline is taken high, because a root that is wider than
    // the crown must not count.
    const Outline crown = outlineAbove(grid, top, highest - 0.7 * sizes->crownHeightMm);
    const double size = (crown.width + crown.depth) / (sizes->crownWidthMm + sizes->crownDepthMm);
    figures.crownHeight = sizes->crownHeightMm * std::clamp(size, 0.8, 1.25);
    return figures;
}

}  // namespace core::teeth
