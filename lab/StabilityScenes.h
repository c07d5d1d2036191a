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
/// At the end of every scene the hand holds still this long.
inline constexpr double kStillS = 0.6;

/// What a hand does in a scene of docs/facts/haptics.md, section 4, and on what. Tooth frame, mm; the bur is round
/// No. 2.
struct StabilityScene
{
    int number = 0;
    std::string name;
    std::shared_ptr<const core::terrain::ToothAnatomy> anatomy;
    /// Where the hand wants to be at a time, given how far its wish must go into the tooth for a newton, mm.
    std::function<glm::dvec3(double seconds, double mmPerN)> wanted;
    /// Strokes along x, between `strokesFromS` and `strokesToS`, that the grip, not the wish, is to make.
    double strokeMm = 0.0;  ///< to each side
    double strokeHz = 0.0;
    double strokesFromS = 0.0;
    double strokesToS = 0.0;
    double seconds = 2.0;
    std::vector<std::pair<double, double>> steadyS;  ///< exact geometry gives an even force here; at rest anyway
    double jumpsFromS = 0.5;
    double jumpsToS = kNever;
    double jumpsAboveMm = -kNever;  ///< and only while the grip is higher than this
    glm::dvec3 along{0.0};          ///< the way on which nothing holds the bur; zero: no lag is asked for
    glm::dvec3 throwMmPerS{0.0};    ///< speed of the grip at the start
    glm::dvec3 startMm{0.0};        ///< of a throw; else it starts where the hand wants to be
    bool drill = false;
    double silentFromS = kNever;  ///< the device has nothing new from here
    double silentForS = 0.0;
    double jitterS = -1.0;    ///< of the delay, if not negative
    double countShare = 1.0;  ///< of the encoders
    double dryN = -1.0;       ///< dry friction of the device, if not negative
    bool trembling = false;   ///< the hand's tremor and drift are on; else it is calm
    bool beginsInside = false;
    bool mustStayLeft = false;  ///< of x = 0
    double swapAtS = kNever;    ///< the tooth is changed for `swapTop` in a tick
    std::vector<float> swapTop;
    double homeAtS = kNever;  ///< centring is asked for; until `grabAtS` the hand lets itself be led
    double grabAtS = kNever;  ///< from here on `wanted` moves it from where it is
    /// Where exact geometry puts the anchor when the device is here and deep enough to press; empty: not known.
    std::function<glm::dvec3(const glm::dvec3& device)> exact;
    /// Scene 16: the device goes round circles about here, path given, instead of being held. Empty: a held scene.
    bool loops = false;
    glm::dvec3 loopsAtMm{0.0};
    StabilityBars bars;
};

[[nodiscard]] const std::vector<StabilityScene>& stabilityScenesInFull();

}  // namespace lab
