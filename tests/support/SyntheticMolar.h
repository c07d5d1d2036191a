// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "core/terrain/Tooth.h"

namespace support {

/// Returns a molar-like crown from closed formulas: five cusps, a cross of fissures, enamel over dentin over a pulp
/// chamber, and one open lesion around kLesionMm. It needs neither the generator nor a file, and is used to test
/// pictures. It is made once for each side. Main thread.
[[nodiscard]] std::shared_ptr<const core::terrain::ToothAnatomy> syntheticMolar(int side = 150);

/// Middle of the lesion and its radius, tooth frame.
inline constexpr double kLesionX = 0.3;
inline constexpr double kLesionY = -0.1;
inline constexpr double kLesionRadiusMm = 0.9;

}  // namespace support
