// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/contact/ContactMethod.h"

namespace core::contact {

/// The bur as a point over the clearance field: the anchor is the nearest free point to the device that it can slide to
/// from the last anchor.
///
/// Above the tooth it slides on the tangent planes of what it meets, as a god-object does. No move is longer than half
/// the bur's radius, and all that the tooth forbids the tip is wider than the radius to either side: it neither hops
/// onto a wall nor through a ridge. Beneath an overhang and in a notch searchAround() takes over. So it does for
/// a bur that finds no way while the hand goes on. An anchor that is
/// free stays where it is reached from: it is put on top of the tooth only if the tooth or the bur has changed.
class ContinuousContact final : public ContactMethod
{
public:
    [[nodiscard]] std::string_view name() const noexcept override { return "continuous"; }
    glm::dvec3 update(LiveTooth& tooth, const glm::dvec3& device) noexcept override;
    void moveTo(const glm::dvec3& anchor) noexcept override;
    void toothChanged() noexcept override
    {
        m_mayBeInside = true;
        m_known.tooth = nullptr;
    }
    void restart(const glm::dvec3& device) noexcept override;

private:
    [[nodiscard]] Edges standClear(LiveTooth& tooth, Touch& ground) noexcept;

    /// What the last look found, and where: mostly that is where the next tick begins.
    struct Known
    {
        const LiveTooth* tooth = nullptr;
        std::uint64_t revision = 0;
        glm::dvec2 atMm{0.0};
        Touch touch{};

        [[nodiscard]] bool isOf(const LiveTooth& now, const glm::dvec3& anchor) const noexcept
        {
            return tooth == &now && revision == now.revision() && atMm == glm::dvec2(anchor);
        }
    };

    Known m_known;
    glm::dvec3 m_askedFrom{0.0};  ///< where the hand was when a way was last found or looked for far around
    std::uint64_t m_revision = 0;
    int m_blockedTicks = 0;  ///< on end in which the slide found no way
    glm::dvec3 m_anchor{0.0, 0.0, 10.0};
    glm::dvec3 m_device{0.0, 0.0, 10.0};
    bool m_mayBeInside = true;  ///< the anchor was not free where it stands by any move of its own
};

}  // namespace core::contact
