// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/contact/ContactMethod.h"

namespace core::contact {

/// The anchor of CEDS (Hunt 2011, after Williams's surface dragging): a point of the lattice that never enters the
/// tooth. Each tick it moves to whichever of itself and its 26 neighbours is free and nearest to the device. One step a
/// tick.
class LatticeContact final : public ContactMethod
{
public:
    [[nodiscard]] std::string_view name() const noexcept override { return "lattice"; }
    glm::dvec3 update(LiveTooth& tooth, const glm::dvec3& device) noexcept override;
    void moveTo(const glm::dvec3& anchor) noexcept override;
    void restart(const glm::dvec3& device) noexcept override;

private:
    glm::dvec3 m_anchor{0.0, 0.0, 10.0};
};

}  // namespace core::contact
