// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/preparation/BlockPreparation.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "core/preparation/AxisRegion.h"
#include "core/teeth/ToothBuilder.h"

namespace core::preparation {
namespace {

using grading::Part;
using teeth::BlockDesign;
using teeth::BlockShape;

/// Tolerance, so that rounding does not decide whether a node on the edge of a shape belongs to it.
constexpr double kOnEdgeMm = 1.0e-9;

struct Pocket
{
    AxisRegion axis;
    double depthMm = 0.0;
};

/// Returns the pockets of a shape. A staircase has one pocket per step, each within the one before. Plunges have one
/// per pit. Every other shape has one.
std::vector<Pocket> pocketsOf(const BlockDesign& design)
{
    const double inside = 0.5 * design.widthMm - design.cornerRadiusMm;  // half the range of the bur's axis
    const double end = 0.5 * design.lengthMm - design.cornerRadiusMm;
    std::vector<Pocket> pockets{{{}, design.depthMm}};
    AxisRegion& axis = pockets.front().axis;
    const auto alongX = [&](double from, double to, double y) { axis.addBox({from, y - inside}, {to, y + inside}); };
    const auto alongY = [&](double from, double to, double x) { axis.addBox({x - inside, from}, {x + inside, to}); };
    switch (design.shape) {
    case BlockShape::Line:
        alongX(-end, end, 0.0);
        break;
    case BlockShape::Circle:
        axis.addRing({0.0, 0.0}, 0.5 * (design.lengthMm - design.widthMm), inside);
        break;
    case BlockShape::Cross:
        alongX(-end, end, 0.0);
        alongY(-end, end, 0.0);
        break;
    case BlockShape::Square:
        for (const double sign : {-1.0, 1.0}) {
            alongX(-end, end, sign * (end - inside));
            alongY(-end, end, sign * (end - inside));
        }
        break;
    case BlockShape::Dovetail: {
        alongX(-end, end, 0.0);
        const double neck = end - design.widthMm;
        const double wide = inside + design.flareMm;
        axis.addPolygon({{neck, -inside}, {end, -wide}, {end, wide}, {neck, inside}});
        axis.addPolygon({{-neck, inside}, {-end, wide}, {-end, -wide}, {-neck, -inside}});
        break;
    }
    case BlockShape::Staircase: {
        const auto steps = static_cast<int>(design.steps);
        pockets.clear();
        for (int step = 0; step < steps; ++step) {
            Pocket pocket{{}, design.depthMm * (step + 1) / steps};
            const double from = -end + step * design.lengthMm / steps;
            pocket.axis.addBox({from, -inside}, {end, inside});
            pockets.push_back(std::move(pocket));
        }
        break;
    }
    case BlockShape::Bar:
        alongX(-end, end, 0.0);
        for (const double sign : {-1.0, 1.0})
            alongY(-0.5 * end, 0.5 * end, sign * (end - inside));
        break;
    case BlockShape::Tee:
        alongY(-end, end, 0.0);
        alongX(-end, end, end - inside);
        break;
    case BlockShape::Layers:
        pockets.clear();
        break;
    case BlockShape::Plunges:
        pockets.clear();
        for (const teeth::Pit& pit : teeth::pitsOf(design)) {
            pockets.push_back({{}, pit.depthMm});
            pockets.back().axis.addRing({pit.xMm, 0.0}, 0.0, inside);
        }
        break;
    case BlockShape::Junction:
        alongX(-end, end, 0.0);
        break;
    }
    return pockets;
}

}  // namespace

Result<grading::Preparation> blockPreparation(const BlockDesign& design, const terrain::ToothAnatomy& anatomy)
{
    if (Status fits = teeth::validate(design); !fits)
        return tl::unexpected(std::move(fits).error());
    if (anatomy.name != teeth::blockName(design.shape))
        return unexpected(ErrorCode::UnknownName,
                          "the shape is for " + teeth::blockName(design.shape) + ", not for '" + anatomy.name + "'");
    const terrain::Grid& grid = anatomy.grid;
    std::vector<float> top = anatomy.top;
    std::vector<Part> parts(grid.count(), Part::Keep);
    const std::vector<Pocket> pockets = pocketsOf(design);
    const bool followsJunction = design.shape == BlockShape::Junction;
    for (int j = 0; j < grid.side; ++j) {
        for (int i = 0; i < grid.side; ++i) {
            const std::size_t k = grid.index(i, j);
            if (!(anatomy.top[k] > anatomy.bottom[k]))
                continue;
            for (const Pocket& pocket : pockets) {
                const double away = pocket.axis.distance(grid.nodeMm(i, j));
                if (away > design.cornerRadiusMm + kOnEdgeMm)
                    continue;
                const double rise = riseBeside(away, design.cornerRadiusMm, design.lineAngleMm);
                const double floor = followsJunction ? static_cast<double>(anatomy.layers[k].dej) : -pocket.depthMm;
                const auto height = static_cast<float>(rise + floor);
                if (height < top[k]) {
                    top[k] = height;
                    parts[k] = rise > 0.0 ? Part::Wall : Part::Floor;
                }
            }
        }
    }
    grading::Preparation ideal{std::make_shared<const std::vector<float>>(std::move(top)), std::move(parts), {}};
    if (design.shape == BlockShape::Line || design.shape == BlockShape::Dovetail)
        ideal.isthmus = grading::Preparation::Isthmus{
            {0.0, 0.0}, {0.0, 1.0}, 0.5 * design.lengthMm - 2.0 * design.widthMm > 0.5 ? 1.0 : 0.25};
    return ideal;
}

Result<Block> makeBlock(const BlockDesign& design, int gridSide, std::uint64_t seed)
{
    teeth::BuildOptions options;
    options.gridSide = gridSide;
    options.seed = seed;
    auto built = teeth::buildTooth({design}, options);
    if (!built)
        return tl::unexpected(std::move(built).error());
    auto ideal = blockPreparation(design, *built->anatomy);
    if (!ideal)
        return tl::unexpected(std::move(ideal).error());
    return Block{std::move(built->anatomy), std::move(*ideal)};
}

}  // namespace core::preparation
