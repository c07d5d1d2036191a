// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace ui::render {

/// Colours of the materials: natural, or clearly distinct and with patterns.
enum class Palette : std::uint8_t { Natural, Distinct };

/// What the depth colours show: nothing, the depth of a cut below the original surface, or the distance of the surface
/// above or below the ideal preparation.
enum class DepthColours : std::uint8_t { Off, BelowOriginal, AgainstIdeal };

/// End of the scale below the original surface, mm. The deepest cavities that are taught reach the pulp.
inline constexpr double kDepthScaleMm = 3.0;
/// Both ends of the scale around the ideal, mm.
inline constexpr double kIdealScaleMm = 1.0;

/// The appearance of the tooth.
struct Look
{
    Palette palette = Palette::Natural;
    bool isWet = false;
    bool burLight = false;  ///< a light at the head of the handpiece, and the shadows it casts in a cavity
    DepthColours depthColours = DepthColours::Off;
    bool idealOutline = false;  ///< a line on the uncut surface around the area that the ideal preparation removes
    bool operator==(const Look&) const = default;
};

/// A dental mirror: a plane, round front-surface mirror.
struct DentalMirror
{
    glm::dvec3 centreMm{0.0};
    glm::dvec3 normal{0.0, 0.0, 1.0};  ///< unit vector, away from the reflecting side

    static constexpr double kRadiusMm = 9.0;  ///< size 2

    /// Returns the mirror image of a point.
    [[nodiscard]] glm::dvec3 image(const glm::dvec3& pointMm) const
    {
        return pointMm - normal * (2.0 * glm::dot(pointMm - centreMm, normal));
    }
    /// Returns the reflection as a matrix, tooth from tooth.
    [[nodiscard]] glm::dmat4 imageMatrix() const
    {
        const glm::dmat3 turned = glm::dmat3(1.0) - 2.0 * glm::outerProduct(normal, normal);
        glm::dmat4 matrix(turned);
        matrix[3] = glm::dvec4(normal * (2.0 * glm::dot(centreMm, normal)), 1.0);
        return matrix;
    }
    bool operator==(const DentalMirror&) const = default;
};

}  // namespace ui::render
