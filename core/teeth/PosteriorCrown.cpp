// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/teeth/PosteriorCrown.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include <glm/geometric.hpp>

namespace core::teeth {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kFullTurn = 2.0 * kPi;

/// Returns the coefficients of the wave a + b cos + c sin + d cos 2 through the four sides.
FourSides waveThrough(const FourSides& sides)
{
    const auto [distal, buccal, mesial, lingual] = sides;
    return {(distal + buccal + mesial + lingual) / 4.0, (distal - mesial) / 2.0, (buccal - lingual) / 2.0,
            (distal - buccal + mesial - lingual) / 4.0};
}

double onWave(const FourSides& wave, double cosine, double sine)
{
    return wave[0] + wave[1] * cosine + wave[2] * sine + wave[3] * (cosine * cosine - sine * sine);
}

double smoothStep(double from, double to, double x)
{
    const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

double smoothMin(double a, double b, double k)
{
    return 0.5 * (a + b - std::sqrt((a - b) * (a - b) + k * k));
}

/// Maps the square [-1, 1]^2 onto the unit disc and preserves areas (Shirley and Chiu 1997). Returns angle and radius,
/// each from 0 to 1.
std::pair<double, double> discFromSquare(double a, double b)
{
    if (a == 0.0 && b == 0.0)
        return {0.0, 0.0};
    if (std::abs(a) > std::abs(b))
        return {kPi / 4.0 * (b / a) + (a < 0.0 ? kPi : 0.0), std::abs(a)};
    return {kPi / 2.0 - kPi / 4.0 * (a / b) + (b < 0.0 ? kPi : 0.0), std::abs(b)};
}

}  // namespace

PosteriorCrown::PosteriorCrown(PosteriorDesign design, std::vector<OcclusalField::Wave> wander, double beadPhase)
    : m_design(std::move(design)), m_field(m_design.lobes, m_design.blendMm, m_design.furrows, std::move(wander)),
      m_beadPhase(beadPhase), m_contour(waveThrough(m_design.contourZ)), m_rise(waveThrough(m_design.domeRise)),
      m_power(waveThrough(m_design.domePower))
{
    alignSideGrooves();
}

void PosteriorCrown::alignSideGrooves()
{
    constexpr double kAt = 0.65;  // share of the way out at which the fissure becomes the side groove
    constexpr int kMostDeg = 18;
    for (SideGroove& groove : m_design.sideGrooves) {
        const double mean = groove.angleDeg;
        double nearest = 0.3;
        for (int turn = -kMostDeg; turn <= kMostDeg; ++turn) {
            const double angle = (mean + turn) / 360.0 * kFullTurn;
            const OcclusalField::Sample sample =
                m_field.at(kAt * outlineMm(angle) * glm::dvec2{std::cos(angle), std::sin(angle)});
            if (sample.groove > 0.0 && sample.grooveDistanceMm < nearest) {
                nearest = sample.grooveDistanceMm;
                groove.angleDeg = mean + turn;
            }
        }
    }
}

double PosteriorCrown::outlineMm(double angle) const
{
    const double turns = angle / kFullTurn;
    const double place = (turns - std::floor(turns)) * 16.0;
    const auto first = static_cast<std::size_t>(place);
    const double t = place - static_cast<double>(first);
    const double s = 1.0 - t;
    const auto control = [&](std::size_t k) { return m_design.outline[(first + k) % 16]; };
    return (s * s * s * control(15) + (3.0 * t * t * t - 6.0 * t * t + 4.0) * control(0) +
            (3.0 * s * s * s - 6.0 * s * s + 4.0) * control(1) + t * t * t * control(2)) /
           6.0;
}

PosteriorCrown::Top PosteriorCrown::top(glm::dvec2 point) const
{
    const double radius = std::sqrt(glm::dot(point, point));
    const double cosine = radius > 1.0e-9 ? point.x / radius : 1.0;
    const double sine = radius > 1.0e-9 ? point.y / radius : 0.0;
    const double angle = std::atan2(sine, cosine);
    double rho = std::min(radius / outlineMm(angle), 1.0);
    for (const SideGroove& groove : m_design.sideGrooves) {
        const double degrees =
            std::remainder(angle - groove.angleDeg / 360.0 * kFullTurn, kFullTurn) * 360.0 / kFullTurn;
        const double near = std::exp(-degrees * degrees / (groove.widthDeg * groove.widthDeg));
        rho = std::min(rho + groove.depthMm / 5.0 * near * smoothStep(0.3, 0.7, rho) * smoothStep(1.0, 0.7, rho), 1.0);
    }
    // Towards the middle, the four sides blend into one dome, so that there is no seam where all angles meet.
    const double apart = smoothStep(0.0, 0.45, rho);
    const double power = onWave(m_power, cosine * apart, sine * apart);
    double side = onWave(m_contour, cosine * apart, sine * apart) +
                  onWave(m_rise, cosine * apart, sine * apart) * std::sqrt(std::max(1.0 - std::pow(rho, power), 0.0));

    for (const SideFurrow& furrow : m_design.sideFurrows) {
        const double degrees =
            std::remainder(angle - furrow.angleDeg / 360.0 * kFullTurn, kFullTurn) * 360.0 / kFullTurn;
        // The furrow bends around the tubercle below it.
        const double bend = degrees / furrow.widthDeg;
        const double off = (rho - furrow.place - 0.06 * bend * bend) / 0.04;
        side -= furrow.depthMm * std::exp(-bend * bend - off * off);
    }
    const OcclusalField::Sample field = m_field.at(point);
    Top top;
    top.z = smoothMin(field.height, side, m_design.shoulderMm);
    top.grooveDistanceMm = field.grooveDistanceMm;
    top.bank = field.bank;
    top.awayFromGroove = field.awayFromGroove;

    if (field.grooveDistanceMm < m_design.mouthMm) {
        // A groove ends at the edge of the table. Weaker ones (beside marginal ridges) end in the fossa.
        const double end = 0.60 + 0.36 * field.groove;
        const double share =
            field.groove * smoothStep(-0.2, 0.6, side - field.height) * smoothStep(end, end - 0.3, rho);
        // A V with a slightly flared mouth. Along the groove there is a chain of pits, wider where they are deeper.
        const double bead = std::sin(4.1 * point.x + m_beadPhase) * std::sin(3.7 * point.y + 1.3 * m_beadPhase);
        top.fissure = m_design.fissureMm * share * (0.82 + 0.18 * bead);
        top.lipMm = 0.5 * m_design.mouthMm * (0.65 + 0.25 * share + 0.1 * bead);
        const double v = std::max(1.0 - field.grooveDistanceMm / top.lipMm, 0.0);
        top.carved = top.fissure * v * (0.3 + 0.7 * v);
        top.z -= top.carved;
    }
    return top;
}

double PosteriorCrown::tipNear(glm::dvec2 place) const
{
    constexpr double kReachMm = 0.6;
    constexpr double kStepMm = 0.1;
    double highest = -1.0e9;
    for (double y = -kReachMm; y < kReachMm + 0.5 * kStepMm; y += kStepMm)
        for (double x = -kReachMm; x < kReachMm + 0.5 * kStepMm; x += kStepMm)
            if (x * x + y * y <= kReachMm * kReachMm)
                highest = std::max(highest, top(place + glm::dvec2{x, y}).z);
    return highest;
}

void PosteriorCrown::settleTips()
{
    const std::vector<Lobe> asked = m_design.lobes;
    for (int pass = 0; pass < 4; ++pass) {
        std::vector<Lobe> lobes = m_design.lobes;
        for (std::size_t k = 0; k < lobes.size(); ++k)
            if (asked[k].cusp != Cusp::None)
                lobes[k].z += asked[k].z - tipNear({asked[k].x, asked[k].y});
        m_design.lobes = std::move(lobes);
        m_field.setLobes(m_design.lobes);
    }
}

namespace {

/// The vertices over the occlusal surface, row by row.
class TopGrid
{
public:
    struct Node
    {
        glm::dvec2 home{0.0};  ///< place in the bent grid
        glm::dvec2 place{0.0};
        PosteriorCrown::Top sample;
    };
    using Cell = std::array<std::size_t, 4>;  ///< corners, counter-clockwise

    TopGrid(const PosteriorCrown& crown, int cells)
        : m_crown(crown), m_cells(cells), m_nodes(static_cast<std::size_t>((cells + 1) * (cells + 1)))
    {
        for (int row = 0; row <= cells; ++row)
            for (int column = 0; column <= cells; ++column)
                m_nodes[at(column, row)] = lay(column, row);
        // Beside sharp bends, two moved vertices may cross. They return to their first position until no cell is
        // folded.
        for (bool folded = true; folded;) {
            folded = false;
            for (int row = 0; row < cells; ++row)
                for (int column = 0; column < cells; ++column)
                    if (const Cell corners = cell(column, row); isFolded(corners))
                        for (const std::size_t k : corners)
                            folded = sendHome(m_nodes[k]) || folded;
        }
    }

    [[nodiscard]] std::size_t at(int column, int row) const
    {
        return static_cast<std::size_t>(row * (m_cells + 1) + column);
    }
    [[nodiscard]] const std::vector<Node>& nodes() const { return m_nodes; }

    /// Returns the corners of a cell; the first and third are on the diagonal that runs along a fissure.
    [[nodiscard]] Cell cell(int column, int row) const
    {
        const Cell corners{at(column, row), at(column + 1, row), at(column + 1, row + 1), at(column, row + 1)};
        const auto apart = [&](std::size_t from, std::size_t to) {
            return std::abs(bankDistance(m_nodes[from]) - bankDistance(m_nodes[to]));
        };
        const Cell turned{corners[1], corners[2], corners[3], corners[0]};
        // On the square's own diagonals, one corner of the cell is bent flat, so only one diagonal divides it into two
        // proper triangles.
        if (column == row)
            return corners;
        if (column + row == m_cells - 1)
            return turned;
        return apart(corners[0], corners[2]) <= apart(corners[1], corners[3]) ? corners : turned;
    }

private:
    [[nodiscard]] double bankDistance(const Node& node) const
    {
        return node.sample.bank * std::min(node.sample.grooveDistanceMm, 2.0 * m_crown.design().mouthMm);
    }

    [[nodiscard]] Node lay(int column, int row) const
    {
        // Vertices are denser where the sides become steep.
        const auto [angle, r] = discFromSquare(2.0 * column / m_cells - 1.0, 2.0 * row / m_cells - 1.0);
        const double outline = m_crown.outlineMm(angle);
        const double rho = r + 0.3 * (r - r * r * r * r);
        Node node;
        node.home = {outline * rho * std::cos(angle), outline * rho * std::sin(angle)};
        node.place = node.home;
        node.sample = m_crown.top(node.place);
        // Vertices beside a fissure move onto its line or its lip, so that both are edges of the mesh.
        const double reach = 2.0 * outline / m_cells;
        for (int pass = 0; pass < 2 && node.sample.fissure > 0.005; ++pass) {
            const double distance = node.sample.grooveDistanceMm;
            const double lip = node.sample.lipMm;
            if (distance > lip + 0.5 * reach)
                break;
            const double aim = distance < std::min(reach, 0.62 * lip) ? 0.0 : lip;
            node.place += node.sample.awayFromGroove * (aim - distance);
            node.sample = m_crown.top(node.place);
        }
        return node;
    }

    [[nodiscard]] bool isFolded(const Cell& corners) const
    {
        const auto area = [&](std::size_t a, std::size_t b, std::size_t c) {
            const glm::dvec2 u = m_nodes[corners[b]].place - m_nodes[corners[a]].place;
            const glm::dvec2 v = m_nodes[corners[c]].place - m_nodes[corners[a]].place;
            return u.x * v.y - u.y * v.x;
        };
        constexpr double kSliverMm2 = 1.0e-6;
        return area(0, 1, 2) < kSliverMm2 || area(0, 2, 3) < kSliverMm2;
    }

    bool sendHome(Node& node) const
    {
        if (node.place == node.home)
            return false;
        node.place = node.home;
        node.sample = m_crown.top(node.place);
        return true;
    }

    const PosteriorCrown& m_crown;
    int m_cells;
    std::vector<Node> m_nodes;
};

}  // namespace

MeshBuilder::Ring PosteriorCrown::build(MeshBuilder& builder, const ToothSizes& sizes, const MeshDetail& detail) const
{
    const int cells = detail.topCells;
    const TopGrid top(*this, cells);
    const auto at = [&top](int column, int row) { return top.at(column, row); };
    std::vector<MeshBuilder::Index> grid;
    grid.reserve(top.nodes().size());
    double buccalTip = -1.0e9;
    for (const TopGrid::Node& node : top.nodes()) {
        grid.push_back(builder.add({node.place.x, node.place.y, node.sample.z}));
        if (node.place.y > 0.0)
            buccalTip = std::max(buccalTip, node.sample.z);
    }
    for (int row = 0; row < cells; ++row)
        for (int column = 0; column < cells; ++column) {
            const auto [a, b, c, d] = top.cell(column, row);
            builder.triangle(grid[a], grid[b], grid[c]);
            builder.triangle(grid[a], grid[c], grid[d]);
        }

    // Its rim, from the distal side on: counter-clockwise, like the angle.
    MeshBuilder::Ring above;
    const int half = cells / 2;
    for (int k = half; k < cells; ++k)
        above.push_back(grid[at(cells, k)]);
    for (int k = cells; k > 0; --k)
        above.push_back(grid[at(k, cells)]);
    for (int k = cells; k > 0; --k)
        above.push_back(grid[at(0, k)]);
    for (int k = 0; k < cells; ++k)
        above.push_back(grid[at(k, 0)]);
    for (int k = 0; k < half; ++k)
        above.push_back(grid[at(cells, k)]);

    // The sides, from the contour to the CEJ.
    const MeshBuilder::Ring rim = above;
    const std::vector<glm::dvec3> neck = cej(rim.size() / 2, buccalTip - sizes.crownHeightMm, sizes);
    for (int r = 1; r <= detail.sideRings; ++r) {
        const double t = static_cast<double>(r) / detail.sideRings;
        // The side is vertical at the contour and recedes faster towards the neck.
        const double in = std::pow(t, 1.7);
        MeshBuilder::Ring ring;
        for (std::size_t k = 0; k < neck.size(); k += r < detail.sideRings ? 1 : 2) {
            const glm::dvec3 from = builder.point(rim[2 * k]);
            const glm::dvec3& to = neck[k];
            ring.push_back(builder.add(
                {from.x + (to.x - from.x) * in, from.y + (to.y - from.y) * in, from.z + (to.z - from.z) * t}));
        }
        builder.band(above, ring);
        above = std::move(ring);
    }
    return above;
}

std::vector<glm::dvec3> PosteriorCrown::cej(std::size_t count, double facialZ, const ToothSizes& sizes) const
{
    std::vector<glm::dvec3> line;
    for (std::size_t k = 0; k < count; ++k) {
        const double angle = kFullTurn * static_cast<double>(k) / static_cast<double>(count);
        const double c = std::cos(angle);
        const double s = std::sin(angle);
        const double p = m_design.cervixPower;
        const double radius = std::pow(std::pow(2.0 * std::abs(c) / sizes.cervixWidthMm, p) +
                                           std::pow(2.0 * std::abs(s) / sizes.cervixDepthMm, p),
                                       -1.0 / p);
        const glm::dvec2 place{m_design.cervixX + radius * c, m_design.cervixY + radius * s};
        // The neck is nowhere wider than the crown above it, not even under the missing corner of a heart-shaped
        // outline.
        const double reach = std::sqrt(glm::dot(place, place));
        const double within = smoothMin(reach, 0.97 * outlineMm(std::atan2(place.y, place.x)), 0.25) / reach;
        const double rise = (c < 0.0 ? sizes.cejCurveMesialMm : sizes.cejCurveDistalMm) * c * c * c * c;
        line.emplace_back(place.x * within, place.y * within, facialZ + rise);
    }
    return line;
}

}  // namespace core::teeth
