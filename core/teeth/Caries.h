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
    double roomMm = 0.0;     ///< from the enamel-dentin junction down to where the dentin over the pulp must stay
};

/// Where a fissure lesion runs: a pit, and the fissure to both sides of it as far as 3.5 mm. The walk steps from node
/// to node of a lattice (about 0.15 mm), so another grid gives another line. To have the same lesion whatever the grid,
/// walk on one grid and lay the line into any other (CariesOptions::line).
///
/// @param top, bottom  [side * side], kEmptyTop and kEmptyBottom outside the tooth
/// @param layers       made by buildLayers for these maps
[[nodiscard]] std::vector<LesionStop> fissureLine(const terrain::Grid& grid, std::span<const float> top,
                                                  std::span<const float> bottom,
                                                  std::vector<terrain::ColumnLayers> layers, std::uint64_t seed);

/// Where decay of a smooth surface lies: its widest outline, an ellipse.
struct SurfaceLesion
{
    glm::dvec2 atMm{};    ///< middle, in the frame the tooth is cut in
    glm::dvec2 halfMm{};  ///< half its length along x and y at extent 1
};

struct CariesOptions
{
    CariesRule rule = CariesRule::FissureWalk;
    double extent = 0.5;     ///< 0 none .. 1 deepest; a larger extent contains every smaller one of the same seed
    std::uint64_t seed = 0;  ///< where the walk starts and which way it turns
    std::span<const LesionStop> line = {};      ///< of FissureWalk, made with the same seed; empty: walk on these maps
    std::optional<SurfaceLesion> surface = {};  ///< decay of a smooth surface instead, whatever the rule
};

/// Puts a lesion into layers made by buildLayers for the same maps: sets cariesRoof and cariesFloor.
///
/// FissureWalk. In enamel the lesion is a cone with its narrow mouth outside and its base at the enamel-dentin
/// junction; there it runs sideways under sound enamel (cariesRoof below the top), and a second cone points to the
/// pulp. Up to an extent of about 0.25 it stays in enamel.
///
/// Of a smooth surface it is the other way round: in enamel a cone with its base outside and its tip at the junction,
/// and a second cone in dentin with its base there (Fejerskov and Kidd, Dental Caries, on proximal lesions).
///
/// Whatever the extent, 0.5 mm of dentin stay between lesion and pulp in every direction. Any thread.
void addCaries(const terrain::Grid& grid, std::span<const float> top, std::span<const float> bottom,
               std::vector<terrain::ColumnLayers>& layers, const CariesOptions& options);

}  // namespace core::teeth
