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
/// frame, mm. It comes from the tooth's own design, so that it is the same on every grid.
struct OcclusalCavity
{
    /// A place of the axis, and how far beside it the axis goes as well.
    struct Spot
    {
        glm::dvec2 atMm{0.0};
        double halfMm = 0.0;
    };
    std::vector<std::vector<Spot>> strokes;  ///< they flow into each other with a round; none of a slot
    double floorMm = 0.0;
    /// From here outwards the end walls lean: x of the axis' ends, where there is such a wall.
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

/// The cavities of a Class I on this tooth, following its grooves; for a Class II the end at the box goes on into it,
/// and so does the mesiobuccal groove of a Class I with an extension to the buccal. A slot is a box without strokes,
/// and its `floorMm` is the height of the marginal ridge. Of the teeth with a ridge across (26, 27, 34) two cavities,
/// one on each side. An error says which figure leaves no room.
[[nodiscard]] Result<std::vector<OcclusalCavity>> occlusalCavities(Kind kind, int fdi, const teeth::PosteriorForm& form,
                                                                   const ToothDesign& design);

/// Returns the distance to two strokes that flow into each other with a round, from the distances to each, mm: the
/// quadratic smooth minimum.
[[nodiscard]] double roundJoin(double a, double b);

/// The crest of an upper first or second molar's oblique ridge, from the mesiolingual to the distobuccal cusp; empty
/// for other teeth.
[[nodiscard]] std::vector<glm::dvec2> obliqueCrest(int fdi, const teeth::PosteriorForm& form);

}  // namespace core::preparation
