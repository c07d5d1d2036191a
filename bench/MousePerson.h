// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <optional>

#include "core/base/Result.h"
#include "core/base/Rng.h"
#include "core/servo/ServoState.h"
#include "core/servo/ServoTick.h"
#include "core/terrain/Tooth.h"
#include "ui/tooth/Camera.h"

namespace bench {

/// Settings of the hand behind the mouse.
struct MouseHand
{
    double feedMmPerS = 0.5;             ///< 0: no feed, the button pushes with the force
    std::optional<double> stopMm = 1.5;  ///< depth of the depth stop; empty if it is off
    double forceN = 0.6;
};

/// The information that a person sees in one picture.
struct Sight
{
    double seconds = 0.0;
    glm::dvec2 burPx{0.0};  ///< position of the tip in the picture
    glm::dvec3 burMm{0.0};
    std::optional<double> depthMm;                   ///< the depth shown beside the bur
    std::optional<core::terrain::Material> under;    ///< the tissue shown under the bur; empty in the air
    std::shared_ptr<const std::vector<float>> tops;  ///< the cut surface, up to 0.1 s old
};

/// The actions of the hand until the next picture.
struct Deed
{
    glm::dvec2 pointerPx{0.0};
    bool pressed = false;
    double stopMm = 1.5;  ///< depth of the depth stop, set with the wheel
    bool isDone = false;
};

/// The result of a task at the mouse.
struct Doing
{
    core::terrain::Tooth tooth;
    core::servo::ServoState last;
    double seconds = 0.0;
    double deepestMm = 0.0;     ///< largest depth of the tip below the original surface at the first contact
    double mostOffRayPx = 0.0;  ///< largest distance of the tip from the pointer, button up
    double mostForceN = 0.0;    ///< largest force on the hand
};

/// Runs a task with the program's own camera, PointerControl, PointerDevice and servo, at 60 pictures per second.
/// @param decide  called once for each picture; returns what the hand does until the next one
[[nodiscard]] core::Result<Doing> work(const std::shared_ptr<const core::terrain::ToothAnatomy>& anatomy,
                                       const core::servo::ServoSettings& settings, std::size_t bur,
                                       const MouseHand& hand, const ui::tooth::Camera& camera, double mostSeconds,
                                       const std::function<Deed(const Sight&)>& decide);

/// Eyes and hand of a person: reacts 0.2 to 0.45 s late (0.3 s on average), and the hand trembles by 2 pixels around
/// its aim. Does not anticipate.
class Person
{
public:
    explicit Person(std::uint64_t seed);

    /// Stores a picture and returns the newest stored picture that is older than the reaction time; null if there is
    /// none.
    [[nodiscard]] const Sight* see(const Sight& sight);
    /// Returns the position of the pointer for an aim, with trembling.
    [[nodiscard]] glm::dvec2 aim(glm::dvec2 meantPx);

private:
    core::Rng m_rng;
    std::deque<Sight> m_seen;  ///< younger than the reaction time
    std::optional<Sight> m_minded;
    double m_delayS;
    glm::dvec2 m_tremblePx{0.0};
};

}  // namespace bench
