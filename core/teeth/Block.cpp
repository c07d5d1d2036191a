// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/teeth/Block.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/Rng.h"
#include "core/teeth/ValueNoise.h"

namespace core::teeth {
namespace {

constexpr std::string_view kPrefix = "block:";
constexpr std::array<std::string_view, 11> kShapes{"line", "circle", "cross",  "square",  "dovetail", "staircase",
                                                   "bar",  "tee",    "layers", "plunges", "junction"};

constexpr std::array<NumberField<BlockDesign>, 10> kFields{{
    {"side_mm", "block's side", "mm", &BlockDesign::sideMm, 6.0, 30.0},
    {"height_mm", "block's height", "mm", &BlockDesign::heightMm, 2.0, 20.0},
    {"enamel_mm", "thickness of the enamel layer", "mm", &BlockDesign::enamelMm, 0.0, 10.0},
    {"width_mm", "width of the channel", "mm", &BlockDesign::widthMm, 0.5, 5.0},
    {"depth_mm", "depth of the channel", "mm", &BlockDesign::depthMm, 0.1, 6.0},
    {"length_mm", "length of the shape", "mm", &BlockDesign::lengthMm, 1.0, 28.0},
    {"flare_mm", "flare of the dovetail", "mm", &BlockDesign::flareMm, 0.0, 3.0},
    {"steps", "number of steps", "", &BlockDesign::steps, 2.0, 8.0, true},
    {"corner_radius_mm", "radius of inner corners", "mm", &BlockDesign::cornerRadiusMm, 0.0, 2.0},
    {"line_angle_mm", "radius between floor and wall", "mm", &BlockDesign::lineAngleMm, 0.0, 1.0},
}};

constexpr double kMarginMm = 0.5;       ///< block that stays around and below a shape
constexpr double kLeastIslandMm = 0.5;  ///< smallest island that a ring or frame surrounds
constexpr double kPadSoftMm = 2.0;      ///< depth of the soft material of a pad
constexpr double kBetweenPitsMm = 0.5;  ///< block that stays between two pits
constexpr double kWaveMm = 3.5;         ///< distance from thick to thin enamel over a junction

Status misfit(const char* sentence, std::vector<LocalizableText> values = {})
{
    return unexpected(ErrorCode::OutOfRange, LocalizableText{sentence, std::move(values)});
}

LocalizableText number(double value)
{
    return noted(plainNumber(value));
}

/// A closed surface of boxes side by side that share their corners: heights over a lattice of rectangles.
class Steps
{
public:
    Steps(std::vector<double> x, std::vector<double> y, std::vector<double> heights, double bottom)
        : m_x(std::move(x)), m_y(std::move(y)), m_heights(std::move(heights)), m_bottom(bottom)
    {}

    [[nodiscard]] mesh::TriangleMesh build()
    {
        for (std::size_t b = 0; b + 1 < m_y.size(); ++b)
            for (std::size_t a = 0; a + 1 < m_x.size(); ++a) {
                const double z = height(a, b);
                quad({m_x[a], m_y[b], z}, {m_x[a + 1], m_y[b], z}, {m_x[a + 1], m_y[b + 1], z},
                     {m_x[a], m_y[b + 1], z});
                quad({m_x[a], m_y[b + 1], m_bottom}, {m_x[a + 1], m_y[b + 1], m_bottom}, {m_x[a + 1], m_y[b], m_bottom},
                     {m_x[a], m_y[b], m_bottom});
                // Each wall belongs to the higher of the two boxes beside it.
                const glm::dvec2 sw{m_x[a], m_y[b]};
                const glm::dvec2 se{m_x[a + 1], m_y[b]};
                const glm::dvec2 ne{m_x[a + 1], m_y[b + 1]};
                const glm::dvec2 nw{m_x[a], m_y[b + 1]};
                wall(sw, se, z, b > 0 ? height(a, b - 1) : m_bottom);
                wall(se, ne, z, a + 2 < m_x.size() ? height(a + 1, b) : m_bottom);
                wall(ne, nw, z, b + 2 < m_y.size() ? height(a, b + 1) : m_bottom);
                wall(nw, sw, z, a > 0 ? height(a - 1, b) : m_bottom);
            }
        return std::move(m_mesh);
    }

private:
    [[nodiscard]] double height(std::size_t a, std::size_t b) const { return m_heights[b * (m_x.size() - 1) + a]; }

    void wall(glm::dvec2 from, glm::dvec2 to, double high, double low)
    {
        // Walls are divided at every level, so that walls of different height share the corners of their common edge.
        std::vector<double> levels{high, low};
        for (const double z : m_heights)
            if (z < high && z > low)
                levels.push_back(z);
        std::sort(levels.begin(), levels.end());
        levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
        for (std::size_t k = 0; high > low && k + 1 < levels.size(); ++k)
            quad({from, levels[k]}, {to, levels[k]}, {to, levels[k + 1]}, {from, levels[k + 1]});
    }

    void quad(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c, glm::dvec3 d)
    {
        const auto first = static_cast<std::uint32_t>(m_mesh.vertices.size());
        for (const glm::dvec3& corner : {a, b, c, d})
            m_mesh.vertices.emplace_back(corner);
        m_mesh.triangles.push_back({first, first + 1, first + 2});
        m_mesh.triangles.push_back({first, first + 2, first + 3});
    }

    std::vector<double> m_x;
    std::vector<double> m_y;
    std::vector<double> m_heights;  ///< row by row
    double m_bottom;
    mesh::TriangleMesh m_mesh;
};

/// Depth of the junction below the top of a block, mm: a smooth random field, scaled so that it ranges from enamelMm to
/// depthMm within the window.
class JunctionDepth
{
public:
    JunctionDepth(const BlockDesign& design, std::uint64_t seed)
        : m_noise(seed ^ 0x6a756e6374696f6eULL, kWaveMm), m_thinnestMm(design.enamelMm), m_thickestMm(design.depthMm)
    {
        constexpr int kSamples = 40;
        for (int b = 0; b <= kSamples; ++b)
            for (int a = 0; a <= kSamples; ++a) {
                const double here = m_noise.at(
                    (static_cast<double>(a) / kSamples - 0.5) * (design.lengthMm - 2.0 * design.cornerRadiusMm),
                    (static_cast<double>(b) / kSamples - 0.5) * (design.widthMm - 2.0 * design.cornerRadiusMm));
                m_least = std::min(m_least, here);
                m_most = std::max(m_most, here);
            }
    }

    [[nodiscard]] double at(glm::dvec2 placeMm) const
    {
        const double range = m_most - m_least;
        const double share = range > 0.0 ? (m_noise.at(placeMm.x, placeMm.y) - m_least) / range : 0.5;
        return m_thinnestMm + std::clamp(share, 0.0, 1.0) * (m_thickestMm - m_thinnestMm);
    }

private:
    ValueNoise m_noise;
    double m_thinnestMm;
    double m_thickestMm;
    double m_least = 1.0;
    double m_most = -1.0;
};

/// Checks the values that only some shapes need.
Status validateShape(const BlockDesign& design)
{
    if (design.shape == BlockShape::Staircase && design.lengthMm / design.steps < design.widthMm)
        return misfit("the length of the shape (length_mm) leaves each of its steps shorter than the channel is wide "
                      "(width_mm)");
    if (design.shape == BlockShape::Plunges &&
        (design.lengthMm - design.widthMm) / (design.steps - 1.0) < design.widthMm + kBetweenPitsMm)
        return misfit("the length of the shape (length_mm) leaves less than %1 mm of the block between its pits "
                      "(width_mm, steps)",
                      {number(kBetweenPitsMm)});
    if (design.shape == BlockShape::Junction && design.depthMm < design.enamelMm)
        return misfit("the enamel is thinner where it is thickest (depth_mm) than where it is thinnest (enamel_mm)");
    return {};
}

bool hasSteps(BlockShape shape)
{
    return shape == BlockShape::Staircase || shape == BlockShape::Plunges;
}

}  // namespace

std::span<const NumberField<BlockDesign>> blockFields()
{
    return kFields;
}

Status validate(const BlockDesign& design)
{
    if (Status numbers = validateNumbers(blockFields(), design); !numbers)
        return numbers;
    if (design.enamelMm > design.heightMm)
        return misfit("the thickness of the enamel layer (enamel_mm) is more than the block's height (height_mm)");
    if (design.shape == BlockShape::Layers) {
        if (design.sideMm < 2.0 * kPadX.back() + kPadWidthMm || design.heightMm < kPadHeightMm + kPadSoftMm)
            return misfit("the block's side or height (side_mm, height_mm) is too small for three pads: they take %1 "
                          "and %2 mm",
                          {number(2.0 * kPadX.back() + kPadWidthMm), number(kPadHeightMm + kPadSoftMm)});
        return {};
    }
    const double widest = design.lengthMm + (design.shape == BlockShape::Dovetail ? 2.0 * design.flareMm : 0.0);
    if (widest > design.sideMm - 2.0 * kMarginMm)
        return misfit("the length of the shape (length_mm) leaves less than %1 mm of the block around it",
                      {number(kMarginMm)});
    if (design.depthMm > design.heightMm - kMarginMm)
        return misfit("the depth of the channel (depth_mm) leaves less than %1 mm of the block below it",
                      {number(kMarginMm)});
    if (2.0 * design.cornerRadiusMm > design.widthMm)
        return misfit("the radius of inner corners (corner_radius_mm) is more than half of the width of the channel "
                      "(width_mm)");
    if (design.lineAngleMm > design.cornerRadiusMm)
        return misfit("the radius between floor and wall (line_angle_mm) is more than the radius of inner corners "
                      "(corner_radius_mm): no bur leaves that");
    if (design.lineAngleMm > design.depthMm / (hasSteps(design.shape) ? design.steps : 1.0))
        return misfit("the radius between floor and wall (line_angle_mm) is more than the depth (depth_mm)");
    const bool goesRound = design.shape == BlockShape::Circle || design.shape == BlockShape::Square;
    const double needed = goesRound ? 2.0 * design.widthMm + kLeastIslandMm : 3.0 * design.widthMm;
    const bool isStraight =
        hasSteps(design.shape) || design.shape == BlockShape::Line || design.shape == BlockShape::Junction;
    if (!isStraight && design.lengthMm < needed)
        return misfit("the length of the shape (length_mm) must be at least %1 mm with a channel of that width "
                      "(width_mm)",
                      {number(needed)});
    if (design.lengthMm < design.widthMm)
        return misfit("the length of the shape (length_mm) is less than the width of the channel (width_mm)");
    return validateShape(design);
}

std::string blockName(BlockShape shape)
{
    return std::string(kPrefix) + std::string(kShapes.at(static_cast<std::size_t>(shape)));
}

std::optional<Result<BlockDesign>> findBlock(std::string_view name)
{
    if (!name.starts_with(kPrefix))
        return std::nullopt;
    const auto found = std::find(kShapes.begin(), kShapes.end(), name.substr(kPrefix.size()));
    if (found != kShapes.end()) {
        BlockDesign design;
        design.shape = static_cast<BlockShape>(found - kShapes.begin());
        return design;
    }
    std::string known;
    for (const std::string_view shape : kShapes)
        known.append(known.empty() ? "" : ", ").append(kPrefix).append(shape);
    return unexpected(ErrorCode::UnknownName, LocalizableText{"there is no practice block '%1'; choose one of %2",
                                                              {noted(std::string(name)), noted(std::move(known))}});
}

std::array<terrain::Material, 3> padMaterials(std::uint64_t seed)
{
    using terrain::Material;
    std::array<Material, 3> order{Material::Enamel, Material::Dentin, Material::Caries};
    Rng rng(seed ^ 0x70616473ULL);
    for (int k = 2; k > 0; --k)
        std::swap(order.at(static_cast<std::size_t>(k)), order.at(static_cast<std::size_t>(rng.below(k + 1))));
    return order;
}

std::vector<Pit> pitsOf(const BlockDesign& design)
{
    std::vector<Pit> pits;
    const auto count = static_cast<int>(design.steps);
    pits.reserve(static_cast<std::size_t>(count));
    for (int k = 0; k < count; ++k)
        pits.push_back({(static_cast<double>(k) / (count - 1) - 0.5) * (design.lengthMm - design.widthMm),
                        design.depthMm * (k + 1) / count});
    return pits;
}

mesh::TriangleMesh blockMesh(const BlockDesign& design)
{
    const double half = 0.5 * design.sideMm;
    if (design.shape != BlockShape::Layers)
        return Steps({-half, half}, {-half, half}, {0.0}, -design.heightMm).build();
    std::vector<double> x{-half};
    for (const double middle : kPadX) {
        x.push_back(middle - 0.5 * kPadWidthMm);
        x.push_back(middle + 0.5 * kPadWidthMm);
    }
    x.push_back(half);
    const double slab = -kPadHeightMm;
    std::vector<double> heights(3 * (x.size() - 1), slab);
    for (std::size_t pad = 0; pad < kPadX.size(); ++pad)
        heights[(x.size() - 1) + 2 * pad + 1] = 0.0;
    const double along = std::min(0.5 * kPadLengthMm, 0.8 * half);
    return Steps(std::move(x), {-half, -along, along, half}, std::move(heights), -design.heightMm).build();
}

std::vector<terrain::ColumnLayers> blockLayers(const BlockDesign& design, const terrain::Grid& grid,
                                               std::span<const float> top, std::span<const float> bottom,
                                               std::uint64_t seed)
{
    std::vector<terrain::ColumnLayers> layers(grid.count());
    const bool hasPads = design.shape == BlockShape::Layers;
    const std::array<terrain::Material, 3> order = padMaterials(seed);
    std::optional<JunctionDepth> junction;
    if (design.shape == BlockShape::Junction)
        junction.emplace(design, seed);
    const float slab = hasPads ? -static_cast<float>(kPadHeightMm) : 0.0F;
    for (std::size_t k = 0; k < grid.count(); ++k) {
        if (!(top[k] > bottom[k]))
            continue;
        layers[k].dej = slab - static_cast<float>(junction ? junction->at(grid.nodeMm(k)) : design.enamelMm);
        if (!hasPads || !(top[k] > slab))
            continue;
        const double x = grid.nodeMm(k).x;
        const std::size_t pad = x < 0.5 * (kPadX[0] + kPadX[1]) ? 0 : x < 0.5 * (kPadX[1] + kPadX[2]) ? 1 : 2;
        const auto deep = -static_cast<float>(kPadHeightMm + kPadSoftMm);
        switch (order.at(pad)) {
        case terrain::Material::Enamel:
            layers[k].dej = deep;
            break;
        case terrain::Material::Caries:
            layers[k].cariesRoof = 0.0F;
            layers[k].cariesFloor = deep;
            [[fallthrough]];
        default:
            layers[k].dej = 0.0F;
        }
    }
    return layers;
}

}  // namespace core::teeth
