// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/teeth/ArchCurve.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace core::teeth {
namespace {

constexpr double kStepMm = 0.1;
/// Length of the curve: it extends beyond the third molars and the gum behind them.
constexpr double kLengthMm = 85.0;

/// Distance of canine tips and mesiobuccal cusps behind the incisal edges. With it, the mean crowns (ToothTable)
/// exactly fill the curve up to there.
constexpr double kCanineDepthMm[2] = {7.2, 5.0};
constexpr double kMolarDepthMm[2] = {26.0, 22.7};

}  // namespace

ArchCurve::ArchCurve(Jaw jaw)
{
    const int k = jaw == Jaw::Upper ? 0 : 1;
    const double c = std::pow(intercanineMm(jaw) / 2.0, 2);
    const double m = std::pow(intermolarMm(jaw) / 2.0, 2);
    const double determinant = c * m * m - c * c * m;
    const double a = (kCanineDepthMm[k] * m * m - kMolarDepthMm[k] * c * c) / determinant;
    const double b = (c * kMolarDepthMm[k] - m * kCanineDepthMm[k]) / determinant;
    // So fine that the total length of the chords is that of the curve.
    constexpr int kChordsAStep = 50;
    glm::dvec2 here(0.0);
    m_points.push_back(here);
    for (int step = 1; step * kStepMm < kLengthMm * kChordsAStep; ++step) {
        const double slope = 2.0 * a * here.x + 4.0 * b * here.x * here.x * here.x;
        const double x = here.x + kStepMm / kChordsAStep / std::sqrt(1.0 + slope * slope);
        here = {x, a * x * x + b * x * x * x * x};
        if (step % kChordsAStep == 0)
            m_points.push_back(here);
    }
}

glm::dvec2 ArchCurve::point(double alongMm) const
{
    const double place = alongMm / kStepMm;
    const int k = std::clamp(static_cast<int>(std::floor(place)), 0, static_cast<int>(m_points.size()) - 2);
    const glm::dvec2 from = m_points[static_cast<std::size_t>(k)];
    return from + (m_points[static_cast<std::size_t>(k) + 1] - from) * (place - k);
}

glm::dvec2 ArchCurve::tangent(double alongMm) const
{
    // Computes the direction over half a millimetre. At the midline it is straight across.
    const double along = std::max(alongMm, 0.0);
    const glm::dvec2 before = along < 0.25 ? point(0.25 - along) * glm::dvec2(-1.0, 1.0) : point(along - 0.25);
    return glm::normalize(point(along + 0.25) - before);
}

glm::dvec2 ArchCurve::outward(double alongMm) const
{
    const glm::dvec2 t = tangent(alongMm);
    return {t.y, -t.x};
}

ArchPlace ArchCurve::placeOf(glm::dvec2 where) const
{
    // Searches coarsely first, then finely around the best point.
    const int last = static_cast<int>(m_points.size()) - 1;
    const auto apart = [&](int k) {
        const glm::dvec2 d = where - m_points[static_cast<std::size_t>(k)];
        return glm::dot(d, d);
    };
    constexpr int kStride = 16;
    int best = 0;
    for (int k = 0; k <= last; k += kStride)
        if (apart(k) < apart(best))
            best = k;
    const int begin = std::max(best - kStride, 0);
    const int end = std::min(best + kStride, last);
    for (int k = begin; k <= end; ++k)
        if (apart(k) < apart(best))
            best = k;
    const glm::dvec2 t = tangent(best * kStepMm);
    const glm::dvec2 d = where - m_points[static_cast<std::size_t>(best)];
    return {best * kStepMm + glm::dot(d, t), glm::dot(d, glm::dvec2(t.y, -t.x))};
}

}  // namespace core::teeth
