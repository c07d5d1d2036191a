// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grading/CutForm.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <glm/geometric.hpp>

#include "core/grading/Columns.h"
#include "core/terrain/NodeRect.h"

namespace core::grading {
namespace {

using terrain::Grid;
using terrain::NodeRect;
using terrain::ToothAnatomy;

constexpr double kAsideMm = 1.5;  ///< half the width in which the cut is searched at an isthmus

/// Returns the distance along a direction at which the cut begins (from a position outside it) or ends (from a position
/// inside it). Empty if there is no such place within mostMm.
std::optional<double> edgeAlong(const Outline& outline, glm::dvec2 fromMm, glm::dvec2 towards, double stepMm,
                                double mostMm)
{
    double inside = outline.insideMm(fromMm);
    const bool beginsInside = inside > 0.0;
    for (double at = stepMm; at < mostMm; at += stepMm) {
        const double here = outline.insideMm(fromMm + towards * at);
        if ((here > 0.0) != beginsInside)
            return at - stepMm + stepMm * inside / (inside - here);
        inside = here;
    }
    return {};
}

/// Measures the axial depth of a box along one line, from the surface of the uncut tooth inwards to the axial wall.
class AxialLine
{
public:
    /// @param startMm  outside the tooth, on the line
    AxialLine(const CutSurface& cut, glm::dvec2 startMm, glm::dvec2 inwards)
        : m_cut(cut), m_startMm(startMm), m_inwards(inwards)
    {}

    /// Returns the depth, mm. Empty if the line meets no tooth at the height of the floor.
    [[nodiscard]] std::optional<double> depthMm(double floorMm) const
    {
        constexpr double kReachMm = 6.0;
        const double stepMm = 0.5 * m_cut.anatomy.grid.cellMm;
        const double wallMm = floorMm + kAxialWallMm;
        std::optional<double> surface;
        bool isInBox = false;
        for (double at = 0.0; at < kReachMm; at += stepMm) {
            const std::size_t k = m_cut.outline.nodeAt(m_startMm + m_inwards * at);
            if (!surface && spans(k, m_cut.anatomy.top[k], floorMm))
                surface = at;
            if (!surface || !spans(k, m_cut.anatomy.top[k], wallMm))
                continue;
            if (!spans(k, m_cut.end[k], wallMm))
                isInBox = true;
            else if (isInBox)
                return at - *surface;
        }
        if (!surface)
            return {};
        return isInBox ? kReachMm - *surface : 0.0;
    }

private:
    [[nodiscard]] bool spans(std::size_t k, float top, double heightMm) const
    {
        return static_cast<double>(m_cut.anatomy.bottom[k]) < heightMm && heightMm < static_cast<double>(top);
    }

    const CutSurface& m_cut;
    glm::dvec2 m_startMm;
    glm::dvec2 m_inwards;
};

// ---------------------------------------------------------------------------------------------------------- walls

constexpr double kLeastHeightMm = 0.3;  ///< a lower step is no wall
constexpr double kFootMm = 0.5;         ///< radius in which the foot of a wall is searched around a place on it
constexpr double kBandTop = 0.02;       ///< share of the height from the cavosurface down to the foot
constexpr double kBandFoot = 0.75;
constexpr double kHalfStretchMm = 0.35;
constexpr double kInwardsMm = 0.6;
constexpr double kOutwardsMm = 0.15;
/// Cosine of the largest angle between a stretch and the uphill direction of its places.
constexpr double kSameWay = 0.7;
constexpr std::size_t kMostStretches = 800;  ///< more stretches add no information
constexpr std::size_t kLeastPlaces = 6;
/// Share of the wall's height. A stretch is used only if its heights vary by more than this after the other terms are
/// removed.
constexpr double kLeastSpread = 0.07;

/// A column on the slope of a wall.
struct Place
{
    glm::dvec2 atMm{};
    double zMm = 0.0;
    double wallMm = 0.0;  ///< height of the wall there
    glm::dvec2 uphill{};  ///< unit vector
};

/// Columns on the slopes of walls, looked up by where they are.
class Slopes
{
public:
    explicit Slopes(const CutSurface& cut);
    [[nodiscard]] double wallMm(std::size_t k) const
    {
        return static_cast<double>(m_cut.anatomy.top[k]) - static_cast<double>(m_foot[k]);
    }
    [[nodiscard]] const Place* at(int i, int j) const
    {
        const int number = m_number[m_cut.anatomy.grid.index(i, j)];
        return number < 0 ? nullptr : &m_places[static_cast<std::size_t>(number)];
    }

private:
    [[nodiscard]] NodeRect cutArea() const;
    void findFeet(const NodeRect& area);
    [[nodiscard]] glm::dvec2 uphillAt(int i, int j) const;

    const CutSurface& m_cut;
    std::vector<float> m_foot;  ///< lowest end within kFootMm along x and y, [side * side]
    std::vector<int> m_number;  ///< into m_places, -1: none
    std::vector<Place> m_places;
};

NodeRect Slopes::cutArea() const
{
    NodeRect area;
    const Grid& grid = m_cut.anatomy.grid;
    for (int j = 0; j < grid.side; ++j)
        for (int i = 0; i < grid.side; ++i)
            if (const std::size_t k = grid.index(i, j);
                wasSolid(m_cut.anatomy, k) && m_cut.end[k] < m_cut.anatomy.top[k])
                area = terrain::united(area, {i, j, i + 1, j + 1});
    return area;
}

void Slopes::findFeet(const NodeRect& area)
{
    const Grid& grid = m_cut.anatomy.grid;
    const int reach = std::max(1, static_cast<int>(std::lround(kFootMm / grid.cellMm)));
    std::vector<float> inRow = m_foot;
    const NodeRect rows = terrain::grown(area, reach, grid);
    for (int j = rows.beginJ; j < rows.endJ; ++j)
        for (int i = area.beginI; i < area.endI; ++i) {
            float lowest = m_foot[grid.index(i, j)];
            for (int n = std::max(0, i - reach); n <= std::min(grid.side - 1, i + reach); ++n)
                if (wasSolid(m_cut.anatomy, grid.index(n, j)))
                    lowest = std::min(lowest, m_cut.end[grid.index(n, j)]);
            inRow[grid.index(i, j)] = lowest;
        }
    for (int j = area.beginJ; j < area.endJ; ++j)
        for (int i = area.beginI; i < area.endI; ++i) {
            float& lowest = m_foot[grid.index(i, j)];
            for (int n = std::max(0, j - reach); n <= std::min(grid.side - 1, j + reach); ++n)
                lowest = std::min(lowest, inRow[grid.index(i, n)]);
        }
}

/// Returns the direction in which the cut surface rises around a node (Sobel); zero if it is level.
glm::dvec2 Slopes::uphillAt(int i, int j) const
{
    const Grid& grid = m_cut.anatomy.grid;
    const std::size_t middle = grid.index(i, j);
    const auto height = [&](int di, int dj) {
        const bool isThere = grid.contains(i + di, j + dj) && wasSolid(m_cut.anatomy, grid.index(i + di, j + dj));
        return static_cast<double>(m_cut.end[isThere ? grid.index(i + di, j + dj) : middle]);
    };
    glm::dvec2 rise(0.0);
    for (const int n : {-1, 0, 1}) {
        const double weight = n == 0 ? 2.0 : 1.0;
        rise += weight * glm::dvec2(height(1, n) - height(-1, n), height(n, 1) - height(n, -1));
    }
    const double length = std::sqrt(glm::dot(rise, rise));
    return length > 0.0 ? rise / length : glm::dvec2(0.0);
}

Slopes::Slopes(const CutSurface& cut) : m_cut(cut), m_foot(cut.anatomy.top), m_number(cut.anatomy.grid.count(), -1)
{
    const Grid& grid = cut.anatomy.grid;
    // The ground just outside a cut also has a foot, because the wall of the cut begins there.
    const NodeRect area = terrain::grown(cutArea(), 2, grid);
    if (area.isEmpty())
        return;
    findFeet(area);
    for (int j = area.beginJ; j < area.endJ; ++j) {
        for (int i = area.beginI; i < area.endI; ++i) {
            const std::size_t k = grid.index(i, j);
            if (!wasSolid(cut.anatomy, k) || wallMm(k) < kLeastHeightMm)
                continue;
            const double down = (static_cast<double>(cut.anatomy.top[k]) - static_cast<double>(cut.end[k])) / wallMm(k);
            if (!(down > kBandTop && down < kBandFoot))
                continue;
            m_number[k] = static_cast<int>(m_places.size());
            m_places.push_back({grid.nodeMm(i, j), static_cast<double>(cut.end[k]), wallMm(k), uphillAt(i, j)});
        }
    }
}

/// A short stretch of wall. For each place it stores the offset outwards, the position along the stretch, and the
/// height.
class Stretch
{
public:
    void clear()
    {
        m_out.clear();
        m_along.clear();
        m_height.clear();
        m_wallMm = 0.0;
    }
    void add(double outMm, double alongMm, const Place& place)
    {
        m_out.push_back(outMm);
        m_along.push_back(alongMm);
        m_height.push_back(place.zMm);
        m_wallMm += place.wallMm;
    }

    /// Fits out = a + b along + c along^2 + tangent height by least squares. Returns the tangent; empty if the heights
    /// do not determine it.
    [[nodiscard]] std::optional<double> fittedTangent();
    [[nodiscard]] std::size_t count() const { return m_out.size(); }
    /// Returns the tangent: the area of the slope seen from above over its area seen from the side.
    [[nodiscard]] double tangentByArea(double cellMm) const
    {
        if (m_out.empty())
            return 0.0;
        const double meanWall = m_wallMm / static_cast<double>(count());
        return static_cast<double>(count()) * cellMm * cellMm /
               (2.0 * kHalfStretchMm * (kBandFoot - kBandTop) * meanWall);
    }

private:
    std::vector<double> m_out;
    std::vector<double> m_along;
    std::vector<double> m_height;
    double m_wallMm = 0.0;
};

double dotOf(const std::vector<double>& a, const std::vector<double>& b)
{
    double sum = 0.0;
    for (std::size_t n = 0; n < a.size(); ++n)
        sum += a[n] * b[n];
    return sum;
}

/// Removes from `from` its component along `what`.
void takeOut(std::vector<double>& from, const std::vector<double>& what)
{
    const double length2 = dotOf(what, what);
    if (!(length2 > 0.0))
        return;
    const double share = dotOf(from, what) / length2;
    for (std::size_t n = 0; n < from.size(); ++n)
        from[n] -= share * what[n];
}

std::optional<double> Stretch::fittedTangent()
{
    if (count() < kLeastPlaces)
        return {};
    // Gram-Schmidt: the direction and the curvature of the stretch are removed first.
    std::vector<double> base(count(), 1.0);
    std::vector<double> line = m_along;
    std::vector<double> bend = m_along;
    for (double& value : bend)
        value *= value;
    takeOut(line, base);
    takeOut(bend, base);
    takeOut(bend, line);
    for (const std::vector<double>* known : {&base, &line, &bend}) {
        takeOut(m_out, *known);
        takeOut(m_height, *known);
    }
    const double meanWall = m_wallMm / static_cast<double>(count());
    const double spread2 = dotOf(m_height, m_height);
    if (spread2 < static_cast<double>(count()) * kLeastSpread * kLeastSpread * meanWall * meanWall)
        return {};
    return dotOf(m_out, m_height) / spread2;
}

/// The direction of the outline around a segment, and whether the outline is straight there. Corners belong to no wall.
struct Facing
{
    glm::dvec2 outwards{};
    bool isStraight = false;
};

Facing facingOf(const Outline& outline, const Outline::Segment& segment)
{
    constexpr double kAroundMm = 0.3;
    // Limit for the length of the mean of unit vectors. It is 0.93 for a circle of 0.45 mm, and 0.27 mm from the corner
    // of a right angle.
    constexpr double kStraight = 0.93;
    glm::dvec2 sum(0.0);
    double length = 0.0;
    outline.forEachWithin(segment.middleMm(), kAroundMm, [&](const Outline::Segment& other) {
        if (glm::dot(other.outwards, segment.outwards) < 0.0)
            return;  // this is the other side of a narrow place
        sum += other.outwards * other.lengthMm();
        length += other.lengthMm();
    });
    const double mean = std::sqrt(glm::dot(sum, sum));
    if (!(mean > 0.0))
        return {segment.outwards, false};
    return {sum / mean, mean >= kStraight * length};
}

/// Collects the places on the slope of the wall at `middle` of the outline.
void gather(const Grid& grid, const Slopes& slopes, glm::dvec2 middle, glm::dvec2 outwards, Stretch& stretch)
{
    const double farthestMm = std::sqrt(kInwardsMm * kInwardsMm + kHalfStretchMm * kHalfStretchMm);
    const int reach = static_cast<int>(farthestMm / grid.cellMm) + 1;
    const glm::dvec2 along(-outwards.y, outwards.x);
    const glm::ivec2 at(grid.latticeOf(middle) + 0.5);
    stretch.clear();
    for (int j = std::max(0, at.y - reach); j <= std::min(grid.side - 1, at.y + reach); ++j) {
        for (int i = std::max(0, at.x - reach); i <= std::min(grid.side - 1, at.x + reach); ++i) {
            const Place* place = slopes.at(i, j);
            if (place == nullptr || glm::dot(place->uphill, outwards) < kSameWay)
                continue;
            const glm::dvec2 way = place->atMm - middle;
            const double out = glm::dot(way, outwards);
            const double aside = glm::dot(way, along);
            if (out <= kOutwardsMm && out >= -kInwardsMm && std::abs(aside) <= kHalfStretchMm)
                stretch.add(out, aside, *place);
        }
    }
}

Side sideOf(glm::dvec2 outwards)
{
    if (std::abs(outwards.x) > std::abs(outwards.y))
        return outwards.x > 0.0 ? Side::PlusX : Side::MinusX;
    return outwards.y > 0.0 ? Side::PlusY : Side::MinusY;
}

}  // namespace

double atanDeg(double tangent)
{
    constexpr double kDegreesPerRadian = 57.29577951308232;
    const double size = std::abs(tangent);
    // Computes tan(x / 2) from tan x twice, so that at most 11.25 degrees remain for the series.
    double t = size > 1.0 ? 1.0 / size : size;
    for (int half = 0; half < 2; ++half)
        t /= 1.0 + std::sqrt(1.0 + t * t);
    double series = 0.0;
    for (int n = 15; n >= 1; n -= 2)
        series = 1.0 / n - t * t * series;
    const double degrees = 4.0 * kDegreesPerRadian * t * series;
    return std::copysign(size > 1.0 ? 90.0 - degrees : degrees, tangent);
}

std::optional<Placed> isthmusOf(const CutSurface& cut, const Preparation::Isthmus& isthmus, const Outline& ideal)
{
    if (cut.outline.segments().empty())
        return {};
    const Grid& grid = cut.anatomy.grid;
    const double stepMm = 0.5 * grid.cellMm;
    const double mostMm = grid.cellMm * grid.side;
    const glm::dvec2 along(-isthmus.across.y, isthmus.across.x);
    const int lines = static_cast<int>(isthmus.lengthMm / stepMm);
    std::optional<Placed> narrowest;
    for (int line = -lines; line <= lines; ++line) {
        const glm::dvec2 middle = isthmus.atMm + along * (stepMm * line);
        if (!(ideal.insideMm(middle) > 0.0))
            continue;
        // The place of this line that is inside the cut and nearest to the middle of the line.
        std::optional<double> start;
        for (double aside = 0.0; aside < kAsideMm && !start; aside += stepMm)
            for (const double at : {aside, -aside})
                if (!start && cut.outline.insideMm(middle + isthmus.across * at) > 0.0)
                    start = at;
        double width = 0.0;
        glm::dvec2 place = middle;
        if (start) {
            place = middle + isthmus.across * *start;
            const double right = edgeAlong(cut.outline, place, isthmus.across, stepMm, mostMm).value_or(mostMm);
            const double left = edgeAlong(cut.outline, place, -isthmus.across, stepMm, mostMm).value_or(mostMm);
            width = left + right;
            place += isthmus.across * (0.5 * (right - left));
        }
        if (!narrowest || width < narrowest->value)
            narrowest = Placed{width, cut.outline.nodeAt(place)};
    }
    return narrowest;
}

std::optional<Placed> axialDepthOf(const CutSurface& cut, const Preparation::Box& box)
{
    constexpr double kOutsideMm = 1.0;
    const double stepMm = 0.5 * cut.anatomy.grid.cellMm;
    const glm::dvec2 across(-box.outwards.y, box.outwards.x);
    const int lines = static_cast<int>(0.25 * box.widthMm / stepMm);
    double sum = 0.0;
    int count = 0;
    for (int line = -lines; line <= lines; ++line) {
        const glm::dvec2 start = box.atMm + across * (stepMm * line) + box.outwards * kOutsideMm;
        if (const auto depth = AxialLine(cut, start, -box.outwards).depthMm(box.floorMm)) {
            sum += *depth;
            ++count;
        }
    }
    if (count == 0)
        return {};
    return Placed{sum / count, cut.outline.nodeAt(box.atMm - box.outwards * (sum / count))};
}

std::optional<Placed> obliqueRidgeOf(const CutSurface& cut, std::span<const glm::dvec2> crest)
{
    constexpr double kReachMm = 2.5;  // a cavity farther from the crest does not thin it
    const double stepMm = 0.5 * cut.anatomy.grid.cellMm;
    std::optional<Placed> narrowest;
    for (std::size_t n = 1; n + 1 < crest.size(); ++n) {
        const glm::dvec2 way = crest[n + 1] - crest[n - 1];
        const glm::dvec2 across = glm::dvec2(-way.y, way.x) / std::sqrt(glm::dot(way, way));
        double width = 0.0;
        if (!(cut.outline.insideMm(crest[n]) > 0.0)) {
            const auto left = edgeAlong(cut.outline, crest[n], across, stepMm, kReachMm);
            const auto right = edgeAlong(cut.outline, crest[n], -across, stepMm, kReachMm);
            if (!left || !right)
                continue;
            width = *left + *right;
        }
        if (!narrowest || width < narrowest->value)
            narrowest = Placed{width, cut.outline.nodeAt(crest[n])};
    }
    return narrowest;
}

std::optional<Placed> ridgeOf(const CutSurface& cut, int sign)
{
    const ToothAnatomy& anatomy = cut.anatomy;
    const Grid& grid = anatomy.grid;
    const auto column = [&](int n) { return sign < 0 ? n : grid.side - 1 - n; };  // the n-th from the outside
    const auto firstSolid = [&](int j) {
        int n = 0;
        while (n < grid.side && !wasSolid(anatomy, grid.index(column(n), j)))
            ++n;
        return n;
    };
    int beginJ = 0;
    int endJ = grid.side;
    while (beginJ < endJ && firstSolid(beginJ) == grid.side)
        ++beginJ;
    while (endJ > beginJ && firstSolid(endJ - 1) == grid.side)
        --endJ;
    const int quarter = (endJ - beginJ) / 4;

    std::optional<Placed> least;
    for (int j = beginJ + quarter; j < endJ - quarter; ++j) {
        const int rim = firstSolid(j);
        int n = rim;
        while (n < grid.side && !(cut.outline.insideMm(column(n), j) > 0.0))
            ++n;
        if (rim == grid.side || n == grid.side)
            continue;
        // Both are in cells from the outermost node: the end of the silhouette in this row, and the start of the cut.
        const double rimWidth = static_cast<double>(anatomy.areaMm2[grid.index(column(rim), j)]);
        const double outside = rim + 0.5 - std::clamp(rimWidth / (grid.cellMm * grid.cellMm), 0.0, 1.5);
        double edge = n;
        if (n > 0) {
            const double before = cut.outline.insideMm(column(n - 1), j);
            const double here = cut.outline.insideMm(column(n), j);
            edge = n - here / (here - before);
        }
        const double ridge = grid.cellMm * std::max(0.0, edge - outside);
        if (!least || ridge < least->value)
            least = Placed{ridge, grid.index(column(n), j)};
    }
    return least;
}

void measureWalls(const CutSurface& cut, Form& form)
{
    struct Sum
    {
        double weightedDeg = 0.0;
        double weight = 0.0;
        Placed most{-90.0, 0};
        void add(double degrees, const Outline::Segment& segment)
        {
            weightedDeg += degrees * segment.lengthMm();
            weight += segment.lengthMm();
            if (degrees > most.value)
                most = {degrees, segment.node};
        }
    };
    std::array<Sum, 4> straight;
    std::array<Sum, 4> corners;

    const Grid& grid = cut.anatomy.grid;
    const Slopes slopes(cut);
    Stretch stretch;
    // Neighbouring segments have nearly the same stretch, so some hundred segments are enough.
    const std::span<const Outline::Segment> segments = cut.outline.segments();
    const std::size_t stride = segments.size() / kMostStretches + 1;
    for (std::size_t s = 0; s < segments.size(); s += stride) {
        const Outline::Segment& segment = segments[s];
        if (!wasSolid(cut.anatomy, segment.node) || slopes.wallMm(segment.node) < kLeastHeightMm)
            continue;
        const Facing facing = facingOf(cut.outline, segment);
        gather(grid, slopes, segment.middleMm(), facing.outwards, stretch);
        const double tangent = stretch.fittedTangent().value_or(stretch.tangentByArea(grid.cellMm));
        const auto side = static_cast<std::size_t>(sideOf(facing.outwards));
        (facing.isStraight ? straight : corners).at(side).add(atanDeg(tangent), segment);
    }
    for (std::size_t side = 0; side < straight.size(); ++side) {
        const Sum& sum = straight.at(side).weight > 0.0 ? straight.at(side) : corners.at(side);
        if (sum.weight > 0.0)
            form.wallDeg.at(side) = Placed{sum.weightedDeg / sum.weight, sum.most.node};
    }
}

}  // namespace core::grading
