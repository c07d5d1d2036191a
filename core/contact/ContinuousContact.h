// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/contact/ContactMethod.h"

namespace core::contact {

/// Treats the bur as a point over the clearance field: the anchor is the free point nearest to the device that it can
/// slide to from the last anchor.
///
/// Above the tooth it slides on the tangent planes of the surfaces that it touches, like a god-object. No move is
/// longer than half the bur's radius, and every obstacle for the tip is wider than the radius on either side: the
/// anchor jumps neither onto a wall nor through a ridge. Below an overhang and in a notch searchAround() is used, and
/// also when the slide is blocked while the hand moves on. A free anchor keeps its place: it is put on top of the tooth
/// only if the tooth or the bur was replaced.
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

    /// The result of the last search and its place: the next tick usually begins there.
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
    glm::dvec3 m_askedFrom{0.0};  ///< position of the hand when a path was last found, or last searched widely
    std::uint64_t m_revision = 0;
    int m_blockedTicks = 0;  ///< ticks in a row in which the slide was blocked
    glm::dvec3 m_anchor{0.0, 0.0, 10.0};
    glm::dvec3 m_device{0.0, 0.0, 10.0};
    bool m_mayBeInside = true;  ///< the anchor did not reach its place by a move of its own, so it may not be free
};

}  // namespace core::contact
