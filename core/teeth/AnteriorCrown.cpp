// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/teeth/AnteriorCrown.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace core::teeth {
namespace {

constexpr double kTau = 2.0 * std::numbers::pi;
constexpr int kFine = 384;
/// Share of the crown over which the incisal edge is rounded, and share of the thickness that remains at its end.
constexpr double kEdgeShare = 0.07;
constexpr double kEdgeLeft = 0.12;
/// Share of the crown below its edge at which it is as wide as the edge is drawn.
constexpr double kEdgeWidthShare = 0.15;

/// Returns a cubic B-spline over nine even control values at t in 0 .. 1; it starts at the first and ends at the last.
double on(const Curve& curve, double t)
{
    const double place = std::clamp(t, 0.0, 1.0) * 8.0;
    const int first = std::min(static_cast<int>(place), 7);
    const double u = place - first;
    const double v = 1.0 - u;
    const auto control = [&](int k) {
        // The curve continues straight beyond its ends.
        if (k < 0)
            return 2.0 * curve[0] - curve[1];
        if (k > 8)
            return 2.0 * curve[8] - curve[7];
        return curve[static_cast<std::size_t>(k)];
    };
    return (v * v * v * control(first - 1) + (3.0 * u * u * u - 6.0 * u * u + 4.0) * control(first) +
            (3.0 * v * v * v - 6.0 * v * v + 4.0) * control(first + 1) + u * u * u * control(first + 2)) /
           6.0;
}

/// Returns the parabola through the values at the edge, in the middle and at the CEJ.
double on(const std::array<double, 3>& three, double t)
{
    return three[0] * (1.0 - t) * (1.0 - 2.0 * t) + three[1] * 4.0 * t * (1.0 - t) + three[2] * t * (2.0 * t - 1.0);
}

double easing(double from, double to, double x)
{
    const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

double bell(double x, double centre, double width)
{
    const double t = (x - centre) / width;
    return std::exp(-t * t);
}

/// Returns how far the lingual surface is above (towards the lip) or below its envelope.
double lingualRelief(const AnteriorDesign& d, double xi, double t)
{
    // A hollow that narrows towards the cingulum, like a shield between two marginal ridges that meet at its lower end.
    const double down = std::clamp((t - d.fossaFrom) / (d.fossaTo - d.fossaFrom), 0.0, 1.0);
    const double length = 4.0 * down * (1.0 - down) * (1.2 - 0.4 * down);
    const double half = d.fossaHalf * (1.25 - 0.75 * down);
    const double across = std::max(1.0 - (xi / half) * (xi / half), 0.0);
    const double fossa = d.fossaMm * length * across * across;
    const double ridge = d.lingualRidgeMm * bell(xi, -0.05, 0.3) * easing(0.0, 0.3, t) * easing(0.9, 0.5, t);
    const double pit = d.pitMm * bell(xi, 0.0, 0.12) * bell(t, d.fossaTo - 0.06, 0.045);
    return fossa - ridge + pit;
}

double labialRelief(const AnteriorDesign& d, double xi, double t)
{
    const double grooves =
        (bell(xi, -0.36, 0.22) + 0.8 * bell(xi, 0.33, 0.22)) * easing(0.75, 0.1, t) * easing(-0.03, 0.08, t);
    const double ridge = bell(xi, -0.1, 0.34) * easing(1.0, 0.7, t);
    return d.labialRidgeMm * ridge - d.labialGrooveMm * grooves;
}

/// Returns one section in even steps: the labial half first, from distal to mesial, then the lingual half.
std::vector<glm::dvec3> section(const AnteriorDesign& d, const ToothSizes& sizes, int around, double t)
{
    const double edge = std::max(1.0 - t / kEdgeShare, 0.0);
    const double thickness = std::max(std::sqrt(1.0 - edge * edge), kEdgeLeft);
    const double narrowing = 1.0 - 0.03 * edge * edge;
    const double mesial = on(d.mesialX, t) * narrowing;
    const double distal = on(d.distalX, t) * narrowing;
    const double labial = on(d.labialY, t);
    const double lingual = on(d.lingualY, t);
    const double middle = 0.5 * (labial + lingual);
    // The uppermost sections are narrower but on the same edge, so that no lower section is above the edge.
    const double edgeFrom = on(d.mesialX, std::max(t, kEdgeWidthShare));
    const double edgeTo = on(d.distalX, std::max(t, kEdgeWidthShare));

    std::vector<glm::dvec3> fine;
    fine.reserve(kFine);
    for (int k = 0; k < kFine; ++k) {
        const double angle = kTau * k / kFine;
        const double c = std::cos(angle);
        const double s = std::sin(angle);
        const bool front = 2 * k <= kFine;
        const double power = on(front ? d.labialPower : d.lingualPower, t);
        const double xi = std::copysign(std::pow(std::abs(c), 2.0 / power), c);
        const double out = std::pow(std::abs(s), 2.0 / power);
        double y = 0.0;
        if (front)
            y = middle + (labial - middle + labialRelief(d, xi, t) * std::min(out * 2.0, 1.0)) * out * thickness;
        else
            y = middle + (lingual - middle + lingualRelief(d, xi, t) * std::min(out * 2.0, 1.0)) * out * thickness;
        // The lingual side is narrower than the labial one, most at the cingulum.
        const double taper = front ? 0.0 : d.lingualTaper * easing(0.1, 0.8, t) * out * out;
        const double shift = front ? 0.0 : d.cingulumX * t * out * out;
        const double x = 0.5 * (mesial + distal) + 0.5 * (distal - mesial) * xi * (1.0 - taper) + shift;
        const double upper = 1.0 - t;
        const double rise = (c < 0.0 ? sizes.cejCurveMesialMm : sizes.cejCurveDistalMm) * xi * xi;
        const double z = -sizes.crownHeightMm * t +
                         on(d.edgeZ, (x - edgeFrom) / (edgeTo - edgeFrom)) * upper * upper * upper + rise * t * t * t;
        fine.emplace_back(x, y, z);
    }
    std::vector<glm::dvec3> even;
    even.reserve(static_cast<std::size_t>(around));
    for (int half = 0; half < 2; ++half) {
        const int start = half * kFine / 2;
        std::vector<double> along{0.0};
        for (int k = 0; k < kFine / 2; ++k) {
            const auto a = static_cast<std::size_t>(start + k);
            along.push_back(along.back() + glm::distance(fine[a], fine[(a + 1) % kFine]));
        }
        std::size_t k = 0;
        for (int i = 0; i < around / 2; ++i) {
            const double want = along.back() * 2.0 * i / around;
            while (k + 2 < along.size() && along[k + 1] < want)
                ++k;
            const double u = (want - along[k]) / std::max(along[k + 1] - along[k], 1.0e-12);
            const auto a = static_cast<std::size_t>(start) + k;
            even.push_back(fine[a] + (fine[(a + 1) % kFine] - fine[a]) * u);
        }
    }
    return even;
}

}  // namespace

MeshBuilder::Ring buildAnteriorCrown(MeshBuilder& builder, const AnteriorDesign& design, const ToothSizes& sizes,
                                     const MeshDetail& detail)
{
    const auto around = static_cast<std::size_t>(detail.edgeAround);
    MeshBuilder::Ring above;
    for (int r = 0; r <= detail.edgeSections; ++r) {
        // Sections are closer to each other where the incisal edge is rounded.
        const double t = std::pow(static_cast<double>(r) / detail.edgeSections, 1.5);
        const std::vector<glm::dvec3> points = section(design, sizes, detail.edgeAround, t);
        MeshBuilder::Ring ring;
        for (std::size_t k = 0; k < points.size(); k += r < detail.edgeSections ? 1 : 2)
            ring.push_back(builder.add(points[k]));
        if (r == 0) {
            // The edge is a narrow strip between the labial and the lingual half.
            for (std::size_t k = 0; k < around / 2; ++k) {
                const MeshBuilder::Index a = ring[k];
                const MeshBuilder::Index b = ring[k + 1];
                const MeshBuilder::Index c = ring[(around - k - 1) % around];
                const MeshBuilder::Index d = ring[(around - k) % around];
                if (k > 0)
                    builder.triangle(a, b, d);
                if (k + 1 < around / 2)
                    builder.triangle(b, c, d);
            }
        } else {
            builder.band(above, ring);
        }
        above = std::move(ring);
    }
    return above;
}

}  // namespace core::teeth
