// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "core/terrain/Tooth.h"

namespace core::imaging {

/// The tooth as pictures of its inside show it: with root canals that go on from the pulp of the model and taper down
/// into each root. The model ends its canals where vertical columns cannot follow them. What a bur can reach is as in
/// the model; so are all figures, which never look at this.
///
/// Found once for each anatomy, some 20 ms at 150 x 150; any thread that may wait. A tooth without pulp, or without
/// roots, is returned as it is.
/// @param reachMm  height below which no bur comes (drilling::lowestTipMm)
[[nodiscard]] std::shared_ptr<const terrain::ToothAnatomy>
withCanals(const std::shared_ptr<const terrain::ToothAnatomy>& anatomy, double reachMm);

/// A tooth as it is cut, over that anatomy.
[[nodiscard]] terrain::Tooth withCanals(const terrain::Tooth& tooth, double reachMm);

}  // namespace core::imaging
