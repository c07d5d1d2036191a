// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/imaging/Bitewing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "core/teeth/ToothBuilder.h"

namespace core::imaging {
namespace {

using terrain::Grid;
using terrain::ToothAnatomy;

constexpr double kFilmWidthMm = 41.0;
constexpr double kOverTipsMm = 2.0;
constexpr double kUnderTipsMm = 13.5;
/// Distance between the rows on which two outlines are compared.
constexpr double kRowMm = 0.05;

/// Returns where the outline of a tooth ends on the row at y towards +x (side 1) or -x (side -1). If the row has no
/// tooth, it is -infinity times the side.
double edgeMm(const ToothAnatomy& anatomy, bool mirrored, double y, int side)
{
    const Grid& grid = anatomy.grid;
    const int j = static_cast<int>(std::floor(grid.latticeOf({0.0, y}).y + 0.5));
    double edge = -std::numeric_limits<double>::infinity();
    if (j < 0 || j >= grid.side)
        return edge * side;
    for (int i = 0; i < grid.side; ++i) {
        const std::size_t k = grid.index(i, j);
        if (anatomy.top[k] > anatomy.bottom[k])
            edge = std::max(edge, side * (mirrored ? -1.0 : 1.0) * grid.nodeMm(i, j).x + 0.5 * grid.cellMm);
    }
    return edge * side;
}

/// Returns how far the distal one of two teeth is from the mesial one along x when their outlines touch.
double contactMm(const ToothAnatomy& mesial, bool mesialMirrored, const ToothAnatomy& distal, bool distalMirrored)
{
    const double reach = 0.5 * mesial.grid.cellMm * mesial.grid.side;
    double apart = 0.0;
    for (double y = -reach; y <= reach; y += kRowMm) {
        const double right = edgeMm(mesial, mesialMirrored, y, 1);
        const double left = edgeMm(distal, distalMirrored, y, -1);
        if (std::isfinite(right) && std::isfinite(left))
            apart = std::max(apart, right - left);
    }
    return apart;
}

}  // namespace

Result<std::vector<Neighbour>> neighboursOf(const ToothAnatomy& anatomy)
{
    if (!anatomy.lying.isUpright())
        return unexpected(ErrorCode::OutOfRange,
                          "A tooth that lies on a side has no neighbours; let it lie with its occlusal side up.");
    if (!teeth::isGenerated(anatomy))
        return unexpected(ErrorCode::UnknownName,
                          "The neighbours of '" + anatomy.name + "' are not known; choose a tooth by its FDI number.");
    std::vector<Neighbour> neighbours;
    const auto add = [&](int fdi, bool mirrored, bool mesial) -> Status {
        teeth::BuildOptions options;
        options.gridSide = terrain::kDefaultGridSide;
        options.seed = anatomy.seed;
        options.caries.reset();
        const auto built = teeth::buildTooth({fdi}, options);
        if (!built)
            return tl::unexpected(built.error());
        const double x = mesial ? -contactMm(*built->anatomy, mirrored, anatomy, false)
                                : contactMm(anatomy, false, *built->anatomy, mirrored);
        neighbours.push_back({terrain::Tooth(built->anatomy), {x, 0.0, 0.0}, mirrored});
        return {};
    };
    const int place = anatomy.fdi % 10;
    if (const auto mesial = add(place == 1 ? anatomy.fdi : anatomy.fdi - 1, place == 1, true); !mesial)
        return tl::unexpected(mesial.error());
    if (place < 8)
        if (const auto distal = add(anatomy.fdi + 1, false, false); !distal)
            return tl::unexpected(distal.error());
    return neighbours;
}

FilmArea bitewingArea(std::span<const XrayedTooth> teeth, const Beam& beam)
{
    FilmArea area = shadowArea(teeth, beam, 1.0);
    const double middle = 0.5 * (area.lowMm.x + area.highMm.x);
    area.lowMm.x = std::max(area.lowMm.x, middle - 0.5 * kFilmWidthMm);
    area.highMm.x = std::min(area.highMm.x, middle + 0.5 * kFilmWidthMm);
    area.lowMm.y = std::max(area.lowMm.y, -kUnderTipsMm * std::cos(beam.tiltRad));
    area.highMm.y = std::max(area.highMm.y, kOverTipsMm);
    return area;
}

}  // namespace core::imaging
