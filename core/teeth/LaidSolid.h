// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <utility>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/teeth/Laid.h"
#include "core/terrain/Tooth.h"

namespace core::teeth {

/// A layer of an upright tooth, its pulp or its decay, as a solid for a tooth placed on a side.
class LaidSolid
{
public:
    using Height = float terrain::ColumnLayers::*;

    /// @param laid  must outlive this
    /// @param roof, floor  of the layer, such as &terrain::ColumnLayers::pulpRoof
    LaidSolid(const LaidTooth& laid, Height roof, Height floor);

    /// Returns roof and floor of the first part of the solid that a bur at `atMm` meets on its way from `top` down to
    /// `bottom`, mm in the frame in which the tooth is cut; empty if there is none. A roof next to the surface becomes
    /// the surface.
    [[nodiscard]] std::optional<std::pair<float, float>> along(glm::dvec2 atMm, float top, float bottom) const;

private:
    [[nodiscard]] bool holds(const glm::dvec3& ownMm) const;

    const LaidTooth& m_laid;
    Height m_roof;
    Height m_floor;
    glm::dvec3 m_lowMm{1.0e9};  ///< of its bounding box, in the frame in which the tooth is cut
    glm::dvec3 m_highMm{-1.0e9};
};

}  // namespace core::teeth
