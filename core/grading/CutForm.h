// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

#include <glm/vec2.hpp>

#include "core/grading/Deviation.h"
#include "core/grading/Outline.h"

namespace core::grading {

/// Returns the arc tangent in degrees, exact to 1e-11 degrees, from the four basic operations and the square root only.
[[nodiscard]] double atanDeg(double tangent);

/// The surface of a cut, or of an ideal, for measuring its form.
struct CutSurface
{
    const terrain::ToothAnatomy& anatomy;
    std::span<const float> end;  ///< heights at which the columns end, between top and bottom where there is tooth
    const Outline& outline;      ///< of `end`
};

/// Measures Form::isthmusMm.
/// @param ideal  only lines that cross the ideal are searched
[[nodiscard]] std::optional<Placed> isthmusOf(const CutSurface& cut, const Preparation::Isthmus& isthmus,
                                              const Outline& ideal);

/// Measures Form::axialDepthMm.
[[nodiscard]] std::optional<Placed> axialDepthOf(const CutSurface& cut, const Preparation::Box& box);

/// Measures Form::obliqueRidgeMm.
[[nodiscard]] std::optional<Placed> obliqueRidgeOf(const CutSurface& cut, std::span<const glm::dvec2> crest);

/// Returns the distance along x from the cut to the tooth's outline, towards -x (sign -1) or +x (sign 1).
[[nodiscard]] std::optional<Placed> ridgeOf(const CutSurface& cut, int sign);

/// Sets Form::wallDeg.
void measureWalls(const CutSurface& cut, Form& form);

}  // namespace core::grading
