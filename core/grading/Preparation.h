// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>

#include "core/grading/IdealCavity.h"

namespace core::grading {

/// What a column of an ideal preparation is.
enum class Part : std::uint8_t {
    Keep,   ///< is not to be cut
    Floor,  ///< the pulpal floor, or the floor of a trench
    Wall    ///< between floor and cavosurface: a wall that leans outwards, a step
};

/// A preparation as it ought to be when the work is done, over the grid of one anatomy. Shared by view and grading.
struct Preparation
{
    IdealTop top;             ///< never null; equals the anatomy's top where a part is Keep
    std::vector<Part> parts;  ///< [side * side]
    /// Where the isthmus is: its width is the shortest run of cut columns across this place; tooth frame, mm. Nothing
    /// for shapes without one.
    struct Isthmus
    {
        glm::dvec2 atMm{};
        glm::dvec2 across{0.0, 1.0};  ///< unit vector along which the width is measured
        double lengthMm = 1.0;        ///< the isthmus is looked for so far to both sides, at right angles to `across`
    };
    std::optional<Isthmus> isthmus;
};

}  // namespace core::grading
