// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/terrain/Tooth.h"

namespace core::imaging {

/// Adds root canals to a tooth, for X-ray pictures and sections: they continue the pulp and taper down to the apex of
/// each root. The mesial root of a lower first or second molar has two, every other root one (docs/teeth.md).
/// The model itself ends its pulp where vertical columns cannot follow a canal. Canals are added only where no bur
/// comes, so what is drilled and measured does not change.
///
/// The canals of an anatomy are computed once, in about 20 ms at 150 x 150. Any thread but the ui thread. Returns a
/// tooth without pulp or without roots unchanged.
[[nodiscard]] terrain::Tooth withCanals(terrain::Tooth tooth);

}  // namespace core::imaging
