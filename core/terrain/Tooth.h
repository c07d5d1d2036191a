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

/// Heights of a column that holds nothing: any comparison with real heights (a tooth is under 100 mm) says "below
/// everything" for the top and "above everything" for the bottom, and finite arithmetic on them stays finite.
inline constexpr float kEmptyTop = -1.0e6F;
inline constexpr float kEmptyBottom = 1.0e6F;

enum class Material : std::uint8_t { Caries, Enamel, Dentin, Pulp };
inline constexpr int kMaterialCount = 4;

/// One figure per material, indexed by Material.
using PerMaterial = std::array<double, kMaterialCount>;

/// The interfaces of one column, mm in the frame the tooth is cut in. They do not move while the tooth is cut.
///
/// Reading a height z inside the tooth, first match wins:
///   caries  if cariesFloor < z <= cariesRoof   (an open lesion has its roof at or above the top)
///   pulp    if pulpFloor   < z <= pulpRoof
///   enamel  if z > dej
///   dentin  otherwise
/// An absent layer has floor == roof (any value); a column of enamel alone has dej <= its bottom.
struct ColumnLayers
{
    float cariesRoof = 0.0F;
    float cariesFloor = 0.0F;
    float dej = 0.0F;  ///< enamel-dentin junction
    float pulpRoof = 0.0F;
    float pulpFloor = 0.0F;
    bool operator==(const ColumnLayers&) const = default;
};

/// What a tooth is before anyone cuts it. Shared and immutable: the servo, the session and the view read one copy.
struct ToothAnatomy
{
    std::string name;        ///< what a person calls it: "36", or the file it was read from
    int fdi = 0;             ///< FDI number, 0 when unknown
    std::uint64_t seed = 0;  ///< of the generated variation, its layers and its lesion
    Lying lying;             ///< which side of it looks along +z
    Grid grid;
    std::vector<float> top;            ///< original occlusal surface, kEmptyTop outside, [side * side]
    std::vector<float> bottom;         ///< original under surface, kEmptyBottom outside, [side * side]
    std::vector<ColumnLayers> layers;  ///< [side * side]
    /// Area of silhouette each column stands for, mm2, [side * side]: cell^2 inside; at the rim the part of the
    /// silhouette nearest to that node, so that volumes are not rounded to whole cells. 0 outside.
    std::vector<float> areaMm2;
    /// Decay in dentin has a soft, a leathery and a firm zone (DecayZones.h). False: decay is of one kind throughout.
    bool hasDecayZones = false;
};

/// Whether two teeth are the same before anyone cuts them: grid, surfaces and tissues, whatever they are called.
[[nodiscard]] bool isSameTooth(const ToothAnatomy& a, const ToothAnatomy& b);

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

/// The tooth whose top map is `top` (as some cutting of this anatomy left it): where it is empty, so is the bottom.
[[nodiscard]] Tooth restored(std::shared_ptr<const ToothAnatomy> anatomy, std::vector<float> top);

/// The material at height z of a column, by the rule of ColumnLayers. z is taken to lie inside the tooth.
[[nodiscard]] Material materialAt(const ColumnLayers& column, float z);

/// Whether the part of a column between low and high (low < high) is of one material, which goes to `material`. False
/// is also said of a few that are: this is the quick answer for the thin slices that a bur takes off.
[[nodiscard]] inline bool isOneMaterial(const ColumnLayers& column, float low, float high, Material& material) noexcept
{
    const bool lesionAway =
        column.cariesRoof <= low || column.cariesFloor >= high || column.cariesFloor >= column.cariesRoof;
    const bool pulpAway = column.pulpRoof <= low || column.pulpFloor >= high || column.pulpFloor >= column.pulpRoof;
    material = column.dej <= low ? Material::Enamel : Material::Dentin;
    return lesionAway && pulpAway && (column.dej <= low || column.dej >= high);
}

/// Length of each material in the part of a column between low and high (low <= high), mm.
[[nodiscard]] PerMaterial lengthsBetween(const ColumnLayers& column, float low, float high);

/// A stretch of a column that is of one material, low < high.
struct MaterialSpan
{
    Material material = Material::Enamel;
    float lowMm = 0.0F;
    float highMm = 0.0F;
    bool operator==(const MaterialSpan&) const = default;
};
/// The stretches of a column from below upwards. Five interfaces make six of them at most.
struct MaterialSpans
{
    std::array<MaterialSpan, 6> span{};
    int count = 0;
    [[nodiscard]] const MaterialSpan* begin() const { return span.data(); }
    [[nodiscard]] const MaterialSpan* end() const { return span.data() + count; }
};

/// What the part of a column between low and high is made of; neighbouring spans differ in material. None when low >=
/// high.
[[nodiscard]] MaterialSpans spansBetween(const ColumnLayers& column, float low, float high);

/// Whether column k of the uncut tooth holds pulp.
[[nodiscard]] bool hasPulp(const ToothAnatomy& anatomy, std::size_t k);

/// Volume of each material present, mm3. Sums run in index order: the same bits everywhere.
[[nodiscard]] PerMaterial volumes(const Tooth& tooth);

/// Volume of each material removed since the anatomy, mm3.
[[nodiscard]] PerMaterial removedVolumes(const Tooth& tooth);
/// Adds to `sum` what is gone of column k when its top is at `top` (kEmptyTop if all of it), mm3.
void addRemoved(const ToothAnatomy& anatomy, std::size_t k, float top, PerMaterial& sum);

/// The columns of holes through the tooth, 1 each, [side * side]; empty if there is none. A hole has tooth all around:
/// what is ground off the outside is none.
[[nodiscard]] std::vector<std::uint8_t> perforations(const Tooth& tooth);

/// 64-bit FNV-1a over grid and both maps, bit for bit. Two teeth are the same if and only if (short of a collision)
/// their hashes are: what `cusp replay` prints.
[[nodiscard]] std::uint64_t stateHash(const Tooth& tooth);

}  // namespace core::terrain
