// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/falcon/Placement.h"

#include <algorithm>

#include "core/session/RestHeight.h"

namespace haptics::falcon {
namespace {

using core::session::DeviceSetup;

static_assert(kReachMm >= core::session::kHandReachMm);

/// Returns the directions of the device's axes in the tooth frame, for a device that faces the user.
glm::dmat3 standing(DeviceSetup::Stand stand)
{
    // In its normal position its y axis points up, and z to the user. On its back, z points up, and y away from the
    // user.
    return stand == DeviceSetup::Stand::Upright ? glm::dmat3({1.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, {0.0, -1.0, 0.0})
                                                : glm::dmat3(1.0);
}

/// Returns the rotation about the vertical. A device on the right of the user is turned to face left.
glm::dmat3 turned(DeviceSetup::Side side)
{
    switch (side) {
    case DeviceSetup::Side::Right:
        return {{0.0, -1.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 0.0, 1.0}};
    case DeviceSetup::Side::Left:
        return {{0.0, 1.0, 0.0}, {-1.0, 0.0, 0.0}, {0.0, 0.0, 1.0}};
    case DeviceSetup::Side::Front:
        break;
    }
    return glm::dmat3(1.0);
}

}  // namespace

Placement::Placement(const DeviceSetup& setup) noexcept
    : m_toothFromDevice(turned(setup.side) * standing(setup.stand)),
      m_scale(std::clamp(setup.scale, DeviceSetup::kLeastScale, DeviceSetup::kMostScale)),
      m_restMm(0.0, 0.0, core::session::reachableRestMm(setup.restMm, m_scale))
{}

}  // namespace haptics::falcon
