// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

#include <glm/vec2.hpp>

#include "core/grading/Deviation.h"
#include "core/grading/Outline.h"

namespace core::grading {

/// atan in degrees, from the four operations and the square root alone, to 1e-11 degrees.
[[nodiscard]] double atanDeg(double tangent);

/// The form of a cut, or of an ideal.
struct CutSurface
{
    const terrain::ToothAnatomy& anatomy;
    std::span<const float> end;  ///< heights at which the columns end, between top and bottom where there is tooth
    const Outline& outline;      ///< of `end`
};

/// @param ideal  says across which lines the isthmus is looked for: those that cross the ideal
[[nodiscard]] std::optional<Placed> isthmusOf(const CutSurface& cut, const Preparation::Isthmus& isthmus,
                                              const Outline& ideal);

/// Form::axialDepthMm.
[[nodiscard]] std::optional<Placed> axialDepthOf(const CutSurface& cut, const Preparation::Box& box);

/// Form::obliqueRidgeMm.
[[nodiscard]] std::optional<Placed> obliqueRidgeOf(const CutSurface& cut, std::span<const glm::dvec2> crest);

/// Distance along x from the cut to the tooth's outline, towards -x (sign -1) or +x (sign 1).
[[nodiscard]] std::optional<Placed> ridgeOf(const CutSurface& cut, int sign);

/// Sets Form::wallDeg.
void measureWalls(const CutSurface& cut, Form& form);

}  // namespace core::grading
