// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/terrain/Grid.h"
#include "core/terrain/Lying.h"

namespace core::terrain {

/// Heights of an empty column: in comparisons with real heights (a tooth is under 100 mm) they are below everything for
/// the top and above everything for the bottom, and arithmetic on them stays finite.
inline constexpr float kEmptyTop = -1.0e6F;
inline constexpr float kEmptyBottom = 1.0e6F;

enum class Material : std::uint8_t { Caries, Enamel, Dentin, Pulp };
inline constexpr int kMaterialCount = 4;

/// One number per material, indexed by Material.
using PerMaterial = std::array<double, kMaterialCount>;

/// The interfaces of one column, mm in the frame in which the tooth is cut. Cutting does not change them.
///
/// The material at a height z inside the tooth is the first one in this list whose condition is true:
///   caries  if cariesFloor < z <= cariesRoof   (an open lesion has its roof at or above the top)
///   pulp    if pulpFloor   < z <= pulpRoof
///   enamel  if z > dej
///   dentin  otherwise
/// An absent layer has floor == roof (any value); a column that is all enamel has dej <= its bottom.
struct ColumnLayers
{
    float cariesRoof = 0.0F;
    float cariesFloor = 0.0F;
    float dej = 0.0F;  ///< enamel-dentin junction
    float pulpRoof = 0.0F;
    float pulpFloor = 0.0F;
    bool operator==(const ColumnLayers&) const = default;
};

/// An uncut tooth. Shared and immutable: the servo, the session and the view read one copy.
struct ToothAnatomy
{
    std::string name;        ///< for display: "36", or the name of its file
    int fdi = 0;             ///< FDI number, 0 if unknown
    std::uint64_t seed = 0;  ///< of the generated variation, its layers and its lesion
    Lying lying;             ///< the side that faces +z
    Grid grid;
    std::vector<float> top;            ///< original occlusal surface, kEmptyTop outside, [side * side]
    std::vector<float> bottom;         ///< original under surface, kEmptyBottom outside, [side * side]
    std::vector<ColumnLayers> layers;  ///< [side * side]
    /// Silhouette area that each column represents, mm2, [side * side]: cell^2 inside; at the rim the part of the
    /// silhouette nearest to that node, so that volumes are not rounded to whole cells. 0 outside.
    std::vector<float> areaMm2;
    /// Decay in dentin has a soft, a leathery and a firm zone (DecayZones.h). False: all decay is of one kind.
    bool hasDecayZones = false;
};

/// Returns whether two uncut teeth are the same: grid, surfaces and tissues, regardless of the name.
[[nodiscard]] bool isSameTooth(const ToothAnatomy& a, const ToothAnatomy& b);

/// Returns whether two uncut teeth differ by at most 0.001 mm. The last digits of a generated tooth depend on the
/// processor: its mathematical functions may be rounded otherwise.
[[nodiscard]] bool isAlmostSameTooth(const ToothAnatomy& a, const ToothAnatomy& b);

/// Returns whether any column of a tooth has decay.
[[nodiscard]] bool hasDecay(const ToothAnatomy& anatomy);

/// A tooth as cut so far: two height maps over an anatomy. A perforated column is empty in both maps.
struct Tooth
{
    std::shared_ptr<const ToothAnatomy> anatomy;
    std::vector<float> top;
    std::vector<float> bottom;

    explicit Tooth(std::shared_ptr<const ToothAnatomy> uncut)
        : anatomy(std::move(uncut)), top(anatomy->top), bottom(anatomy->bottom)
    {}
    [[nodiscard]] const Grid& grid() const { return anatomy->grid; }
    [[nodiscard]] bool isSolid(std::size_t index) const { return top[index] > bottom[index]; }
};

/// Returns the tooth with the top map `top`, left by some cutting of this anatomy. Where the top is empty, so is the
/// bottom.
[[nodiscard]] Tooth restored(std::shared_ptr<const ToothAnatomy> anatomy, std::vector<float> top);

/// Returns the material at height z of a column, by the rule of ColumnLayers. z must be inside the tooth.
[[nodiscard]] Material materialAt(const ColumnLayers& column, float z);

/// Returns whether the part of a column between low and high (low < high) is of one material, and stores that in
/// `material`. May return false for some that are: a fast test for the thin slices that a bur removes.
[[nodiscard]] inline bool isOneMaterial(const ColumnLayers& column, float low, float high, Material& material) noexcept
{
    const bool lesionAway =
        column.cariesRoof <= low || column.cariesFloor >= high || column.cariesFloor >= column.cariesRoof;
    const bool pulpAway = column.pulpRoof <= low || column.pulpFloor >= high || column.pulpFloor >= column.pulpRoof;
    material = column.dej <= low ? Material::Enamel : Material::Dentin;
    return lesionAway && pulpAway && (column.dej <= low || column.dej >= high);
}

/// Returns the length of each material in the part of a column between low and high (low <= high), mm.
[[nodiscard]] PerMaterial lengthsBetween(const ColumnLayers& column, float low, float high);

/// A part of a column that is of one material, low < high.
struct MaterialSpan
{
    Material material = Material::Enamel;
    float lowMm = 0.0F;
    float highMm = 0.0F;
    bool operator==(const MaterialSpan&) const = default;
};
/// The parts of a column from below upwards. Five interfaces give at most six.
struct MaterialSpans
{
    std::array<MaterialSpan, 6> span{};
    int count = 0;
    [[nodiscard]] const MaterialSpan* begin() const { return span.data(); }
    [[nodiscard]] const MaterialSpan* end() const { return span.data() + count; }
};

/// Returns the materials of the part of a column between low and high; neighbouring spans differ in material. None if
/// low >= high.
[[nodiscard]] MaterialSpans spansBetween(const ColumnLayers& column, float low, float high);

/// Returns whether column k of the uncut tooth has pulp.
[[nodiscard]] bool hasPulp(const ToothAnatomy& anatomy, std::size_t k);

/// Returns the volume of each material, mm3. Sums are in index order: the same bits everywhere.
[[nodiscard]] PerMaterial volumes(const Tooth& tooth);

/// Returns the removed volume of each material, mm3.
[[nodiscard]] PerMaterial removedVolumes(const Tooth& tooth);
/// Adds to `sum` what is removed from column k with its top at `top` (kEmptyTop if all of it), mm3.
void addRemoved(const ToothAnatomy& anatomy, std::size_t k, float top, PerMaterial& sum);

/// Returns 1 for the columns of holes through the tooth, [side * side]; empty if there is none. A hole is surrounded by
/// tooth: material ground off the outside is none.
[[nodiscard]] std::vector<std::uint8_t> perforations(const Tooth& tooth);

/// Returns the 64-bit FNV-1a over grid and both maps, bit for bit. Equal teeth have equal hashes, and different teeth
/// different ones except for collisions. `cusp replay` prints it.
[[nodiscard]] std::uint64_t stateHash(const Tooth& tooth);

}  // namespace core::terrain
