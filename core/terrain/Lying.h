// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace core::terrain {

/// The side of a tooth that is turned towards the bur, as a direction of the tooth's own frame.
enum class ToothSide : std::uint8_t { Occlusal, MinusX, PlusX, MinusY, PlusY };
inline constexpr int kToothSideCount = 5;

/// The orientation of a tooth under the bur. All that is cut from one direction is a height field in that direction, so
/// a tooth is rotated before it is rasterised, and the bur always comes along -z.
///
/// Two frames in millimetres: the tooth's own frame (+z occlusal) and the frame in which it is cut (+z towards the
/// handpiece). For an upright tooth they are parallel.
struct Lying
{
    static constexpr double kLeastTiltDeg = 5.0;
    static constexpr double kMostTiltDeg = 90.0;

    ToothSide up = ToothSide::Occlusal;
    double tiltDeg = 0.0;  ///< angle between the tooth's axis and the bur: 90 is flat on its side, 0 is upright

    [[nodiscard]] bool isUpright() const { return up == ToothSide::Occlusal; }
    /// Returns whether the orientation is valid: upright without a tilt, or tilted by 5 to 90 degrees to a side.
    [[nodiscard]] bool isSound() const;
    /// Returns the rotation from the tooth's own frame into the frame in which it is cut. A tilt of 90 is exact.
    [[nodiscard]] glm::dmat3 cutFromOwn() const;
    bool operator==(const Lying&) const = default;
};

}  // namespace core::terrain
