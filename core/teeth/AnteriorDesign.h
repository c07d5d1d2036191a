// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "core/teeth/RootDesign.h"

namespace core::teeth {

/// Nine values at even steps, with a smooth curve between them.
using Curve = std::array<double, 9>;

/// The parameters of the crown of an incisor or canine. Mean tooth, mm; x from mesial to distal, y towards the lip. The
/// values of 21 were fitted to a scan, the others follow the anatomy of docs/teeth.md.
struct AnteriorDesign
{
    // Silhouettes from the incisal edge (first value) to the CEJ (last).
    Curve mesialX{};
    Curve distalX{};
    Curve labialY{};
    Curve lingualY{};  ///< along the marginal ridges and the cingulum, as if there were no fossa
    // Shape of the sections: superellipse powers at the edge, in the middle and at the CEJ.
    std::array<double, 3> labialPower{3.0, 2.6, 2.2};
    std::array<double, 3> lingualPower{3.0, 2.2, 2.0};
    double lingualTaper = 0.2;  ///< share by which the section narrows towards the cingulum
    Curve edgeZ{};              ///< incisal edge from its mesial to its distal corner, 0 at the highest point
    double fossaMm = 0.5;       ///< depth of the lingual fossa (beside the lingual ridge, where there is one)
    double fossaFrom = 0.03;    ///< its start and end, share of the crown from the edge
    double fossaTo = 0.72;
    double fossaHalf = 0.72;  ///< half its width, in the middle, share of the half crown; the rest is marginal ridge
    double lingualRidgeMm = 0.0;
    double cingulumX = 0.0;  ///< the cingulum's summit, distal of the middle
    double labialRidgeMm = 0.0;
    double labialGrooveMm = 0.05;  ///< two shallow furrows between the three labial lobes
    double pitMm = 0.0;            ///< lingual pit above the cingulum
    RootDesign roots;
};

/// Returns the mean design of an incisor or canine: 21-23 and 31-33.
[[nodiscard]] AnteriorDesign anteriorDesign(int fdi);

}  // namespace core::teeth
