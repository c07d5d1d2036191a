// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "core/grading/IdealCavity.h"

namespace core::guidance {

/// A virtual fixture (Rosenberg 1993; Abbott, Marayong & Okamura 2007) that resists leaving the outline of a
/// preparation: a spring that draws the bur's axis sideways to where the bur cuts nothing beside it. It can be
/// overcome, and gives up altogether 3 mm beside the outline. It begins half a millimetre over the crown and is whole
/// half a millimetre below its top: over the tooth a hand goes where it likes.
///
/// It holds the hand and nothing else: it is no contact, cuts nothing, and what it pushes with is on no recording.
/// Immutable, so any thread may ask.
class Fixture
{
public:
    /// Sideways; it adds to the spring of contact (docs/facts/haptics.md, section 2.2).
    static constexpr double kNPerMm = 1.0;
    static constexpr double kMostN = 1.5;    ///< so it can be overcome with two fingers
    static constexpr double kHoldsMm = 2.0;  ///< beside the outline; it is gone 1 mm farther out

    /// Some milliseconds at 150 x 150.
    /// @param ideal  what is to be cut, of this anatomy; not null
    Fixture(const terrain::ToothAnatomy& anatomy, const std::vector<float>& ideal);

    /// On the hand, newtons, with the tip of burs()[bur] at `tip`, tooth frame, mm. No allocation.
    [[nodiscard]] glm::dvec3 forceN(const glm::dvec3& tip, std::size_t bur) const noexcept;

private:
    terrain::Grid m_grid;
    double m_topMm = 0.0;
    /// By radius of the bur: how far its axis is from where it may be, [side * side].
    std::vector<std::vector<float>> m_besideMm;
    std::vector<std::size_t> m_mapOfBur;  ///< into m_besideMm
};

}  // namespace core::guidance
