// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "core/base/Result.h"

namespace core::teeth {

/// Mean sizes of one tooth, mm (Wheeler / Ash, table 1-1). Left and right are mirror images.
struct ToothSizes
{
    int fdi = 0;
    double crownHeightMm = 0.0;     ///< facial side, from the cemento-enamel junction (CEJ) to the tip, along the axis
    double rootLengthMm = 0.0;      ///< facial side, CEJ to apex
    double crownWidthMm = 0.0;      ///< greatest mesiodistal extent
    double cervixWidthMm = 0.0;     ///< mesiodistal at the CEJ
    double crownDepthMm = 0.0;      ///< greatest buccolingual (labiolingual) extent
    double cervixDepthMm = 0.0;     ///< buccolingual at the CEJ
    double cejCurveMesialMm = 0.0;  ///< rise of the CEJ line towards the tip on the mesial side
    double cejCurveDistalMm = 0.0;  ///< the same, distal
};

/// Standard deviations between people (docs/teeth.md), mm.
inline constexpr double kCrownDiameterSdMm = 0.5;
inline constexpr double kCrownHeightSdMm = 0.8;
inline constexpr double kRootLengthSdMm = 1.5;

/// Returns the sixteen teeth of the left side: 21 to 28, then 31 to 38.
[[nodiscard]] std::span<const ToothSizes> toothSizes();

/// Returns the sizes of one tooth by its FDI number; UnknownName for numbers other than 21-28 and 31-38.
[[nodiscard]] Result<ToothSizes> findToothSizes(int fdi);

/// Returns the direction of buccal (labial) along +y of the tooth frame: +1 for upper left teeth, -1 for lower left
/// ones.
///
/// The frame is right-handed with +z occlusal and +x from mesial to distal; on the patient's left that makes +y point
/// to the cheek above and to the tongue below.
[[nodiscard]] double buccalSign(int fdi);

}  // namespace core::teeth
