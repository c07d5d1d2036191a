// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include <glm/vec2.hpp>

#include "core/terrain/Tooth.h"

namespace bench {

/// A target surface, and typical errors of students. Every change is exact, so that the error is known without
/// measuring it. Heights in mm over the anatomy's grid, [side * side]; places in the tooth frame.
class Spoiling
{
public:
    /// @param wanted  the right surface: no higher than the tooth's top
    Spoiling(const core::terrain::ToothAnatomy& anatomy, std::vector<float> wanted);

    [[nodiscard]] const std::vector<float>& wanted() const { return m_wanted; }

    /// Lowers the floor by this depth, or raises it if negative.
    void lower(double mm);
    /// Moves all walls outwards.
    void widen(double mm);
    /// Makes the walls lean outwards.
    void lean(double degrees);
    /// Tilts the floor along x.
    void tilt(double degrees);
    /// Makes the floor wavy: amplitude, mm.
    void ripple(double mm);
    /// Lowers the half of the floor towards +x.
    void step(double mm);
    /// Digs a round hole into the middle of the floor, this deep.
    void gouge(double mm);
    /// Digs a round hole into the highest place away from the cavity, this deep.
    void hole(double mm);
    /// Lowers half of the surface by this depth. The cavity is not changed.
    void scribble(double mm);
    /// Extends the cavity towards -x until the marginal ridge has only this width.
    void cutRidge(double leftMm);
    /// Leaves the part of the cavity towards +x uncut; `share` is its part of the area.
    void leave(double share);
    /// Digs a hole above the highest place of the pulp below the cavity, until `leftMm` of tissue is left over the
    /// pulp. A negative value opens the pulp.
    void nearPulp(double leftMm);
    /// Leaves this share of the volume of the decay: at its outer end, at the enamel-dentin junction, or on the floor.
    void leaveDecay(double share, bool atJunction);

private:
    template <class Change>
    void eachOfCavity(const Change& change);
    /// Lowers the columns within a distance of a place.
    void dig(glm::dvec2 placeMm, double radiusMm, const std::function<double(std::size_t)>& bottomMm);
    [[nodiscard]] bool isCavity(std::size_t k) const { return m_isCavity[k]; }
    void set(std::size_t k, double mm);
    [[nodiscard]] double decayAbove(std::size_t k, float top) const;
    [[nodiscard]] double decayLeftMm3(const std::vector<float>& top) const;

    const core::terrain::ToothAnatomy& m_anatomy;
    std::vector<float> m_wanted;
    std::vector<bool> m_isCavity;
    glm::dvec2 m_middleMm{0.0};  ///< of the cavity
};

}  // namespace bench
