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

/// From a file or a tooth number to a tooth that can be drilled.
namespace core::teeth {

/// Where a tooth comes from: its FDI number (our generator makes it), a mesh file, or a practice block.
struct ToothSource
{
    std::variant<int, std::filesystem::path, BlockDesign> what;
};

/// "36" is a number and "block:line" a block; anything else is a file.
[[nodiscard]] ToothSource parseSource(std::string_view text);

struct BuildOptions
{
    int gridSide = terrain::kDefaultGridSide;
    mesh::PlacementOptions placement;  ///< of a file; a generated tooth is in the tooth frame already
    int fdi = 0;                       ///< which tooth a file holds, 0 when nobody said
    terrain::Lying lying;              ///< not of a practice block
    std::uint64_t seed = 0;            ///< of the generated shape, the layers and the lesion
    LayerRule layers = LayerRule::Anatomical;
    std::optional<CariesRule> caries = CariesRule::FissureWalk;  ///< none: a sound tooth
    double cariesExtent = 0.5;                                   ///< 0 .. 1
    std::optional<LesionSite> site;                              ///< of the decay; none: usualSite()
    bool hasDecayZones = false;                                  ///< the decay is soft, leathery and firm
};

/// What was found in the source and made of it: `cusp tooth` prints it. Lengths in mm unless the name says otherwise.
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
    std::size_t shellsInside = 0;     ///< of them, inside another
    std::size_t shellsInsideOut = 0;  ///< of them, turned because they looked inwards
    mesh::Placement placement;
    glm::dvec3 lowMm{};  ///< lowest corner of the bounding box, in the frame in which the tooth is cut
    glm::dvec3 highMm{};
    double meshAreaMm2 = 0.0;
    double meshVolumeMm3 = 0.0;         ///< signed sum over the faces; means something where oriented
    double modelVolumeMm3 = 0.0;        ///< of the columns
    std::optional<double> undercutMm3;  ///< what the columns fill that the mesh does not; unknown unless oriented, or
                                        ///< where shells may overlap
    terrain::Lying lying;
    int gridSide = 0;
    double cellMm = 0.0;
    std::size_t sewnCells = 0;
    terrain::PerMaterial layersMm3{};
    std::vector<std::string> warnings;                     ///< one sentence each
    std::vector<std::pair<std::string, double>> stagesMs;  ///< in the order they ran
    double loadMs = 0.0;                                   ///< all of it, from opening the file
    double loadCpuMs = 0.0;  ///< the same as this thread's processor time: what it costs when others are at work
};

struct BuiltTooth
{
    std::shared_ptr<const terrain::ToothAnatomy> anatomy;
    mesh::TriangleMesh mesh;  ///< in the frame the tooth is cut in, as it was rasterised
    ToothReport report;
};

/// Whether our generator made this tooth, so that +x of its own frame points from mesial to distal and y to the side
/// that buccalSign() names.
/// Nothing in a scan says which side is mesial, not even where someone said which tooth it is.
[[nodiscard]] bool isGenerated(const terrain::ToothAnatomy& anatomy);
/// Whether our generator made it and it stands upright, as among its neighbours: those axes are then also those of the
/// frame it is cut in.
[[nodiscard]] bool standsInTheArch(const terrain::ToothAnatomy& anatomy);

/// Reads or generates the mesh, judges and places it, turns it the way it lies, rasterises it, lays its tissues and
/// puts a lesion into it. A tooth that lies on a side ends 3 mm below its neck: a grid over the whole root would have
/// columns twice as wide.
/// Some tens of milliseconds; any thread that may wait. On failure one sentence.
[[nodiscard]] Result<BuiltTooth> buildTooth(const ToothSource& source, const BuildOptions& options);

}  // namespace core::teeth
