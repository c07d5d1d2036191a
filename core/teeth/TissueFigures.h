// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "core/teeth/ToothTable.h"
#include "core/terrain/Grid.h"

namespace core::teeth {

enum class ToothKind { Incisor, Canine, Premolar, Molar };

/// Sizes of the layers of a tooth, mm. Means of docs/teeth.md (a micro-CT molar, Deutsch and Musikant 2004, textbooks).
struct TissueFigures
{
    ToothKind kind = ToothKind::Molar;
    ToothSizes sizes;              ///< of the mean tooth
    double crownHeight = 0.0;      ///< highest point to the CEJ on the facial side, of this tooth
    double enamelPerHeight = 0.0;  ///< increase of lateral enamel with the height above the CEJ
    double cuspEnamel = 0.0;       ///< at the cusp tip, normal to the surface
    double fossaEnamel = 0.0;      ///< at the floor of the fossa beside a fissure
    double edgeEnamel = 0.0;       ///< at an incisal edge, along the axis; 0: no edge
    double pulpWall = 0.0;         ///< root surface to pulp at the cervix, on the buccal and lingual side
    double mesialWall = 0.0;       ///< the same on the mesial and distal side
    double distalWall = 0.0;
    double pulpTaperDeg = 0.0;   ///< the buccal and lingual walls of the chamber converge distally, each by this angle
    double tipToHorn = 0.0;      ///< cusp tip or incisal edge to the pulp horn under it
    double hornHeight = 0.0;     ///< of the horn above the chamber's roof
    double fossaToPulp = 0.0;    ///< central fossa, with its fissures filled, to the pulp in any direction; 0: no
                                 ///< occlusal table
    double chamberHeight = 0.0;  ///< roof to floor; 0: no floor, the chamber narrows into the canal
    int mesialCanals = 1;        ///< canals in the mesial root of a lower molar
};

/// Returns the sizes for an FDI number, 11 to 48. With 0 or any other number: those of the kind that the crown
/// resembles, by its size and by the part of it near its highest point.
[[nodiscard]] TissueFigures figuresFor(int fdi, const terrain::Grid& grid, std::span<const float> top);

}  // namespace core::teeth
