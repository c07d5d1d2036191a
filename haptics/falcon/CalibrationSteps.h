// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/falcon/Calibration.h"

/// Calibration of a Falcon with a ruler and a weight. Any thread.
namespace haptics::falcon {

/// Computes the angle at the index marks, the same for all three arms. The inputs are two positions of the grip and
/// their distance along the axis, measured with a ruler: pushed in fully, and 60 mm farther out. In this range, half a
/// millimetre on the ruler is one degree. (From 95 to 155 mm the distance hardly depends on the angle.)
/// @param nearMm, farMm  positions of the grip, device frame, computed with this calibration
/// @returns the calibration with new angles at the index marks. Error OutOfRange if no angle from 15 to 55 degrees
/// explains the distance.
[[nodiscard]] core::Result<Calibration> withDistance(const Calibration& calibration, const glm::dvec3& nearMm,
                                                     const glm::dvec3& farMm, double distanceMm);

/// Computes the scale of the motor commands from the forces that held the grip without and with a weight on it.
/// @param emptyN, loadedN  upward force as sent with this calibration
/// @returns the calibration with a new scale and the weight of the grip. Error OutOfRange if that is impossible for a
/// Falcon.
[[nodiscard]] core::Result<Calibration> withWeight(const Calibration& calibration, double emptyN, double loadedN,
                                                   double weightN);

}  // namespace haptics::falcon
