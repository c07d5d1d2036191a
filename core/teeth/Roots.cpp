// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/teeth/Roots.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace core::teeth {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;
/// The dentin is set back below the edge of the enamel. A probe feels this step as the CEJ.
constexpr double kCejStepMm = 0.1;
constexpr double kCejDropMm = 0.03;

double smoothStep(double t)
{
    t = std::clamp(t, 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

glm::dvec3 centreOf(const MeshBuilder& builder, const MeshBuilder::Ring& ring)
{
    glm::dvec3 sum{0.0};
    for (const MeshBuilder::Index k : ring)
        sum += builder.point(k);
    return sum / static_cast<double>(ring.size());
}

/// Returns the radius of a root's section along it. It is 1 at the start, where there is no kink, then a cone with a
/// round apex.
double taper(double t)
{
    return std::sqrt(std::max(1.0 - t * t * t * t * t * t, 0.0)) * (1.0 - 0.66 * std::pow(t, 1.35));
}

/// Builds a branch from a ring of any shape down to an apex. The section gradually becomes an ellipse.
void growBranch(MeshBuilder& builder, const MeshBuilder::Ring& start, const RootBranch& branch, double apexZ,
                double hollowMm, int rings)
{
    const glm::dvec3 centre = centreOf(builder, start);
    std::vector<double> angles;
    for (const MeshBuilder::Index k : start) {
        const glm::dvec3 d = builder.point(k) - centre;
        angles.push_back(std::atan2(d.y / branch.halfY, d.x / branch.halfX));
    }
    MeshBuilder::Ring above = start;
    for (int r = 1; r < rings; ++r) {
        const double t = 1.0 - std::pow(1.0 - static_cast<double>(r) / rings, 1.25);
        const double bow = 6.75 * t * t * (1.0 - t);
        const double width = taper(t);
        const double round = smoothStep(t / 0.7);
        const double lean = std::pow(t, 1.3);
        const glm::dvec2 axis{centre.x + (branch.apexX - centre.x) * lean + branch.bendX * bow,
                              centre.y + (branch.apexY - centre.y) * lean + branch.bendY * bow};
        MeshBuilder::Ring ring;
        for (std::size_t k = 0; k < start.size(); ++k) {
            const glm::dvec3 from = builder.point(start[k]);
            const double c = std::cos(angles[k]);
            const double s = std::sin(angles[k]);
            const double hollow = hollowMm * c * c * c * c * smoothStep(t * 4.0) * width;
            const glm::dvec2 ellipse{(branch.halfX * width - hollow) * c, branch.halfY * width * s};
            const glm::dvec2 own = glm::dvec2{from.x - centre.x, from.y - centre.y} * width;
            const glm::dvec2 section = own + (ellipse - own) * round;
            ring.push_back(builder.add({axis.x + section.x, axis.y + section.y, from.z + (apexZ - from.z) * t}));
        }
        builder.band(above, ring);
        above = std::move(ring);
    }
    builder.capBelow(above, builder.add({branch.apexX, branch.apexY, apexZ}));
}

}  // namespace

void addRoots(MeshBuilder& builder, const MeshBuilder::Ring& cervix, const RootDesign& design, double lengthMm,
              const MeshDetail& detail)
{
    const std::size_t n = cervix.size();
    if (n == 0)
        return;
    const glm::dvec3 centre = centreOf(builder, cervix);
    double facialZ = 0.0;
    for (const MeshBuilder::Index k : cervix)
        facialZ = std::min(facialZ, builder.point(k).z);

    // The step under the enamel comes first. A tooth with several roots then has a trunk down to the furcation.
    const bool single = design.partingDeg.empty();
    const int rings = single ? 1 : detail.trunkRings;
    MeshBuilder::Ring above = cervix;
    for (int r = 1; r <= rings; ++r) {
        const double t = single ? 0.0 : static_cast<double>(r - 1) / (detail.trunkRings - 1);
        MeshBuilder::Ring ring;
        for (std::size_t k = 0; k < n; ++k) {
            const double angle = kTurn * static_cast<double>(k) / static_cast<double>(n);
            const glm::dvec3 from = builder.point(cervix[k]);
            const glm::dvec2 arm{from.x - centre.x, from.y - centre.y};
            const double radius = std::sqrt(glm::dot(arm, arm));
            double hollow = 0.0;
            for (const double parting : design.partingDeg) {
                const double apart = std::remainder(angle - parting / 360.0 * kTurn, kTurn);
                hollow += std::exp(-apart * apart / 0.10);
            }
            const double shrink = 1.0 - kCejStepMm / radius - 0.10 * t - 0.16 * hollow * smoothStep(t);
            const double z = from.z - kCejDropMm - (design.trunkMm - kCejDropMm) * t - (from.z - facialZ) * t;
            ring.push_back(builder.add({centre.x + arm.x * shrink, centre.y + arm.y * shrink, z}));
        }
        builder.band(above, ring);
        above = std::move(ring);
    }
    const double apexZ = facialZ - lengthMm;
    if (single) {
        growBranch(builder, above, design.branches.front(), apexZ, design.hollowMm, detail.branchRings);
        return;
    }

    // Spokes lead from the parting points to the roof of the furcation. The ring of each root is an arc and two spokes.
    const glm::dvec3 below = centreOf(builder, above);
    const MeshBuilder::Index roof = builder.add({below.x, below.y, below.z + 0.35 * design.trunkMm});
    std::vector<std::size_t> partings;
    std::vector<MeshBuilder::Ring> spokes;
    for (const double parting : design.partingDeg) {
        const auto at = static_cast<std::size_t>(std::lround(parting / 360.0 * static_cast<double>(n))) % n;
        partings.push_back(at);
        MeshBuilder::Ring spoke;
        const glm::dvec3 edge = builder.point(above[at]);
        for (int k = 1; k <= detail.spokePoints; ++k) {
            const double t = static_cast<double>(k) / (detail.spokePoints + 1);
            const glm::dvec3 top = builder.point(roof);
            spoke.push_back(builder.add({edge.x + (top.x - edge.x) * t, edge.y + (top.y - edge.y) * t,
                                         edge.z + (top.z - edge.z) * (1.0 - (1.0 - t) * (1.0 - t))}));
        }
        spokes.push_back(std::move(spoke));
    }
    for (std::size_t b = 0; b < partings.size(); ++b) {
        const std::size_t next = (b + 1) % partings.size();
        MeshBuilder::Ring ring;
        for (std::size_t k = partings[b];; k = (k + 1) % n) {
            ring.push_back(above[k]);
            if (k == partings[next])
                break;
        }
        ring.insert(ring.end(), spokes[next].begin(), spokes[next].end());
        ring.push_back(roof);
        ring.insert(ring.end(), spokes[b].rbegin(), spokes[b].rend());
        const RootBranch& branch = design.branches[b];
        growBranch(builder, ring, branch, facialZ - lengthMm * branch.lengthShare, 0.0, detail.branchRings);
    }
}

}  // namespace core::teeth
