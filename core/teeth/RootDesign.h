// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace core::teeth {

/// One root, in the design frame of its tooth (x mesial to distal, y towards the cheek), mm.
struct RootBranch
{
    double apexX = 0.0;
    double apexY = 0.0;
    double lengthShare = 1.0;  ///< of the tooth's root length
    double halfX = 1.5;        ///< semi-axes of the section just below the furcation
    double halfY = 3.0;
    double bendX = 0.0;  ///< distance of the middle from the straight line
    double bendY = 0.0;
};

/// The roots of a tooth. Several roots separate at the furcation, at the given angles.
struct RootDesign
{
    std::vector<RootBranch> branches;
    std::vector<double>
        partingDeg;         ///< angles between neighbours, ascending; empty for one root. Branch k follows angle k.
    double trunkMm = 4.0;   ///< from the CEJ to the furcation
    double hollowMm = 0.0;  ///< depth of the long concavities on the mesial and distal side of a single root
};

}  // namespace core::teeth
