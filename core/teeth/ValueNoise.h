// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "core/base/Rng.h"

namespace core::teeth {

/// A smooth random field in [-1, 1] over the plane: seeded values on a repeating 16 x 16 lattice, blended by
/// smoothstep. No transcendental function, so a seed gives the same field with every library. Seed 0 is the zero field:
/// the tooth of the tables, without a person's variation.
class ValueNoise
{
public:
    ValueNoise(std::uint64_t seed, double wavelengthMm) : m_perMm(1.0 / wavelengthMm)
    {
        Rng rng(seed);
        for (double& value : m_values)
            value = seed == 0 ? 0.0 : rng.uniform(-1.0, 1.0);
    }

    [[nodiscard]] double at(double xMm, double yMm) const
    {
        const double x = xMm * m_perMm;
        const double y = yMm * m_perMm;
        const double x0 = std::floor(x);
        const double y0 = std::floor(y);
        const double fx = blend(x - x0);
        const double fy = blend(y - y0);
        const auto i = static_cast<std::int64_t>(x0);
        const auto j = static_cast<std::int64_t>(y0);
        const double near = value(i, j) + (value(i + 1, j) - value(i, j)) * fx;
        const double far = value(i, j + 1) + (value(i + 1, j + 1) - value(i, j + 1)) * fx;
        return near + (far - near) * fy;
    }

private:
    static constexpr std::int64_t kSide = 16;

    static double blend(double t) { return t * t * (3.0 - 2.0 * t); }
    [[nodiscard]] double value(std::int64_t i, std::int64_t j) const
    {
        const auto column = static_cast<std::size_t>(i & (kSide - 1));
        const auto row = static_cast<std::size_t>(j & (kSide - 1));
        return m_values[row * kSide + column];
    }

    double m_perMm;
    std::array<double, kSide * kSide> m_values{};
};

}  // namespace core::teeth
