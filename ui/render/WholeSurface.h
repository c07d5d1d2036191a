// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include <glm/vec3.hpp>

#include "core/terrain/Tooth.h"
#include "ui/render/ToothSurface.h"

namespace ui::render {

/// Computes the drawn surface of an uncut tooth in advance: about 0.1 s for a usual lattice, 0.3 s for the finest. Any
/// thread but the ui thread.
/// @param towardsLight  unit vector to the operating light, tooth frame, z > 0
void workOutSurface(const std::shared_ptr<const core::terrain::ToothAnatomy>& anatomy, glm::vec3 towardsLight);

/// Returns the drawn surface of an uncut tooth, to show and cut. Copies it in a few milliseconds if it was computed for
/// one of the last two teeth; otherwise computes it now. For another light, part of it is computed again. Any thread.
/// Parameters as above.
[[nodiscard]] std::unique_ptr<ToothSurface>
wholeSurface(const std::shared_ptr<const core::terrain::ToothAnatomy>& anatomy, glm::vec3 towardsLight);

}  // namespace ui::render
