// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/preparation/AccessOpening.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/bur/Reach.h"
#include "core/preparation/AxisRegion.h"
#include "core/teeth/Laid.h"
#include "core/teeth/LesionSite.h"
#include "core/teeth/ToothGenerator.h"
#include "core/teeth/ToothTable.h"

namespace core::preparation {
namespace {

using grading::Part;

/// Greatest depth of the chamber's roof below the highest horn. A deeper part of the pulp is a canal.
constexpr double kChamberMm = 3.5;
/// Distance between the opening and the edge of an incisor: 1 mm of dentin and the enamel behind the edge.
constexpr double kEdgeMm = 0.9;

/// Convex hull of points, counter-clockwise (Andrew's monotone chain).
std::vector<glm::dvec2> hullOf(std::vector<glm::dvec2> points)
{
    std::sort(points.begin(), points.end(),
              [](glm::dvec2 a, glm::dvec2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
    std::vector<glm::dvec2> hull;
    const auto turnsRight = [&hull](glm::dvec2 p) {
        const glm::dvec2 a = hull[hull.size() - 2];
        const glm::dvec2 b = hull[hull.size() - 1];
        return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x) <= 0.0;
    };
    for (const bool back : {false, true}) {
        const std::size_t begin = hull.size() + 1;
        for (const glm::dvec2& p : points) {
            while (hull.size() > begin && turnsRight(p))
                hull.pop_back();
            hull.push_back(p);
        }
        hull.pop_back();
        if (!back)
            std::reverse(points.begin(), points.end());
    }
    return hull;
}

/// A side of a polygon: all points p with dot(p, out) <= far are on its inner side.
struct Side
{
    glm::dvec2 out{1.0, 0.0};
    double far = 0.0;
};

Side supportOf(const std::vector<glm::dvec2>& hull, glm::dvec2 out)
{
    Side side{glm::normalize(out), -std::numeric_limits<double>::max()};
    for (const glm::dvec2& p : hull)
        side.far = std::max(side.far, glm::dot(p, side.out));
    return side;
}

/// Returns the corners of the polygon enclosed by the sides, which are in counter-clockwise order.
std::vector<glm::dvec2> cornersOf(const std::vector<Side>& sides)
{
    std::vector<glm::dvec2> corners;
    for (std::size_t k = 0; k < sides.size(); ++k) {
        const Side& a = sides[k];
        const Side& b = sides[(k + 1) % sides.size()];
        const double det = a.out.x * b.out.y - a.out.y * b.out.x;
        corners.emplace_back((a.far * b.out.y - b.far * a.out.y) / det, (a.out.x * b.far - b.out.x * a.far) / det);
    }
    return corners;
}

/// Returns the area of a convex polygon, mm2.
double areaOf(const std::vector<glm::dvec2>& corners)
{
    double doubled = 0.0;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const glm::dvec2 a = corners[k];
        const glm::dvec2 b = corners[(k + 1) % corners.size()];
        doubled += a.x * b.y - a.y * b.x;
    }
    return 0.5 * doubled;
}

/// Returns the smallest trapezoid around the chamber of a lower molar. Its longer parallel side is mesial, over two
/// canals, and its buccal and lingual sides converge distally.
std::vector<glm::dvec2> trapezoidAround(const std::vector<glm::dvec2>& hull)
{
    std::vector<glm::dvec2> best;
    for (int lean = -20; lean <= -4; lean += 2)
        for (int turn = -12; turn <= 12; turn += 2) {
            const double radian = std::numbers::pi / 180.0;
            const auto towards = [radian](double degrees) {
                return glm::dvec2{std::cos(degrees * radian), std::sin(degrees * radian)};
            };
            const std::vector<glm::dvec2> corners =
                cornersOf({supportOf(hull, towards(turn)), supportOf(hull, towards(90.0 + turn + lean)),
                           supportOf(hull, towards(180.0 + turn)), supportOf(hull, towards(270.0 + turn - lean))});
            if (best.empty() || areaOf(corners) < areaOf(best))
                best = corners;
        }
    return best;
}

/// Returns the smallest triangle around the chamber, with its base along the incisal edge and its tip towards the
/// cingulum.
/// @param lingual  -1 or 1: sign of y on the lingual side
/// @param isBlunt  whether the shape ends where the chamber ends, instead of at the tip
std::vector<glm::dvec2> triangleAround(const std::vector<glm::dvec2>& hull, double lingual, bool isBlunt)
{
    std::vector<glm::dvec2> best;
    const double radian = std::numbers::pi / 180.0;
    for (int left = 15; left <= 50; left += 1)
        for (int right = 15; right <= 50; right += 1) {
            const Side base = supportOf(hull, {0.0, -lingual});
            const Side mesial = supportOf(hull, {-std::cos(left * radian), lingual * std::sin(left * radian)});
            const Side distal = supportOf(hull, {std::cos(right * radian), lingual * std::sin(right * radian)});
            std::vector<Side> sides{base, mesial, distal};
            if (isBlunt)
                sides.insert(sides.begin() + 2, supportOf(hull, {0.0, lingual}));
            if (lingual > 0.0)
                std::reverse(sides.begin() + 1, sides.end());
            const std::vector<glm::dvec2> corners = cornersOf(sides);
            if (best.empty() || areaOf(corners) < areaOf(best))
                best = corners;
        }
    return best;
}

/// Returns a polygon that is smaller on all sides. If the axis of a bur stays in it, the side of the bur stays in the
/// larger polygon.
std::vector<glm::dvec2> shrunk(const std::vector<glm::dvec2>& corners, double byMm)
{
    std::vector<Side> sides;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const glm::dvec2 along = corners[(k + 1) % corners.size()] - corners[k];
        const glm::dvec2 out = glm::normalize(glm::dvec2{along.y, -along.x});
        sides.push_back({out, glm::dot(out, corners[k]) - byMm});
    }
    return cornersOf(sides);
}

/// Returns the region of the bur's axis for which its side follows a polygon with the margin. A bur rounds the corners
/// of the polygon. If a molar's chamber extends into a corner, the margin is widened until the bur removes that part.
AxisRegion axisAround(const std::vector<glm::dvec2>& around, const std::vector<glm::dvec2>& chamber,
                      const ToothDesign& design)
{
    constexpr double kStepMm = 0.02;
    for (double margin = design.accessMarginMm;; margin += kStepMm) {
        AxisRegion axis;
        axis.addPolygon(shrunk(around, design.burRadiusMm - margin));
        const bool takesAll = std::all_of(chamber.begin(), chamber.end(),
                                          [&](const glm::dvec2& p) { return axis.distance(p) <= design.burRadiusMm; });
        if (takesAll || margin >= design.burRadiusMm)
            return axis;
    }
}

/// Returns 0 straight in front of the axis region, on its labial side, and up to 1 beside and behind it.
double awayFromLabial(const AxisRegion& axis, glm::dvec2 point, double lingual)
{
    constexpr double kStepMm = 1.0e-3;
    const glm::dvec2 out{axis.distance({point.x + kStepMm, point.y}) - axis.distance({point.x - kStepMm, point.y}),
                         axis.distance({point.x, point.y + kStepMm}) - axis.distance({point.x, point.y - kStepMm})};
    const double labial = -lingual * out.y / std::max(1.0e-9, std::sqrt(glm::dot(out, out)));
    const double t = std::clamp(1.0 - labial, 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// Returns the height of the highest place of the pulp, mm.
double highestPulpMm(const terrain::ToothAnatomy& anatomy)
{
    double highest = -std::numeric_limits<double>::max();
    for (std::size_t k = 0; k < anatomy.grid.count(); ++k)
        if (terrain::hasPulp(anatomy, k))
            highest = std::max(highest, static_cast<double>(anatomy.layers[k].pulpRoof));
    return highest;
}

/// Returns y of the incisal edge of an upright incisor: the mean of the y of the highest place in all rows along y.
double edgeOf(const terrain::ToothAnatomy& anatomy)
{
    const terrain::Grid& grid = anatomy.grid;
    double edgeY = 0.0;
    double edges = 0.0;
    for (int i = 0; i < grid.side; ++i) {
        std::size_t best = grid.index(i, 0);
        for (int j = 0; j < grid.side; ++j)
            if (anatomy.top[grid.index(i, j)] > anatomy.top[best])
                best = grid.index(i, j);
        if (static_cast<double>(anatomy.top[best]) > -1.0) {
            edgeY += grid.nodeMm(i, static_cast<int>(best / static_cast<std::size_t>(grid.side))).y;
            edges += 1.0;
        }
    }
    return edgeY / edges;
}

/// Returns the position of the neck along the axis of a tooth that lies on a side, mm in the frame in which it is cut.
double neckAlongAxis(const terrain::ToothAnatomy& anatomy)
{
    const glm::dvec3 axis = anatomy.lying.cutFromOwn() * glm::dvec3(0.0, 0.0, 1.0);
    double tip = -std::numeric_limits<double>::max();
    for (std::size_t k = 0; k < anatomy.grid.count(); ++k)
        if (anatomy.top[k] > anatomy.bottom[k])
            tip = std::max(tip, glm::dot(axis, glm::dvec3(anatomy.grid.nodeMm(k), anatomy.top[k])));
    const auto sizes = teeth::drawToothSizes(anatomy.fdi, anatomy.seed);
    return tip - (sizes ? sizes->crownHeightMm : 0.0);
}

/// Places of a pulp chamber and, in the same order, the heights of its floor there, mm.
struct Chamber
{
    std::vector<glm::dvec2> places;
    std::vector<double> floors;
};

/// @param highest  highestPulpMm()
Chamber chamberOf(const terrain::ToothAnatomy& anatomy, double highest)
{
    const terrain::Grid& grid = anatomy.grid;
    const bool isMolar = anatomy.fdi % 10 >= 6;
    const double lingual = -teeth::buccalSign(anatomy.fdi);
    const bool fromLingual = opensFromLingual(anatomy.lying, anatomy.fdi);
    const double frontMm =
        isMolar || fromLingual ? std::numeric_limits<double>::lowest() : edgeOf(anatomy) * lingual + kEdgeMm;
    const double neck = fromLingual ? neckAlongAxis(anatomy) : 0.0;
    const glm::dvec3 axis = anatomy.lying.cutFromOwn() * glm::dvec3(0.0, 0.0, 1.0);
    const auto isChamber = [&](std::size_t k, glm::dvec2 at) {
        const auto roof = static_cast<double>(anatomy.layers[k].pulpRoof);
        return fromLingual ? glm::dot(axis, glm::dvec3(at, roof)) >= neck
                           : roof >= highest - kChamberMm && at.y * lingual >= frontMm;
    };

    Chamber chamber;
    for (int j = 0; j < grid.side; ++j)
        for (int i = 0; i < grid.side; ++i) {
            const std::size_t k = grid.index(i, j);
            const glm::dvec2 at = grid.nodeMm(i, j);
            if (!terrain::hasPulp(anatomy, k) || !isChamber(k, at))
                continue;
            chamber.places.push_back(at);
            chamber.floors.push_back(static_cast<double>(anatomy.layers[k].pulpFloor));
        }
    return chamber;
}

}  // namespace

bool opensFromLingual(const terrain::Lying& lying, int fdi)
{
    return fdi % 10 <= 3 && lying.tiltDeg > teeth::kSideTiltDeg && teeth::nameOf(lying, fdi) == "lingual";
}

Result<grading::Preparation> accessOpening(const ToothDesign& design, const terrain::ToothAnatomy& anatomy)
{
    const terrain::Grid& grid = anatomy.grid;
    const bool isMolar = anatomy.fdi % 10 >= 6;
    const double lingual = -teeth::buccalSign(anatomy.fdi);
    const bool fromLingual = opensFromLingual(anatomy.lying, anatomy.fdi);
    const double highest = highestPulpMm(anatomy);
    auto [chamber, floors] = chamberOf(anatomy, highest);
    if (chamber.size() < 8)
        return unexpected(
            ErrorCode::BadStructure,
            LocalizableText{"tooth %1 has no pulp chamber that could be opened from above", {noted(anatomy.name)}});
    // Half of a molar's chamber has one floor, whichever canals begin there. The same is true of a chamber seen from
    // the side, whose floor is its labial wall. A chamber seen from the incisal edge has no floor: it is opened down to
    // the place where its horns join.
    std::nth_element(floors.begin(), floors.begin() + static_cast<std::ptrdiff_t>(floors.size() / 2), floors.end());
    const double chamberMm = isMolar || fromLingual ? floors[floors.size() / 2] : highest - kChamberMm;
    // The ideal must not be deeper than a bur can reach.
    const double floorMm = std::max(chamberMm, bur::lowestTipMm(anatomy));

    const std::vector<glm::dvec2> hull = hullOf(std::move(chamber));
    const std::vector<glm::dvec2> around = isMolar ? trapezoidAround(hull) : triangleAround(hull, lingual, fromLingual);
    const double radius = design.burRadiusMm;
    const AxisRegion region = axisAround(around, hull, design);
    const double tangent = std::tan(std::max(0.5, design.accessLeanDeg) * std::numbers::pi / 180.0);
    std::vector<float> top = anatomy.top;
    std::vector<Part> parts(grid.count(), Part::Keep);
    for (int j = 0; j < grid.side; ++j)
        for (int i = 0; i < grid.side; ++i) {
            const std::size_t k = grid.index(i, j);
            if (!(anatomy.top[k] > anatomy.bottom[k]))
                continue;
            const double away = region.distance(grid.nodeMm(i, j));
            // The floor of the chamber must not be touched, so within the opening the ideal ends where the pulp does.
            const bool overPulp = terrain::hasPulp(anatomy, k);
            double height = floorMm;
            bool wall = false;
            if (away > radius) {
                // The labial wall of an incisor is vertical, because a leaning one would remove the edge.
                const double share = isMolar ? 1.0 : awayFromLabial(region, grid.nodeMm(i, j), lingual);
                if (share <= 0.0)
                    continue;
                height = floorMm + (away - radius) / (share * tangent);
                wall = true;
            } else if (!overPulp) {
                // Beside the chamber, within the trapezoid, the ideal goes down to the start of the chamber's wall.
                height = floorMm;
                wall = true;
            }
            if (overPulp && height < static_cast<double>(anatomy.layers[k].pulpRoof)) {
                height = std::max(height, static_cast<double>(anatomy.layers[k].pulpFloor));
                wall = wall && height > static_cast<double>(anatomy.layers[k].pulpFloor);
            }
            const auto level = static_cast<float>(height);
            if (level < anatomy.top[k] - 0.02F && level > anatomy.bottom[k]) {
                top[k] = level;
                parts[k] = wall ? Part::Wall : Part::Floor;
            }
        }
    return grading::Preparation{std::make_shared<const std::vector<float>>(std::move(top)), std::move(parts), {}};
}

}  // namespace core::preparation
