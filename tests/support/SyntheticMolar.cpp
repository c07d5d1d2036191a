// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/SyntheticMolar.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "tests/support/SyntheticTooth.h"

namespace support {
namespace {

struct Cusp
{
    double x;
    double y;
    double high;
    double wide;
};
constexpr std::array<Cusp, 5> kCusps{{{-2.6, -2.6, 2.9, 1.75},
                                      {0.9, -2.8, 2.6, 1.6},
                                      {3.6, -1.0, 2.2, 1.3},
                                      {-2.5, 2.6, 3.1, 1.75},
                                      {1.8, 2.7, 2.9, 1.8}}};

/// Returns the depth profile of a groove along the segment a-b: 0 far from it, 1 at its bottom.
double groove(double x, double y, std::array<double, 4> s, double wide)
{
    const double dx = s[2] - s[0];
    const double dy = s[3] - s[1];
    const double t = std::clamp(((x - s[0]) * dx + (y - s[1]) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
    const double away = std::hypot(x - s[0] - t * dx, y - s[1] - t * dy);
    return std::exp(-away * away / (wide * wide));
}

/// Returns 0 at the middle of the crown and 1 on its outline.
double outline(double x, double y)
{
    return std::pow(std::pow(std::abs(x) / 5.5, 2.6) + std::pow(std::abs(y) / (5.0 + 0.04 * x), 2.6), 1.0 / 2.6);
}

double chewing(double x, double y)
{
    double z = -3.3;
    for (const Cusp& cusp : kCusps) {
        const double d2 = (x - cusp.x) * (x - cusp.x) + (y - cusp.y) * (y - cusp.y);
        z = std::max(z, z * 0.15 + 0.85 * (-3.3 + cusp.high * std::exp(-0.5 * d2 / (cusp.wide * cusp.wide)))) +
            0.22 * cusp.high * std::exp(-d2 / (cusp.wide * cusp.wide));
    }
    // Marginal ridges close the basin.
    z += 0.7 * std::exp(-std::pow((outline(x, y) - 0.74) / 0.12, 2.0));
    const std::array<std::array<double, 4>, 5> grooves{{{-3.6, 0.1, 3.2, 0.0},
                                                        {-0.9, 0.0, -0.9, -4.6},
                                                        {-0.4, 0.0, -0.4, 4.6},
                                                        {2.2, -0.1, 2.6, -3.6},
                                                        {-3.4, 0.1, -4.4, 1.4}}};
    for (const auto& g : grooves)
        z -= 0.25 * groove(x, y, g, 0.45) + 0.35 * groove(x, y, g, 0.12);
    return z;
}

std::shared_ptr<const core::terrain::ToothAnatomy> make(int side)
{
    auto tooth = std::make_shared<core::terrain::ToothAnatomy>();
    tooth->name = "synthetic";
    tooth->fdi = 36;
    tooth->grid = {side, 11.6 / (side - 1), {-5.8, -5.8}};
    tooth->top.assign(tooth->grid.count(), core::terrain::kEmptyTop);
    tooth->bottom.assign(tooth->grid.count(), core::terrain::kEmptyBottom);
    tooth->layers.assign(tooth->grid.count(), {});
    tooth->areaMm2.assign(tooth->grid.count(), 0.0F);
    double highest = -1.0e9;
    eachNode(tooth->grid, [&](std::size_t, glm::dvec2 p) { highest = std::max(highest, chewing(p.x, p.y)); });
    eachNode(tooth->grid, [&](std::size_t k, glm::dvec2 p) {
        const double rho = outline(p.x, p.y);
        if (rho >= 1.0)
            return;
        const double round = 1.0 - std::sqrt(1.0 - std::pow(rho, 7.0));
        const double top = chewing(p.x, p.y) - highest - 3.0 * round;
        const double under = std::max(0.0, (rho - 0.78) / 0.22);
        const double bottom = std::min(top - 0.02, -8.0 + 2.6 * (1.0 - std::sqrt(1.0 - under * under)));
        tooth->top[k] = static_cast<float>(top);
        tooth->bottom[k] = static_cast<float>(bottom);
        tooth->areaMm2[k] = static_cast<float>(tooth->grid.cellMm * tooth->grid.cellMm);
        core::terrain::ColumnLayers& layers = tooth->layers[k];
        layers.dej = static_cast<float>(std::min(top - 0.9, -3.4 - 2.0 * std::pow(rho, 4.0) + 0.3 * (top + 2.5)));
        const double chamber = 1.0 - p.x * p.x / 6.0 - p.y * p.y / 4.5;
        if (chamber > 0.0) {
            layers.pulpRoof = static_cast<float>(-6.0 + 0.9 * std::sqrt(chamber));
            layers.pulpFloor = static_cast<float>(-6.0 - 0.7 * std::sqrt(chamber));
        }
        const double away = std::hypot(p.x - kLesionX, p.y - kLesionY);
        if (away < kLesionRadiusMm) {
            layers.cariesRoof = static_cast<float>(top);
            layers.cariesFloor = static_cast<float>(top - 2.0 * std::sqrt(1.0 - std::pow(away / kLesionRadiusMm, 2.0)));
        }
    });
    return tooth;
}

}  // namespace

std::shared_ptr<const core::terrain::ToothAnatomy> syntheticMolar(int side)
{
    static std::map<int, std::shared_ptr<const core::terrain::ToothAnatomy>> made;
    std::shared_ptr<const core::terrain::ToothAnatomy>& tooth = made[side];
    if (tooth == nullptr)
        tooth = make(side);
    return tooth;
}

}  // namespace support
