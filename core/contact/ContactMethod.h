// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string_view>

#include <glm/vec3.hpp>

#include "core/base/Result.h"
#include "core/contact/LiveTooth.h"

namespace core::contact {

/// Answers, each tick, where the bur is when the hand is at `device`: the anchor, which the spring pulls to and the
/// screen shows. The methods stand side by side so that they can be charted against each other.
///
/// Servo thread; no allocation, no lock. Frames and units: tooth frame, mm.
class ContactMethod
{
public:
    ContactMethod() = default;
    ContactMethod(const ContactMethod&) = delete;
    ContactMethod& operator=(const ContactMethod&) = delete;
    virtual ~ContactMethod() = default;

    [[nodiscard]] virtual std::string_view name() const noexcept = 0;

    /// Moves the anchor for one tick and returns it.
    virtual glm::dvec3 update(LiveTooth& tooth, const glm::dvec3& device) noexcept = 0;

    /// Where cutting shall advance the bur to, now that update() has answered: for most as near to the device as it
    /// gets.
    [[nodiscard]] virtual glm::dvec3 cutTowards(const glm::dvec3& device) const noexcept { return device; }

    /// Puts the anchor where cutting has advanced the bur to.
    virtual void moveTo(const glm::dvec3& anchor) noexcept = 0;

    /// The tooth or the bur is another from now on: the anchor may stand inside what was not there before.
    virtual void toothChanged() noexcept {}

    /// Forgets everything: the bur is at the device, or above it if that is inside the tooth.
    virtual void restart(const glm::dvec3& device) noexcept = 0;
};

/// "penalty", "lattice", "lattice16" or "continuous"; UnknownName otherwise.
///
/// penalty     no memory: the force acts along the surface normal under the device, by the depth along it.
/// lattice     CEDS 2011: the anchor walks on lattice points, one of 26 steps a tick, to the free one nearest to hand.
/// lattice16   the same with up to sixteen steps a tick.
/// continuous  search for the nearest free point over the clearance field.
[[nodiscard]] Result<std::unique_ptr<ContactMethod>> makeContactMethod(std::string_view name);

}  // namespace core::contact
