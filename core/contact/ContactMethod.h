// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string_view>

#include <glm/vec3.hpp>

#include "core/base/Result.h"
#include "core/contact/LiveTooth.h"

namespace core::contact {

/// Computes in each tick the position of the bur for a position `device` of the hand: the anchor, which the spring
/// pulls to and the screen shows. There are several methods, so that they can be compared in charts.
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

    /// Returns the position towards which cutting advances the bur. Call after update(). For most methods that is the
    /// device.
    [[nodiscard]] virtual glm::dvec3 cutTowards(const glm::dvec3& device) const noexcept { return device; }

    /// Sets the anchor to where cutting has advanced the bur.
    virtual void moveTo(const glm::dvec3& anchor) noexcept = 0;

    /// Must be called when the tooth or the bur was replaced: the anchor may be inside the new one.
    virtual void toothChanged() noexcept {}

    /// Resets the state: puts the bur at the device, or above it if that is inside the tooth.
    virtual void restart(const glm::dvec3& device) noexcept = 0;
};

/// Creates "penalty", "lattice", "lattice16" or "continuous"; UnknownName otherwise.
///
/// penalty     no state: the force acts along the surface normal under the device, in proportion to the depth along it.
/// lattice     CEDS 2011: the anchor moves on lattice points, one of 26 steps per tick, to the free one nearest the
/// hand.
/// lattice16   the same with up to sixteen steps per tick.
/// continuous  searches for the nearest free point over the clearance field.
[[nodiscard]] Result<std::unique_ptr<ContactMethod>> makeContactMethod(std::string_view name);

}  // namespace core::contact
