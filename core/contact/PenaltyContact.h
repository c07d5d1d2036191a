// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/contact/ContactMethod.h"

namespace core::contact {

/// Force along the surface normal under the device: the first method of 2011, dropped there as erratic in corners and
/// pits (docs/facts/haptics.md, section 3.3). For the charts and for the tests that show where it fails.
class PenaltyContact final : public ContactMethod
{
public:
    [[nodiscard]] std::string_view name() const noexcept override { return "penalty"; }
    glm::dvec3 update(LiveTooth& tooth, const glm::dvec3& device) noexcept override;
    void moveTo(const glm::dvec3&) noexcept override {}  // it remembers nothing
    void restart(const glm::dvec3&) noexcept override {}
};

}  // namespace core::contact
