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

/// A surface, a bur, a path of the hand, and the exact position of the bur at each tick: the point of the offset
/// surface that a bur without friction slides to (docs/facts/haptics.md, section 8.4, item 1). Tooth frame, mm.
struct ContactScene
{
    std::string family;  ///< its row in the table: "plane 27"
    std::shared_ptr<const core::terrain::ToothAnatomy> anatomy;
    std::size_t burIndex = 0;
    std::vector<glm::dvec3> device;
    std::vector<glm::dvec3> right;
    std::size_t counted = 0;  ///< first tick that counts: before it, the bur is on its way to the surface
};

/// The errors of a method in scenes.
///
/// A bur that is pushed over an edge jumps: the exact one in no time, because it has no mass. When and how fast a
/// method follows is not an error, so within kLeapS of a jump its position is not counted, and a change of its force
/// only as far as it exceeds the jump's own.
struct ContactErrors
{
    double rmsUm = 0.0;  ///< rms distance of the anchor from its exact position
    double mostUm = 0.0;
    double jumpN = 0.0;   ///< largest change of force in a tick beyond that of the exact path
    double lagUm = 0.0;   ///< mean distance of the anchor behind its exact position along the path; being ahead counts
                          ///< as negative
    double tickUs = 0.0;  ///< thread CPU time of update(), 99th percentile
    haptics::TickTimes times;
};

inline constexpr double kLeapMm = 0.1;  ///< movement in a tick beyond that of the hand
inline constexpr double kLeapS = 0.04;

/// One row of the table: the same surface in several places and directions on the lattice.
struct ContactFamily
{
    std::string name;
    std::vector<ContactScene> scenes;
    double reachRmsUm = 0.0;  ///< limits that a good method does not exceed
    double reachMostUm = 0.0;
    double reachJumpN = 0.0;
    double rateHz = 1000.0;  ///< ticks per second
};

/// The conditions of a family.
struct ContactConditions
{
    int side = core::terrain::kDefaultGridSide;  ///< columns per side, over kBlockExtentMm
    std::size_t bur = 0;                         ///< index into bur::burs()
    double rateHz = 1000.0;                      ///< ticks per second; the hand moves at the same speed at any rate
};

/// Returns the names of all families: planes, fossa, cusp, grooves, wall, corner, steps.
[[nodiscard]] std::vector<std::string> contactFamilyNames();
/// Builds a family.
/// @param name  one of contactFamilyNames()
[[nodiscard]] ContactFamily contactFamily(const std::string& name, const ContactConditions& conditions);
/// Builds all families at 1 kHz.
[[nodiscard]] std::vector<ContactFamily> contactFamilies(int side, std::size_t bur);

/// Runs a method over all scenes of a family and returns its errors.
/// @param method  "continuous" and so on; must exist
[[nodiscard]] ContactErrors measureContact(const ContactFamily& family, const std::string& method,
                                           double stiffnessNPerMm);

/// Returns the largest push, N, of those tried (0.25 N apart up to 6) at which a method does not cross a wall of
/// `cells` cells.
[[nodiscard]] double ridgeHoldsN(const std::string& method, int cells, std::size_t bur, double stiffnessNPerMm);

}  // namespace lab
