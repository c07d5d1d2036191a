// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/contact/ContactMethod.h"

namespace core::contact {

/// The bur as a point over the clearance field: the anchor is the nearest free point to the device that can be reached
/// from the last anchor without climbing a wall.
///
/// Only (x, y) is searched, for over a point the best height is known: max(device z, C). Eight directions, steps
/// from about the device's last move down to 1/128 cell (haptics.md 3.2). A step that would climb more than four cells
/// a cell is refused, so the anchor neither hops onto a wall nor through a ridge. Beneath an overhang the same search
/// runs along the underside, min(device z, D), and in a notch cut from the side, with floor beneath one part of the bur
/// and overhang above another, column by column (LiveTooth::roomAt). An anchor that is free stays where it is reached
/// from: it is put on top of the tooth only if the tooth or the bur has changed.
class ContinuousContact final : public ContactMethod
{
public:
    [[nodiscard]] std::string_view name() const noexcept override { return "continuous"; }
    glm::dvec3 update(LiveTooth& tooth, const glm::dvec3& device) noexcept override;
    void moveTo(const glm::dvec3& anchor) noexcept override;
    void toothChanged() noexcept override { m_mayBeInside = true; }
    void restart(const glm::dvec3& device) noexcept override;

private:
    glm::dvec3 m_anchor{0.0, 0.0, 10.0};
    glm::dvec3 m_device{0.0, 0.0, 10.0};
    bool m_mayBeInside = true;  ///< the anchor was not free where it stands by any move of its own
};

}  // namespace core::contact
