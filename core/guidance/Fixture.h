// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "core/grading/IdealCavity.h"

namespace core::guidance {

/// A virtual fixture (Rosenberg 1993; Abbott, Marayong & Okamura 2007) that resists leaving the outline of a
/// preparation: a spring pulls the bur's axis sideways to where the bur cuts nothing beside the outline. The user can
/// overcome it, and it ends 3 mm beside the outline. It begins half a millimetre above the crown and has its full force
/// half a millimetre below the top: above the tooth the hand is free.
///
/// It acts on the hand only: it is no contact, it cuts nothing, and its force is not recorded. Immutable, so any thread
/// may use it.
class Fixture
{
public:
    /// Sideways stiffness; adds to that of contact (docs/facts/haptics.md, section 2.2).
    static constexpr double kNPerMm = 1.0;
    static constexpr double kMostN = 1.5;    ///< two fingers can overcome it
    static constexpr double kHoldsMm = 2.0;  ///< beside the outline; the force ends 1 mm farther out

    /// Takes some milliseconds at 150 x 150.
    /// @param ideal  the surface to be cut, of this anatomy; not null
    Fixture(const terrain::ToothAnatomy& anatomy, const std::vector<float>& ideal);

    /// Returns the force on the hand, N, with the tip of burs()[bur] at `tip`, tooth frame, mm. No allocation.
    [[nodiscard]] glm::dvec3 forceN(const glm::dvec3& tip, std::size_t bur) const noexcept;

private:
    terrain::Grid m_grid;
    double m_topMm = 0.0;
    /// By radius of the bur: distance of its axis from where it may be, [side * side].
    std::vector<std::vector<float>> m_besideMm;
    std::vector<std::size_t> m_mapOfBur;  ///< into m_besideMm
};

}  // namespace core::guidance
