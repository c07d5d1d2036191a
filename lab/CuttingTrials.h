// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include <glm/vec3.hpp>

#include "core/servo/ServoTick.h"

namespace lab {

/// A bur that is guided along a straight line through a block and pulled along it with a constant force, the drill on:
/// its speed is the removal rate, whatever force the servo returns.
struct PaceTrial
{
    int side = core::terrain::kDefaultGridSide;  ///< columns per side, over 10.5 mm
    double rateHz = 1000.0;                      ///< the tick must be whole microseconds
    std::size_t bur = 1;                         ///< index into bur::burs(): 330
    glm::dvec3 towards{0.0, 0.0, -1.0};          ///< unit vector of the feed, z not above 0
    double newtons = 1.0;
    double seconds = 2.0;
    core::terrain::Material material = core::terrain::Material::Enamel;
    core::servo::ServoSettings settings;
};

/// Returns the volume that is removed in the trial, mm3. A straight plunge begins on the flat top of the block, any
/// other feed beside a wall, with the tip 1 mm deep.
[[nodiscard]] double removedMm3(const PaceTrial& trial);

/// Returns the time after which a bur that is pressed straight down has this depth, s; the trial's seconds if it does
/// not.
[[nodiscard]] double secondsTo(double depthMm, const PaceTrial& trial);

/// The mover of the handpiece while the force is measured.
enum class Feeder {
    Speed,  ///< a slide, at the speed that `newtons` cut by the preset's law
    Force,  ///< a hand that presses with `newtons` and keeps the line with a spring: it and the device are one mass
};

struct Ripple
{
    double rmsN;   ///< of the force on the hand from 20 to 300 Hz, all axes (docs/facts/haptics.md, section 8.4)
    double meanN;  ///< of that force
};

/// Measures the ripple over the last two of the trial's seconds.
/// @param trial  sideways or straight down, at least 3 s, at least 1 kHz
[[nodiscard]] Ripple measureRipple(const PaceTrial& trial, Feeder feeder);

/// Returns the unit vector of a feed: heading about the tooth's axis, and angle below the horizontal.
[[nodiscard]] glm::dvec3 feed(double headingDegrees, double downDegrees);

/// Returns the removal rate of a trial by the law, mm3/s: S (F - F0), for the direction of the pull and the speed of
/// the bur under it.
[[nodiscard]] double lawfulMm3PerS(const PaceTrial& trial);

}  // namespace lab
