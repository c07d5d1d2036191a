// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include <glm/vec3.hpp>

namespace lab {

/// Filters the part of a force that a fingertip feels as trembling: Butterworth of 4th order above 20 Hz and of 2nd
/// order below 300 Hz, for each axis. The steep side excludes the slow sway of hand and spring, 2 to 17 Hz.
class BandPass
{
public:
    explicit BandPass(double tickS);
    glm::dvec3 operator()(const glm::dvec3& forceN);

private:
    /// Second-order section, transposed direct form II.
    struct Section
    {
        double b0, b1, b2, a1, a2;
        glm::dvec3 s1{0.0};
        glm::dvec3 s2{0.0};
    };
    std::array<Section, 3> m_sections;
};

}  // namespace lab
