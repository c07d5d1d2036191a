// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/contact/ContactMethod.h"
#include "core/terrain/Tooth.h"
#include "haptics/simulated/TickTimes.h"

namespace lab {

/// A surface, a bur, a path of the hand, and where geometry puts the bur at each tick of it: the point of the offset
/// surface that a bur without friction slides to (docs/facts/haptics.md, section 8.4, item 1). Tooth frame, mm.
struct ContactScene
{
    std::string family;  ///< the row of the table it belongs to: "plane 27"
    std::shared_ptr<const core::terrain::ToothAnatomy> anatomy;
    std::size_t burIndex = 0;
    std::vector<glm::dvec3> device;
    std::vector<glm::dvec3> right;
    std::size_t counted = 0;  ///< ticks from here on are judged: before, the bur is on its way to the surface
};

/// What a method made of scenes.
///
/// A bur that is pushed over an edge leaps: the right one in no time, for it has no mass. How soon after it, and how
/// fast, a method follows is its own affair, so within kLeapS of a leap its position is not judged, and a change of its
/// force only by what it exceeds the leap's own.
struct ContactErrors
{
    double rmsUm = 0.0;  ///< distance of the anchor from where it should be
    double mostUm = 0.0;
    double jumpN = 0.0;   ///< largest change of force in a tick beyond that of the path itself
    double lagUm = 0.0;   ///< how far the anchor is behind on its way, on the average; ahead of it counts against that
    double tickUs = 0.0;  ///< thread CPU time of update(), 99th percentile
    haptics::TickTimes times;
};

inline constexpr double kLeapMm = 0.1;  ///< in a tick, farther than the hand moved
inline constexpr double kLeapS = 0.04;

/// One row of the table: the same surface in several places and directions on the lattice.
struct ContactFamily
{
    std::string name;
    std::vector<ContactScene> scenes;
    double reachRmsUm = 0.0;  ///< limits that a good method stays below
    double reachMostUm = 0.0;
    double reachJumpN = 0.0;
    double rateHz = 1000.0;  ///< ticks a second
};

/// What a family is measured with.
struct ContactConditions
{
    int side = core::terrain::kDefaultGridSide;  ///< columns a side, over kBlockExtentMm
    std::size_t bur = 0;                         ///< index into bur::burs()
    double rateHz = 1000.0;                      ///< ticks a second; the hand moves as fast at any rate
};

/// The names of all families: planes, fossa, cusp, grooves, wall, corner, steps.
[[nodiscard]] std::vector<std::string> contactFamilyNames();
/// @param name  one of contactFamilyNames()
[[nodiscard]] ContactFamily contactFamily(const std::string& name, const ContactConditions& conditions);
/// All of them at 1 kHz.
[[nodiscard]] std::vector<ContactFamily> contactFamilies(int side, std::size_t bur);

/// Runs a method over all scenes of a family.
/// @param method  "continuous" and so on; must exist
[[nodiscard]] ContactErrors measureContact(const ContactFamily& family, const std::string& method,
                                           double stiffnessNPerMm);

/// Largest push, N, of those tried (0.25 N apart up to 6) with which a method is held by a wall `cells` cells thick.
[[nodiscard]] double ridgeHoldsN(const std::string& method, int cells, std::size_t bur, double stiffnessNPerMm);

}  // namespace lab
