// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <optional>

#include "core/base/Result.h"
#include "core/base/Rng.h"
#include "core/session/ServoTick.h"
#include "core/terrain/Tooth.h"
#include "ui/tooth/Camera.h"

namespace app::cli::bench {

/// How the hand behind the mouse is set.
struct MouseHand
{
    double feedMmPerS = 0.5;             ///< 0: no feed, the button pushes with the force (the way before the feed)
    std::optional<double> stopMm = 1.5;  ///< depth stop; empty: off
    double forceN = 0.6;
};

/// What the screen shows a person in one picture.
struct Sight
{
    double seconds = 0.0;
    glm::dvec2 burPx{0.0};  ///< where the tip of the bur is seen
    glm::dvec3 burMm{0.0};
    std::optional<double> depthMm;                   ///< the figure beside the bur
    std::optional<core::terrain::Material> under;    ///< colour under the bur; empty: it touches nothing
    std::shared_ptr<const std::vector<float>> tops;  ///< the tooth as it is seen, a tenth of a second old at most
};

/// What the person does until the next picture.
struct Deed
{
    glm::dvec2 pointerPx{0.0};
    bool pressed = false;
    double stopMm = 1.5;  ///< turned to with the wheel
    bool isDone = false;
};

/// What came of it.
struct Doing
{
    core::terrain::Tooth tooth;
    core::session::ServoState last;
    double seconds = 0.0;
    double deepestMm = 0.0;     ///< of the tip, below the original surface where the first press touched it
    double mostOffRayPx = 0.0;  ///< of the tip from the pointer, while the bur is free and has arrived
};

/// A bur under the mouse: the program's own camera, PointerControl, PointerDevice and servo, at 60 pictures a second.
/// @param decide  called once a picture with what the screen shows; answers what the hand does from then on
[[nodiscard]] core::Result<Doing> work(const std::shared_ptr<const core::terrain::ToothAnatomy>& anatomy,
                                       const core::session::ServoSettings& settings, std::size_t bur,
                                       const MouseHand& hand, const ui::tooth::Camera& camera, double mostSeconds,
                                       const std::function<Deed(const Sight&)>& decide);

/// Eyes and hand of a person: what is seen is acted on 0.2 to 0.45 s later (0.3 s on average), and the hand trembles by
/// 2 pixels about where it means to be. Nothing is foreseen.
class Person
{
public:
    explicit Person(std::uint64_t seed);

    /// Takes in a picture and returns the newest one that is old enough to be acted on; null at the beginning.
    [[nodiscard]] const Sight* see(const Sight& sight);
    /// Where the pointer is when the hand means it to be there.
    [[nodiscard]] glm::dvec2 aim(glm::dvec2 meantPx);

private:
    core::Rng m_rng;
    std::deque<Sight> m_seen;  ///< too young to be acted on
    std::optional<Sight> m_minded;
    double m_delayS;
    glm::dvec2 m_tremblePx{0.0};
};

}  // namespace app::cli::bench
