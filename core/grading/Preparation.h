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
    /// A box that is open to the outside of the tooth: the end of a Class II, a slot, a step to the buccal. Tooth
    /// frame, mm. Nothing for preparations without one, and for captured ones.
    struct Box
    {
        glm::dvec2 atMm{};              ///< the middle of its opening, on the outline of the tooth
        glm::dvec2 outwards{1.0, 0.0};  ///< unit vector out of the tooth
        double widthMm = 1.0;           ///< at right angles to `outwards`
        double floorMm = 0.0;           ///< height of its gingival floor
    };
    std::optional<Box> box = {};
    /// The crest of the oblique ridge, which is to be left; tooth frame, mm. Empty for teeth without one, and for
    /// captured ideals.
    std::vector<glm::dvec2> obliqueCrest = {};
};

}  // namespace core::grading
