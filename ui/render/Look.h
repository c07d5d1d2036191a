// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace ui::render {

/// Colours of the materials: as a tooth has them, or such that nobody confuses them, with patterns besides.
enum class Palette : std::uint8_t { Natural, Distinct };

/// What the colours of depth tell: nothing, how far below the surface as it was a cut goes, or how far the tooth is
/// above or below the ideal preparation.
enum class DepthColours : std::uint8_t { Off, BelowOriginal, AgainstIdeal };

/// End of the scale below the original, mm: the deepest cavities that are taught reach the pulp.
inline constexpr double kDepthScaleMm = 3.0;
/// Either end of the scale about the ideal, mm.
inline constexpr double kIdealScaleMm = 1.0;

/// How the tooth is made to look.
struct Look
{
    Palette palette = Palette::Natural;
    bool isWet = false;
    bool burLight = false;  ///< a light at the handpiece's head, with the shadows that it throws into a cavity
    DepthColours depthColours = DepthColours::Off;
    bool idealOutline = false;  ///< a line around what the ideal preparation removes, on the uncut surface
    bool operator==(const Look&) const = default;
};

/// A dental mirror: a round plane glass, mirroring on its front.
struct DentalMirror
{
    glm::dvec3 centreMm{0.0};
    glm::dvec3 normal{0.0, 0.0, 1.0};  ///< unit vector, out of its mirroring side

    static constexpr double kRadiusMm = 9.0;  ///< size 2

    /// Where the mirror image of a point stands.
    [[nodiscard]] glm::dvec3 image(const glm::dvec3& pointMm) const
    {
        return pointMm - normal * (2.0 * glm::dot(pointMm - centreMm, normal));
    }
    /// The same as a matrix, tooth from tooth.
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
