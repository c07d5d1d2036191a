// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include <glm/vec3.hpp>

#include "core/terrain/Tooth.h"
#include "ui/render/ToothSurface.h"

namespace ui::render {

/// Works out how a whole tooth is drawn, a tenth of a second for a usual lattice and a third for the finest that is
/// drawn: whoever shows it afterwards need not. Any thread that may wait.
/// @param towardsLight  unit vector to the operating light, tooth frame, z > 0
void workOutSurface(const std::shared_ptr<const core::terrain::ToothAnatomy>& anatomy, glm::vec3 towardsLight);

/// A whole tooth to show and cut: a copy of what was worked out of it, a few milliseconds, if it is one of the last two
/// teeth; else it is worked out now. Any thread. Parameters as above; for another light some of it is done again.
[[nodiscard]] std::unique_ptr<ToothSurface>
wholeSurface(const std::shared_ptr<const core::terrain::ToothAnatomy>& anatomy, glm::vec3 towardsLight);

}  // namespace ui::render
