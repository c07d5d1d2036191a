// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grading/IdealCavity.h"

#include <algorithm>

#include "core/grading/LesionCut.h"
#include "core/terrain/DecayZones.h"

namespace core::grading {
namespace {

constexpr float kRoundingMm = 1.0e-4F;  ///< heights are rounded to floats: no decay is counted at the junction below
                                        ///< this

}  // namespace

bool isOverPulp(const terrain::ToothAnatomy& anatomy, std::size_t k)
{
    const terrain::ColumnLayers& column = anatomy.layers[k];
    return terrain::hasPulp(anatomy, k) && column.cariesFloor - column.pulpRoof <= kOverPulpMm;
}

float decayGoesDownTo(const terrain::ToothAnatomy& anatomy, std::size_t k)
{
    const terrain::ColumnLayers& column = anatomy.layers[k];
    if (!anatomy.hasDecayZones)
        return column.cariesFloor;
    const terrain::DecayZones zones = terrain::decayZonesOf(anatomy, k);
    const float stop = isOverPulp(anatomy, k) ? zones.leatheryRoof : zones.firmRoof;
    const float belowJunction = column.dej - static_cast<float>(kAtJunctionMm) - kRoundingMm;
    return std::max(column.cariesFloor, std::min(stop, belowJunction));
}

IdealTop idealCavity(const terrain::ToothAnatomy& anatomy)
{
    std::vector<float> top = anatomy.top;
    bool isAsked = false;
    for (std::size_t k = 0; k < top.size(); ++k) {
        const terrain::ColumnLayers& column = anatomy.layers[k];
        const float down = decayGoesDownTo(anatomy, k);
        const float floor = std::max(down, anatomy.bottom[k]);
        // A lesion whose roof is above the surface is open. If it begins above the surface, none of it is inside the
        // tooth.
        if (column.cariesRoof <= down || floor >= top[k] || column.cariesRoof <= anatomy.bottom[k])
            continue;
        top[k] = floor > anatomy.bottom[k] ? floor : terrain::kEmptyTop;
        isAsked = true;
    }
    return isAsked ? std::make_shared<const std::vector<float>>(std::move(top)) : nullptr;
}

}  // namespace core::grading
