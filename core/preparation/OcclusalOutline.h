// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include <glm/vec2.hpp>

#include "core/base/Result.h"
#include "core/preparation/ToothDesign.h"
#include "core/teeth/PosteriorForm.h"

namespace core::preparation {

/// One cavity of an occlusal preparation seen from above: strokes of the bur's axis, and the level of its floor. Tooth
/// frame, mm. Derived from the tooth's design, so that it is the same on every grid.
struct OcclusalCavity
{
    /// A place of the axis, and the width beside it that the axis covers.
    struct Spot
    {
        glm::dvec2 atMm{0.0};
        double halfMm = 0.0;
    };
    std::vector<std::vector<Spot>> strokes;  ///< joined with rounds; empty for a slot
    double floorMm = 0.0;
    /// x of the axis' ends, beyond which the end walls lean outwards; empty if there is no such wall.
    std::optional<double> mesialEndX;
    std::optional<double> distalEndX;
    struct Isthmus
    {
        glm::dvec2 atMm{0.0};
        glm::dvec2 across{0.0, 1.0};
        double lengthMm = 0.5;
    };
    std::optional<Isthmus> isthmus;
    /// The middle of a box on the tooth's outline, and the direction out of the tooth there.
    struct Box
    {
        glm::dvec2 atMm{0.0};
        glm::dvec2 outwards{1.0, 0.0};
    };
    std::optional<Box> box;
};

/// Returns the cavities of a Class I on this tooth, along its grooves. For a Class II the end at the box continues into
/// the box, and so does the mesiobuccal groove of a Class I with a buccal extension. A slot is a box without strokes,
/// and its `floorMm` is the height of the marginal ridge. Teeth with a ridge across (26, 27, 34) have two cavities, one
/// on each side. The error names the number that leaves no room.
[[nodiscard]] Result<std::vector<OcclusalCavity>> occlusalCavities(Kind kind, int fdi, const teeth::PosteriorForm& form,
                                                                   const ToothDesign& design);

/// Returns the distance to two strokes joined with a round, from the distances to each, mm: the quadratic smooth
/// minimum.
[[nodiscard]] double roundJoin(double a, double b);

/// Returns the crest of an upper first or second molar's oblique ridge, from the mesiolingual to the distobuccal cusp;
/// empty for other teeth.
[[nodiscard]] std::vector<glm::dvec2> obliqueCrest(int fdi, const teeth::PosteriorForm& form);

}  // namespace core::preparation
