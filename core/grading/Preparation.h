// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>

#include "core/grading/IdealCavity.h"

namespace core::grading {

/// The part of an ideal preparation that a column belongs to.
enum class Part : std::uint8_t {
    Keep,   ///< not to be cut
    Floor,  ///< the pulpal floor, or the floor of a trench
    Wall    ///< between floor and margin: a wall that leans outwards, a step
};

/// An ideal preparation over the grid of one anatomy. Shared by view and grading.
struct Preparation
{
    IdealTop top;             ///< never null; equals the anatomy's top where a part is Keep
    std::vector<Part> parts;  ///< [side * side]
    /// The place of the isthmus: its width is the shortest run of cut columns across this place; tooth frame, mm. Empty
    /// for shapes without one.
    struct Isthmus
    {
        glm::dvec2 atMm{};
        glm::dvec2 across{0.0, 1.0};  ///< unit vector along which the width is measured
        double lengthMm = 1.0;        ///< the isthmus is searched up to this distance on both sides, at right angles to
                                      ///< `across`
    };
    std::optional<Isthmus> isthmus;
    /// A box that is open to the outside of the tooth: the end of a Class II, a slot, a buccal step. Tooth frame, mm.
    /// Empty for preparations without one, and for captured ones.
    struct Box
    {
        glm::dvec2 atMm{};              ///< the middle of its opening, on the outline of the tooth
        glm::dvec2 outwards{1.0, 0.0};  ///< unit vector out of the tooth
        double widthMm = 1.0;           ///< at right angles to `outwards`
        double floorMm = 0.0;           ///< height of its gingival floor
    };
    std::optional<Box> box = {};
    /// The crest of the oblique ridge, which must stay; tooth frame, mm. Empty for teeth without one, and for captured
    /// ideals.
    std::vector<glm::dvec2> obliqueCrest = {};
};

}  // namespace core::grading
