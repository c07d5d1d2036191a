// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "core/terrain/Rasteriser.h"

namespace core::teeth {

/// Returns the neighbouring teeth of a tooth in its arch (Arch::neighbours) as height maps in its tooth frame, to
/// detect contact with a bur. Null for a number that is not one of the sixteen. Built once for each tooth, in some
/// hundred milliseconds; any thread but the ui thread.
[[nodiscard]] std::shared_ptr<const terrain::HeightMaps> teethBeside(int fdi);

}  // namespace core::teeth
