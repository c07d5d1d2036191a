// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/contact/ContactMethod.h"

namespace core::contact {

/// The anchor of CEDS (Hunt 2011, after Williams's surface dragging): a lattice point that never enters the tooth. It
/// moves to the one of itself and its 26 neighbours that is free and nearest to the device: once per tick in 2011, or
/// `steps` times, each step from the end of the last, so that it never jumps over an obstacle wider than a cell. A bur
/// that is free at the position of the hand, within half a cell of the anchor, gives no force. Cutting works towards
/// the neighbour nearest to the device; the anchor moves there once all of it is free.
class LatticeContact final : public ContactMethod
{
public:
    /// @param steps  per tick, at least 1
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
    bool m_mayBeInside = false;  ///< the tooth, the bur or the place was replaced since the last tick
};

}  // namespace core::contact
