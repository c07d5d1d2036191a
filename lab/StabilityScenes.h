// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

#include "core/terrain/Tooth.h"
#include "lab/Stability.h"

namespace lab {

inline constexpr double kNever = 1.0e9;
/// Time for which the hand is still at the end of every scene.
inline constexpr double kStillS = 0.6;

/// The motion of a hand in a scene of docs/facts/haptics.md, section 4, and its ground. Tooth frame, mm; the bur is
/// round No. 2.
struct StabilityScene
{
    int number = 0;
    std::string name;
    std::shared_ptr<const core::terrain::ToothAnatomy> anatomy;
    /// Returns the intended position of the hand at a time. `mmPerN`: distance into the tooth per newton.
    std::function<glm::dvec3(double seconds, double mmPerN)> wanted;
    /// Strokes along x, between `strokesFromS` and `strokesToS`, of the grip, not of the intended position.
    double strokeMm = 0.0;  ///< amplitude to each side
    double strokeHz = 0.0;
    double strokesFromS = 0.0;
    double strokesToS = 0.0;
    double seconds = 2.0;
    std::vector<std::pair<double, double>> steadyS;  ///< times of constant exact force; at rest anyway
    double jumpsFromS = 0.5;
    double jumpsToS = kNever;
    double jumpsAboveMm = -kNever;  ///< counts jumps only while the grip is higher than this
    glm::dvec3 along{0.0};          ///< the path on which the bur is free; zero: no lag is measured
    glm::dvec3 throwMmPerS{0.0};    ///< speed of the grip at the start
    glm::dvec3 startMm{0.0};        ///< of a throw; otherwise it starts at the intended position
    bool drill = false;
    double silentFromS = kNever;  ///< the device has no new reading from this time on
    double silentForS = 0.0;
    double jitterS = -1.0;    ///< of the delay, if not negative
    double countShare = 1.0;  ///< of the encoders
    double dryN = -1.0;       ///< dry friction of the device, if not negative
    bool trembling = false;   ///< the hand's tremor and drift are on; else it is calm
    bool beginsInside = false;
    bool mustStayLeft = false;  ///< the grip must stay left of x = 0
    double swapAtS = kNever;    ///< time at which the tooth is replaced by `swapTop`, in one tick
    std::vector<float> swapTop;
    double homeAtS = kNever;  ///< time at which centring is requested; the hand follows until `grabAtS`
    double grabAtS = kNever;  ///< from this time on `wanted` moves the hand from its place
    /// Returns the exact anchor for a position of the device deep enough to press; empty function: unknown.
    std::function<glm::dvec3(const glm::dvec3& device)> exact;
    /// Scene 16: the device moves along given circles around this place instead of being held by a hand.
    bool loops = false;
    glm::dvec3 loopsAtMm{0.0};
    StabilityBars bars;
};

[[nodiscard]] const std::vector<StabilityScene>& stabilityScenesInFull();

}  // namespace lab
