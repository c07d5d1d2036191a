// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/terrain/Lying.h"

#include <cmath>
#include <numbers>

namespace core::terrain {

bool Lying::isSound() const
{
    if (static_cast<int>(up) >= kToothSideCount)
        return false;
    return isUpright() ? tiltDeg == 0.0 : tiltDeg >= kLeastTiltDeg && tiltDeg <= kMostTiltDeg;
}

glm::dmat3 Lying::cutFromOwn() const
{
    if (isUpright())
        return glm::dmat3(1.0);
    const double angle = tiltDeg * std::numbers::pi / 180.0;
    const double cosine = tiltDeg == kMostTiltDeg ? 0.0 : std::cos(angle);
    const double across = tiltDeg == kMostTiltDeg ? 1.0 : std::sin(angle);
    const double sine = up == ToothSide::PlusX || up == ToothSide::PlusY ? across : -across;
    if (up == ToothSide::MinusX || up == ToothSide::PlusX)
        return {glm::dvec3(cosine, 0.0, sine), glm::dvec3(0.0, 1.0, 0.0), glm::dvec3(-sine, 0.0, cosine)};
    return {glm::dvec3(1.0, 0.0, 0.0), glm::dvec3(0.0, cosine, sine), glm::dvec3(0.0, -sine, cosine)};
}

}  // namespace core::terrain
