// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scoring/ScoredWork.h"

#include <algorithm>
#include <cmath>

#include "core/grading/Columns.h"

namespace ui::scoring {

float aboveIdeal(const ScoredWork& work, std::size_t k)
{
    const core::terrain::ToothAnatomy& anatomy = *work.tooth->anatomy;
    if (!core::grading::wasSolid(anatomy, k))
        return 0.0F;
    // An ideal may ask for more material to be removed than the column has.
    const float ideal =
        work.ideal == nullptr ? anatomy.top[k] : std::clamp((*work.ideal)[k], anatomy.bottom[k], anatomy.top[k]);
    return core::grading::endOf(*work.tooth, k) - ideal;
}

std::optional<std::size_t> farthestOff(const ScoredWork& work)
{
    std::optional<std::size_t> found;
    float most = 0.0F;
    for (std::size_t k = 0; k < work.tooth->top.size(); ++k)
        if (const float off = std::abs(aboveIdeal(work, k)); off > most) {
            most = off;
            found = k;
        }
    return found;
}

}  // namespace ui::scoring
