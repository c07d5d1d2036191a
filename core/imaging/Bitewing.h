// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/base/Result.h"
#include "core/imaging/Radiograph.h"

namespace core::imaging {

/// A tooth beside another.
struct Neighbour
{
    terrain::Tooth tooth;
    glm::dvec3 placeMm{0.0};  ///< of its origin, in the frame of the other tooth
    bool mirrored = false;    ///< a tooth of the other side of the mouth: the model is that of its mirror twin
    [[nodiscard]] XrayedTooth xrayed() const { return {&tooth, placeMm, mirrored}; }
};

/// Returns the sound teeth mesial and distal of a generated one, of the same person (seed) and on the default grid,
/// shifted along x so that their outlines touch; the row is straight and all tips have the same height. A central
/// incisor has the mirrored one of the other side, a third molar no distal neighbour. About 100 ms; any thread but the
/// ui thread. UnknownName for a scan, whose mesial side is unknown. OutOfRange for a tooth on its side.
[[nodiscard]] Result<std::vector<Neighbour>> neighboursOf(const terrain::ToothAnatomy& anatomy);

/// Returns the film of a bitewing: crowns and necks of the tooth with as much of its neighbours as a size 2 film is
/// wide, 41 mm by 31, of which the upper half belongs to the other jaw.
[[nodiscard]] FilmArea bitewingArea(std::span<const XrayedTooth> teeth, const Beam& beam);

}  // namespace core::imaging
