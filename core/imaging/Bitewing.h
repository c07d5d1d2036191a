// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/base/Result.h"
#include "core/imaging/Radiograph.h"

namespace core::imaging {

/// A tooth that stands beside another.
struct Neighbour
{
    terrain::Tooth tooth;
    glm::dvec3 placeMm{0.0};  ///< of its origin, in the frame of the tooth it stands beside
    bool mirrored = false;    ///< a tooth of the other side of the mouth: the model is of its twin
    [[nodiscard]] XrayedTooth xrayed() const { return {&tooth, placeMm, mirrored}; }
};

/// The sound teeth mesial and distal of a generated one, of the same person (seed) and on the default grid, so far
/// along x that their outlines touch; the rows of an arch are straight here and all tips equally high. A central
/// incisor has the mirrored one of the other side, a third molar nothing behind it. Some 100 ms; any thread that may
/// wait. UnknownName for a scan: nobody knows which side of it is mesial. OutOfRange for a
/// tooth that lies on a side.
[[nodiscard]] Result<std::vector<Neighbour>> neighboursOf(const terrain::ToothAnatomy& anatomy);

/// The film of a bitewing: crowns and necks of the tooth with as much of its neighbours as a size 2 film is wide, 41 mm
/// by 31, of which the upper half belongs to the other jaw.
[[nodiscard]] FilmArea bitewingArea(std::span<const XrayedTooth> teeth, const Beam& beam);

}  // namespace core::imaging
