// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec3.hpp>

namespace ui::tooth {

/// How far the mouth is turned about the vertical under handpiece and eye. The room's frame is that of the device and
/// the eye; at 0 it is the tooth frame.
///
/// Turned by an angle, the tooth is seen as by a camera whose azimuth is that much less, and what the device says and
/// feels goes through roomToTooth() and toothToRoom(): left on the desk stays left on the screen.
struct MouthTurn
{
    static constexpr double kStepDeg = 15.0;

    double deg = 0.0;  ///< of the mouth, counter-clockwise seen from above; -180 .. 180

    /// By whole steps, from wherever it stands to a multiple of one.
    void step(int steps) { set(kStepDeg * (std::round(deg / kStepDeg) + steps)); }
    /// Freely.
    void set(double degrees) { deg = std::remainder(degrees, 360.0); }

    /// A place or a direction of the device in the tooth frame. The vertical through the origin stays where it is.
    [[nodiscard]] glm::dvec3 roomToTooth(glm::dvec3 v) const { return turned(v, -deg); }
    /// A place or a force of the tooth as the hand is to feel it.
    [[nodiscard]] glm::dvec3 toothToRoom(glm::dvec3 v) const { return turned(v, deg); }
    /// Azimuth of a camera in the tooth frame, for one that stands in the room.
    [[nodiscard]] double cameraAzimuthDeg(double inRoomDeg) const { return std::remainder(inRoomDeg - deg, 360.0); }

private:
    static glm::dvec3 turned(glm::dvec3 v, double degrees)
    {
        const double c = std::cos(glm::radians(degrees));
        const double s = std::sin(glm::radians(degrees));
        return {c * v.x - s * v.y, s * v.x + c * v.y, v.z};
    }
};

}  // namespace ui::tooth
