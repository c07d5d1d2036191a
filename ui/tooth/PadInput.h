// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec2.hpp>

#include "core/session/ControllerReport.h"

namespace ui::tooth {

/// Movement that a gamepad requests of the bur and the view.
struct PadInput
{
    glm::dvec2 move{0.0};  ///< of the bur: to the right and away from the eye, shares of the fastest, -1 to 1
    glm::dvec2 turn{0.0};  ///< of the eye: to the right and up, the same
    double press = 0.0;    ///< share of the force; 0: the bur does not push
    bool operator==(const PadInput&) const = default;
};

/// Reads the sticks and the right trigger. A stick that drifts by less than a fifth of its way, or a trigger by less
/// than a tenth, asks for nothing; nor does a reading that is not finite. Slow movements have more of the way.
[[nodiscard]] PadInput padInput(const core::session::Controller& gamepad);

}  // namespace ui::tooth
