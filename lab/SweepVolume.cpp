// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/SweepVolume.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>

#include "core/cutting/Drill.h"
#include "lab/Block.h"

namespace lab {
namespace {

using namespace core;

constexpr double kTrenchMm = 3.0;
constexpr double kArcRadiusMm = 1.2;
constexpr double kCutStepMm = 0.01;  ///< between two cuts: half the way of a bur in a tick at 20 mm/s
constexpr int kAlongEvery = 4;       ///< one of so many sweeps runs along the lattice, where whole rows count or do not

/// Half a cross-section of the part above the underside at `depthMm`: its area, mm2, and its moment about the bur's
/// axis, mm3.
struct HalfSection
{
    double areaMm2;
    double momentMm3;
};

HalfSection halfSection(const bur::Bur& bur, double depthMm)
{
    const double flat = bur.flatRadiusMm();
    const double corner = bur.cornerMm;
    const double bend = flat + bur.bendMm();
    const double round = std::min(depthMm, bur.undersideMm(bend));
    // After the rounded rim comes the cone, and after that the upright side.
    const double cone = std::min(depthMm, bur.undersideMm(bur.headRadiusMm)) - round;
    const double above = depthMm - round - cone;
    const double wider = bur.hasCone() ? cone / bur.coneSlope : 0.0;
    const double reach = std::sqrt(round * (2.0 * corner - round));
    // Half a segment of the rounded rim's circle, from the rim of the flat end outwards.
    const double left = corner - round;
    const double segment = 0.5 * (corner * corner * std::acos(left / corner) - left * reach);
    const double moment = (corner * corner * corner - left * left * left) / 3.0 - 0.5 * left * reach * reach;
    return {flat * round + segment + cone * (bend + 0.5 * wider) + bur.headRadiusMm * above,
            0.5 * flat * flat * round + flat * segment + moment +
                0.5 * cone * (bend * bend + bend * wider + wider * wider / 3.0) +
                0.5 * bur.headRadiusMm * bur.headRadiusMm * above};
}

/// One sweep in one position on the lattice, turned by `heading`, mm.
class Way
{
public:
    Way(Sweep sweep, double headingRad)
        : m_sweep(sweep), m_along(std::cos(headingRad), std::sin(headingRad)), m_across(-m_along.y, m_along.x)
    {}

    [[nodiscard]] double lengthMm() const
    {
        switch (m_sweep) {
        case Sweep::Trench:
            return kTrenchMm;
        case Sweep::Arc:
            return std::numbers::pi * kArcRadiusMm;
        case Sweep::Plunge:
            break;
        }
        return 0.0;
    }

    [[nodiscard]] glm::dvec2 at(double walkedMm) const
    {
        switch (m_sweep) {
        case Sweep::Trench:
            return m_along * (walkedMm - 0.5 * kTrenchMm);
        case Sweep::Arc: {
            const double angle = walkedMm / kArcRadiusMm;
            return kArcRadiusMm * (m_along * std::cos(angle) + m_across * std::sin(angle));
        }
        case Sweep::Plunge:
            break;
        }
        return {0.0, 0.0};
    }

    [[nodiscard]] double distanceTo(glm::dvec2 point) const
    {
        const glm::dvec2 own(glm::dot(point, m_along), glm::dot(point, m_across));
        if (m_sweep == Sweep::Arc && own.y >= 0.0)
            return std::abs(glm::length(own) - kArcRadiusMm);
        if (m_sweep == Sweep::Arc)
            return glm::length(glm::dvec2(std::abs(own.x) - kArcRadiusMm, own.y));
        const double half = 0.5 * lengthMm();
        return glm::length(glm::dvec2(std::max(0.0, std::abs(own.x) - half), own.y));
    }

private:
    Sweep m_sweep;
    glm::dvec2 m_along;
    glm::dvec2 m_across;
};

/// Result of one position: the volume removed and the squares of the errors in depth.
struct Trial
{
    double removedMm3 = 0.0;
    double depthSquares = 0.0;
    std::size_t columns = 0;
};

Trial sweepOnce(const Way& way, int side, std::size_t bur, double depthMm, glm::dvec2 shift)
{
    contact::LiveTooth tooth{terrain::Tooth(enamelBlock([](glm::dvec2) { return 0.0; }, side, shift))};
    tooth.selectBur(bur);
    settings::HardnessPreset yielding;
    yielding.material.fill({settings::kMaxRateMm3PerNs, 0.0});
    cutting::Drill drill(yielding, {});
    Trial trial;
    glm::dvec3 tip(way.at(0.0), 0.0);
    const auto cutTo = [&](const glm::dvec3& next) {
        const cutting::Cut cut = drill.cut(tooth, tip, next, 1.0, 1.0);
        for (const double volume : cut.removedMm3)
            trial.removedMm3 += volume;
        tip = next;
    };
    const int down = static_cast<int>(std::ceil(depthMm / kCutStepMm));
    for (int k = 1; k <= down; ++k)
        cutTo({way.at(0.0), -depthMm * k / down});
    const int along = static_cast<int>(std::ceil(way.lengthMm() / kCutStepMm));
    for (int k = 1; k <= along; ++k)
        cutTo({way.at(way.lengthMm() * k / along), -depthMm});

    const terrain::Grid& grid = tooth.grid();
    const bur::Bur& shape = bur::burs()[bur];
    for (int j = 0; j < grid.side; ++j) {
        for (int i = 0; i < grid.side; ++i) {
            const double away = way.distanceTo(grid.nodeMm(i, j));
            const double depth = away < shape.headRadiusMm ? depthMm - shape.undersideMm(away) : 0.0;
            if (!(depth > 0.0))
                continue;
            const double wrong = depth + static_cast<double>(tooth.tooth().top[grid.index(i, j)]);
            trial.depthSquares += wrong * wrong;
            ++trial.columns;
        }
    }
    return trial;
}

}  // namespace

std::string_view nameOf(Sweep sweep)
{
    switch (sweep) {
    case Sweep::Trench:
        return "trench";
    case Sweep::Arc:
        return "arc";
    case Sweep::Plunge:
        break;
    }
    return "plunge";
}

double sweptMm3(Sweep sweep, std::size_t bur, double depthMm)
{
    const HalfSection half = halfSection(bur::burs()[bur], depthMm);
    return 2.0 * half.areaMm2 * Way(sweep, 0.0).lengthMm() + 2.0 * std::numbers::pi * half.momentMm3;
}

double sweptSectionMm2(std::size_t bur, double depthMm)
{
    return 2.0 * halfSection(bur::burs()[bur], depthMm).areaMm2;
}

SweepErrors measureSweep(Sweep sweep, int side, std::size_t bur, double depthMm)
{
    // The fractions of multiples of these fill the unit cube evenly (powers of the root of x^4 = x + 1, the cube's
    // golden ratio), for any number of positions.
    constexpr glm::dvec3 kEven(0.8191725133961645, 0.6710436067037893, 0.5497004779019703);
    const double exact = sweptMm3(sweep, bur, depthMm);
    SweepErrors errors{0.0, 0.0, 0.0};
    double squares = 0.0;
    std::size_t columns = 0;
    for (int lie = 0; lie < kSweepLies; ++lie) {
        const glm::dvec3 even = kEven * (lie + 0.5);
        const glm::dvec3 part = even - glm::floor(even);
        const Way way(sweep, lie % kAlongEvery == 0 ? 0.0 : 2.0 * std::numbers::pi * part.z);
        const Trial trial = sweepOnce(way, side, bur, depthMm, {part.x, part.y});
        const double percent = 100.0 * (trial.removedMm3 / exact - 1.0);
        errors.volumePercent += percent / kSweepLies;
        errors.worstPercent = std::max(errors.worstPercent, std::abs(percent));
        squares += trial.depthSquares;
        columns += trial.columns;
    }
    errors.depthRmsUm = 1000.0 * std::sqrt(squares / static_cast<double>(std::max<std::size_t>(columns, 1)));
    return errors;
}

}  // namespace lab
