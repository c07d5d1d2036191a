// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/contact/ContactMethod.h"

namespace core::contact {

/// The anchor of CEDS (Hunt 2011, after Williams's surface dragging): a point of the lattice that never enters the
/// tooth. It moves to whichever of itself and its 26 neighbours is free and nearest to the device: once a tick in 2011,
/// or as often as it is given, each step from where the last one ended, so that it never jumps what is wider than a
/// cell. A bur that is free where the hand holds it, within half a cell of the anchor, is felt nowhere. Cutting works
/// towards the neighbour nearest to the device; the anchor goes there once all of it is free.
class LatticeContact final : public ContactMethod
{
public:
    /// @param steps  a tick, at least 1
    explicit LatticeContact(int steps = 1) noexcept : m_steps(steps) {}
    [[nodiscard]] std::string_view name() const noexcept override { return m_steps == 1 ? "lattice" : "lattice16"; }
    glm::dvec3 update(LiveTooth& tooth, const glm::dvec3& device) noexcept override;
    [[nodiscard]] glm::dvec3 cutTowards(const glm::dvec3& device) const noexcept override;
    void moveTo(const glm::dvec3&) noexcept override {}  // between two points of the lattice; update() goes on
    void toothChanged() noexcept override { m_mayBeInside = true; }
    void restart(const glm::dvec3& device) noexcept override;

private:
    int m_steps;
    glm::dvec3 m_anchor{0.0, 0.0, 10.0};
    double m_cellMm = 0.0;       ///< of the lattice that m_anchor is on
    bool m_mayBeInside = false;  ///< the tooth, the bur or the place is another than a tick ago
};

}  // namespace core::contact
