// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "core/bur/Bur.h"
#include "core/terrain/Tooth.h"

namespace core::bur {

/// Returns the lowest height of the tip of any bur on a tooth, mm in its frame: there the head of the handpiece touches
/// the highest cusp.
[[nodiscard]] inline double lowestTipMm(const terrain::ToothAnatomy& anatomy)
{
    return static_cast<double>(*std::max_element(anatomy.top.begin(), anatomy.top.end())) - kChuckMm;
}

}  // namespace core::bur
