// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/BandPass.h"

#include <cmath>
#include <numbers>

namespace lab {

BandPass::BandPass(double tickS)
{
    // Bilinear transform of 1 / (s^2 + s/q + 1) and s^2 / (...).
    const auto section = [tickS](double hz, double q, bool high) {
        const double k = std::tan(std::numbers::pi * hz * tickS);
        const double norm = 1.0 / (1.0 + k / q + k * k);
        const double gain = (high ? 1.0 : k * k) * norm;
        return Section{gain, (high ? -2.0 : 2.0) * gain, gain, 2.0 * (k * k - 1.0) * norm,
                       (1.0 - k / q + k * k) * norm};
    };
    m_sections = {section(20.0, 0.541196, true), section(20.0, 1.306563, true), section(300.0, 0.707107, false)};
}

glm::dvec3 BandPass::operator()(const glm::dvec3& forceN)
{
    glm::dvec3 value = forceN;
    for (Section& section : m_sections) {
        const glm::dvec3 out = section.b0 * value + section.s1;
        section.s1 = section.b1 * value - section.a1 * out + section.s2;
        section.s2 = section.b2 * value - section.a2 * out;
        value = out;
    }
    return value;
}

}  // namespace lab
