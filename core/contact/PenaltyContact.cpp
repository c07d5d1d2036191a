// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/PenaltyContact.h"

#include <cmath>

namespace core::contact {

glm::dvec3 PenaltyContact::update(LiveTooth& tooth, const glm::dvec3& device) noexcept
{
    const double depth = tooth.clearanceAt({device.x, device.y}) - device.z;
    if (!(depth > 0.0))
        return device;
    const double h = tooth.grid().cellMm;
    const double slopeX =
        (tooth.clearanceAt({device.x + h, device.y}) - tooth.clearanceAt({device.x - h, device.y})) / (2.0 * h);
    const double slopeY =
        (tooth.clearanceAt({device.x, device.y + h}) - tooth.clearanceAt({device.x, device.y - h})) / (2.0 * h);
    // The normal is (-sx, -sy, 1) / |.|. The plane at height `depth` above is depth * n.z away along it.
    const double away = depth / (slopeX * slopeX + slopeY * slopeY + 1.0);
    return device + glm::dvec3(-slopeX, -slopeY, 1.0) * away;
}

}  // namespace core::contact
