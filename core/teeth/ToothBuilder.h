// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "core/base/Result.h"
#include "core/mesh/Placement.h"
#include "core/teeth/Block.h"
#include "core/teeth/Caries.h"
#include "core/teeth/Laid.h"
#include "core/teeth/Layers.h"
#include "core/teeth/LesionSite.h"
#include "core/terrain/Lying.h"
#include "core/terrain/Tooth.h"

/// Builds a tooth that can be drilled from a file, a tooth number or a practice block.
namespace core::teeth {

/// The source of a tooth: its FDI number (for the generator), a mesh file, or a practice block.
struct ToothSource
{
    std::variant<int, std::filesystem::path, BlockDesign> what;
};

/// Parses a source: "36" is a number and "block:line" a block; anything else is a file.
[[nodiscard]] ToothSource parseSource(std::string_view text);

struct BuildOptions
{
    int gridSide = terrain::kDefaultGridSide;
    mesh::PlacementOptions placement;  ///< of a file; a generated tooth is in the tooth frame already
    int fdi = 0;                       ///< number of the tooth in a file, 0 if unknown
    terrain::Lying lying;              ///< not for a practice block
    std::uint64_t seed = 0;            ///< of the generated shape, the layers and the lesion
    LayerRule layers = LayerRule::Anatomical;
    std::optional<CariesRule> caries = CariesRule::FissureWalk;  ///< empty: a sound tooth
    double cariesExtent = 0.5;                                   ///< 0 to 1
    std::optional<LesionSite> site;                              ///< of the decay; empty: usualSite()
    bool hasDecayZones = false;                                  ///< the decay is soft, leathery and firm
};

/// The properties of the source and of the tooth built from it, printed by `cusp tooth`. Lengths in mm unless the name
/// says otherwise.
struct ToothReport
{
    std::string source;
    int fdi = 0;
    std::size_t triangles = 0;
    std::size_t vertices = 0;
    bool closed = false;
    bool oriented = false;
    std::size_t boundaryEdges = 0;
    std::size_t nonManifoldEdges = 0;
    std::size_t flippedEdges = 0;
    std::size_t zeroAreaFaces = 0;
    std::size_t duplicateFaces = 0;
    std::size_t shells = 0;
    std::size_t shellsInside = 0;     ///< those inside another
    std::size_t shellsInsideOut = 0;  ///< those that faced inwards and were reversed
    mesh::Placement placement;
    glm::dvec3 lowMm{};  ///< lowest corner of the bounding box, in the frame in which the tooth is cut
    glm::dvec3 highMm{};
    double meshAreaMm2 = 0.0;
    double meshVolumeMm3 = 0.0;         ///< signed sum over the faces; valid if oriented
    double modelVolumeMm3 = 0.0;        ///< of the columns
    std::optional<double> undercutMm3;  ///< volume that the columns fill and the mesh does not; empty unless oriented,
                                        ///< and if shells may overlap
    terrain::Lying lying;
    int gridSide = 0;
    double cellMm = 0.0;
    std::size_t sewnCells = 0;
    terrain::PerMaterial layersMm3{};
    std::vector<std::string> warnings;                     ///< one sentence each
    std::vector<std::pair<std::string, double>> stagesMs;  ///< in their order
    double loadMs = 0.0;                                   ///< total, from opening the file
    double loadCpuMs = 0.0;  ///< the same as processor time of this thread, independent of other load
};

struct BuiltTooth
{
    std::shared_ptr<const terrain::ToothAnatomy> anatomy;
    mesh::TriangleMesh mesh;  ///< as rasterised, in the frame in which the tooth is cut
    ToothReport report;
};

/// Returns whether the generator made this tooth, so that +x of its own frame points from mesial to distal and y to the
/// side that buccalSign() gives. For a scan the mesial side is unknown, even if its tooth number was given.
[[nodiscard]] bool isGenerated(const terrain::ToothAnatomy& anatomy);
/// Returns whether the generator made it and it is upright, as among its neighbours: those axes are then also those of
/// the frame in which it is cut.
[[nodiscard]] bool standsInTheArch(const terrain::ToothAnatomy& anatomy);

/// Reads or generates the mesh, analyses and places it, rotates it, rasterises it, and adds its tissues and a lesion. A
/// tooth on its side ends 3 mm below its neck: a grid over the whole root would have columns twice as wide. Some tens
/// of milliseconds; any thread but the ui thread. The error is one sentence.
[[nodiscard]] Result<BuiltTooth> buildTooth(const ToothSource& source, const BuildOptions& options);

}  // namespace core::teeth
