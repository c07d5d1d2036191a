// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "core/terrain/Grid.h"
#include "core/terrain/Tooth.h"

namespace core::teeth {

enum class CariesRule {
    FissureWalk,      ///< follows the fissures, narrow in enamel, wide at the junction
    LowPointFill2011  ///< fills low points depth first from the centre, open from above
};

/// A place on the centre line of a fissure lesion.
struct LesionStop
{
    glm::dvec2 atMm{};       ///< tooth frame
    double fromPitMm = 0.0;  ///< along the line, from the pit where it begins
    double roomMm = 0.0;     ///< from the enamel-dentin junction down to the dentin that must stay over the pulp
};

/// Returns the course of a fissure lesion: a pit, and the fissure on both sides of it up to 3.5 mm. The walk moves
/// between nodes of a lattice (about 0.15 mm), so another grid gives another line. For the same lesion on every grid,
/// walk on one grid and use the line on the others (CariesOptions::line).
///
/// @param top, bottom  [side * side], kEmptyTop and kEmptyBottom outside the tooth
/// @param layers       made by buildLayers for these maps
[[nodiscard]] std::vector<LesionStop> fissureLine(const terrain::Grid& grid, std::span<const float> top,
                                                  std::span<const float> bottom,
                                                  std::vector<terrain::ColumnLayers> layers, std::uint64_t seed);

/// The widest outline of a smooth-surface lesion, an ellipse.
struct SurfaceLesion
{
    glm::dvec2 atMm{};    ///< middle, in the frame the tooth is cut in
    glm::dvec2 halfMm{};  ///< half its length along x and y at extent 1
};

struct CariesOptions
{
    CariesRule rule = CariesRule::FissureWalk;
    double extent = 0.5;     ///< 0 none to 1 deepest; a larger extent contains every smaller one of the same seed
    std::uint64_t seed = 0;  ///< start and direction of the walk
    std::span<const LesionStop> line = {};      ///< for FissureWalk, computed with the same seed; empty: walk on these
                                                ///< maps
    std::optional<SurfaceLesion> surface = {};  ///< a smooth-surface lesion instead, whatever the rule
};

/// Adds a lesion to layers from buildLayers() for the same maps: sets cariesRoof and cariesFloor.
///
/// FissureWalk: in enamel the lesion is a cone with its narrow end outside and its base at the enamel-dentin junction;
/// there it spreads sideways under sound enamel (cariesRoof below the top), and a second cone points to the pulp. Up to
/// an extent of about 0.25 it stays in enamel.
///
/// On a smooth surface it is the reverse: in enamel a cone with its base outside and its tip at the junction, and a
/// second cone in dentin with its base there (Fejerskov and Kidd, Dental Caries, on proximal lesions).
///
/// 0.5 mm of dentin always stay between lesion and pulp in every direction. Any thread.
void addCaries(const terrain::Grid& grid, std::span<const float> top, std::span<const float> bottom,
               std::vector<terrain::ColumnLayers>& layers, const CariesOptions& options);

}  // namespace core::teeth
