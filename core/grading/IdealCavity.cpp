// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grading/IdealCavity.h"

#include <algorithm>

namespace core::grading {

IdealTop idealCavity(const terrain::ToothAnatomy& anatomy)
{
    std::vector<float> top = anatomy.top;
    bool isAsked = false;
    for (std::size_t k = 0; k < top.size(); ++k) {
        const terrain::ColumnLayers& column = anatomy.layers[k];
        const float floor = std::max(column.cariesFloor, anatomy.bottom[k]);
        // A lesion that reaches up beyond the surface is open; one that begins there has nothing inside the tooth.
        if (column.cariesRoof <= column.cariesFloor || floor >= top[k] || column.cariesRoof <= anatomy.bottom[k])
            continue;
        top[k] = floor > anatomy.bottom[k] ? floor : terrain::kEmptyTop;
        isAsked = true;
    }
    return isAsked ? std::make_shared<const std::vector<float>>(std::move(top)) : nullptr;
}

}  // namespace core::grading
