// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/NumberField.h"
#include "core/base/Result.h"
#include "core/mesh/TriangleMesh.h"
#include "core/terrain/Tooth.h"

/// Practice blocks, after the boards that schools use before the first tooth (docs/facts/teaching.md, section 5): a
/// flat slab of "enamel" on "dentin" with a shape to be cut into it.
namespace core::teeth {

enum class BlockShape : std::uint8_t {
    Line,
    Circle,  ///< a ring
    Cross,
    Square,     ///< a frame
    Dovetail,   ///< a line that widens towards both ends
    Staircase,  ///< a line that gets deeper in steps
    Bar,        ///< the letter I: a line with a bar across each end
    Tee,
    Layers,   ///< nothing to cut: three pads of enamel, dentin and soft caries to be recognised by feel
    Plunges,  ///< round pits in a row along x, each deeper than the one before
    Junction  ///< a window in enamel of uneven thickness; its floor is the enamel-dentin junction
};

/// A block and the shape in its middle. No source gives sizes of such shapes (docs/facts/teaching.md, section 5):
/// every number is the teacher's to set.
struct BlockDesign
{
    BlockShape shape = BlockShape::Line;
    double sideMm = 14.0;   ///< of the slab, a square seen from above
    double heightMm = 8.0;  ///< of the slab
    double enamelMm = 1.0;  ///< part of it that is enamel; for a junction, the smallest thickness of the enamel in the
                            ///< window
    double widthMm = 1.5;   ///< of the channel or window, along y; for a pit, its diameter
    /// Depth of the channel; for a staircase or plunges, the greatest; for a junction, the largest thickness of the
    /// enamel in the window.
    double depthMm = 1.5;
    double lengthMm = 9.0;  ///< of the whole shape from end to end; for a ring or frame, its outer width
    double flareMm = 0.5;   ///< extra width of a dovetail at its ends, on each side
    double steps = 4.0;     ///< number of steps of a staircase, or of pits
    /// Radius of inner corners. No upright bur can cut a corner that is tighter than itself.
    double cornerRadiusMm = 0.4;
    double lineAngleMm = 0.2;  ///< radius between floor and wall, as cut by the rounded end of a No. 245
    bool operator==(const BlockDesign&) const = default;
};

[[nodiscard]] std::span<const NumberField<BlockDesign>> blockFields();

/// Checks that each number is in its range, that the shape fits on the block, and that a bur fits into the shape. The
/// error names the number to change.
[[nodiscard]] Status validate(const BlockDesign& design);

/// Returns "block:line", "block:circle", "block:cross", "block:square", "block:dovetail", "block:staircase",
/// "block:bar", "block:tee", "block:layers", "block:plunges" or "block:junction".
[[nodiscard]] std::string blockName(BlockShape shape);
/// Returns the usual block of that name. An error lists the names; empty if the text does not begin with "block:".
[[nodiscard]] std::optional<Result<BlockDesign>> findBlock(std::string_view name);

/// Returns the materials of the three pads of a block of layers, in the order of +x; the seed shuffles them.
[[nodiscard]] std::array<terrain::Material, 3> padMaterials(std::uint64_t seed);
/// The middle of each pad along x, its width along x, length and height above the slab, mm.
inline constexpr std::array<double, 3> kPadX{-4.4, 0.0, 4.4};
inline constexpr double kPadWidthMm = 3.2;
inline constexpr double kPadLengthMm = 9.0;
inline constexpr double kPadHeightMm = 1.0;

/// A pit of plunges: the place of its middle along x and its depth, mm.
struct Pit
{
    double xMm = 0.0;
    double depthMm = 0.0;
};
[[nodiscard]] std::vector<Pit> pitsOf(const BlockDesign& design);

/// Returns the closed surface of a block in the tooth frame: the top is at z = 0.
[[nodiscard]] mesh::TriangleMesh blockMesh(const BlockDesign& design);
/// Returns the tissues of a block, one entry per node; empty columns are all zero. The seed shuffles the pads of a
/// block of layers and sets the thickness of the enamel over a junction.
[[nodiscard]] std::vector<terrain::ColumnLayers> blockLayers(const BlockDesign& design, const terrain::Grid& grid,
                                                             std::span<const float> top, std::span<const float> bottom,
                                                             std::uint64_t seed);

}  // namespace core::teeth
