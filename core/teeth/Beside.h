// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "core/terrain/Rasteriser.h"

namespace core::teeth {

/// The teeth beside one of ours, where they stand in an arch (Arch::neighbours), as height maps in its tooth frame: for
/// whether a bur touches them. Null for a number that is not one of the sixteen. Made once for each tooth, in some
/// hundred milliseconds; any thread that may wait.
[[nodiscard]] std::shared_ptr<const terrain::HeightMaps> teethBeside(int fdi);

}  // namespace core::teeth
