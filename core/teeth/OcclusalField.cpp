// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/teeth/OcclusalField.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <glm/geometric.hpp>

namespace core::teeth {
namespace {

/// Radius of the tip of a cusp and its ridges, mm.
constexpr double kTipMm = 0.28;

/// Returns |t| with a rounded bottom, and its derivative.
std::pair<double, double> softAbs(double t)
{
    const double root = std::sqrt(t * t + kTipMm * kTipMm);
    return {root - kTipMm, t / root};
}

/// Returns cos 7a and sin 7a for the direction (c, s).
glm::dvec2 sevenfold(double c, double s)
{
    const auto times = [](glm::dvec2 a, glm::dvec2 b) {
        return glm::dvec2{a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x};
    };
    const glm::dvec2 one{c, s};
    const glm::dvec2 three = times(times(one, one), one);
    return times(times(three, three), one);
}

}  // namespace

struct OcclusalField::Value
{
    double height = -1.0e9;
    glm::dvec2 slope{0.0};
    double groove = 0.0;
    int group = -1;
};

OcclusalField::OcclusalField(const std::vector<Lobe>& lobes, double blendMm, double furrows, std::vector<Wave> wander)
    : m_wander(std::move(wander)), m_blendMm(blendMm), m_furrows(furrows)
{
    setLobes(lobes);
}

void OcclusalField::setLobes(const std::vector<Lobe>& lobes)
{
    m_lobes.clear();
    for (const Lobe& lobe : lobes) {
        const double angle = lobe.turnDeg * std::numbers::pi / 180.0;
        // Phases by the golden angle give every lobe different furrows.
        const double phase = 2.4 * static_cast<double>(m_lobes.size());
        m_lobes.push_back(
            {lobe, std::cos(angle), std::sin(angle), m_furrows * glm::dvec2{std::cos(phase), std::sin(phase)}});
    }
}

glm::dvec2 OcclusalField::wandered(glm::dvec2 point) const
{
    glm::dvec2 moved = point;
    for (const Wave& wave : m_wander)
        moved += wave.shiftMm * std::sin(glm::dot(wave.perMm, point) + wave.phase);
    return moved;
}

OcclusalField::Value OcclusalField::valueOf(const Prepared& p, glm::dvec2 moved)
{
    const glm::dvec2 d = moved - glm::dvec2{p.lobe.x, p.lobe.y};
    const double u = d.x * p.cosine + d.y * p.sine;
    const double v = d.y * p.cosine - d.x * p.sine;
    const auto [softU, softUSlope] = softAbs(u);
    const auto [softV, softVSlope] = softAbs(v);
    const double slopeU = u < 0.0 ? p.lobe.slopeMesial : p.lobe.slopeDistal;
    const double slopeV = v < 0.0 ? p.lobe.slopeLingual : p.lobe.slopeBuccal;
    const double a = slopeU * softU;
    const double b = slopeV * softV;
    // Computes the p-norm from one ratio, so that it is exact if one part is 0.
    const double large = std::max(a, b) + 1.0e-9;
    const double ratio = std::min(a, b) / large;
    const double power = std::pow(ratio, p.lobe.power);
    const double norm = std::pow(1.0 + power, 1.0 / p.lobe.power);
    const double away = std::sqrt(u * u + v * v) + 1.0e-9;
    const double furrow = glm::dot(p.furrows, sevenfold(u / away, v / away)) * away * away / (away * away + 0.5);
    const double fall = large * norm * (1.0 + furrow);

    Value value;
    value.height = p.lobe.z - fall;
    value.groove = p.lobe.groove;
    value.group = p.lobe.group;
    const double share = norm / (1.0 + power);
    const double shareSmall = ratio > 0.0 ? share * power / ratio : 0.0;
    const double alongU = (a >= b ? share : shareSmall) * slopeU * softUSlope;
    const double alongV = (a >= b ? shareSmall : share) * slopeV * softVSlope;
    value.slope = {-(alongU * p.cosine - alongV * p.sine), -(alongU * p.sine + alongV * p.cosine)};
    return value;
}

double OcclusalField::lobeHeight(std::size_t lobe, glm::dvec2 point) const
{
    return valueOf(m_lobes[lobe], wandered(point)).height;
}

OcclusalField::Sample OcclusalField::at(glm::dvec2 point) const
{
    const glm::dvec2 moved = wandered(point);
    Sample sample;
    Value best;
    Value second;
    double joined = -1.0e9;
    for (const Prepared& p : m_lobes) {
        const Value value = valueOf(p, moved);
        const double gap = std::max(m_blendMm - std::abs(joined - value.height), 0.0);
        joined = std::max(joined, value.height) + gap * gap / (4.0 * m_blendMm);

        if (value.height > best.height) {
            if (best.group != value.group)
                second = best;
            best = value;
        } else if (value.height > second.height && value.group != best.group) {
            second = value;
        }
    }
    sample.height = joined;
    if (second.group >= 0) {
        const glm::dvec2 apart = best.slope - second.slope;
        const double steepness = std::sqrt(glm::dot(apart, apart) + 1.0e-4);
        sample.grooveDistanceMm = (best.height - second.height) / steepness;
        sample.awayFromGroove = apart / steepness;
        sample.bank = best.group < second.group ? 1.0 : -1.0;
        sample.groove = std::min(best.groove, second.groove);
    }
    return sample;
}

}  // namespace core::teeth
