// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "core/grading/IdealCavity.h"
#include "core/servo/ServoState.h"
#include "core/terrain/NodeRect.h"
#include "core/terrain/Tooth.h"
#include "ui/render/Flanks.h"
#include "ui/render/SteepGround.h"
#include "ui/render/SurfaceLight.h"

namespace ui::render {

/// A ray of sight in the tooth frame; the direction has length 1.
struct Ray
{
    glm::dvec3 originMm{0.0};
    glm::dvec3 direction{0.0, 0.0, -1.0};
};

/// The view's own copy of a tooth: the two height maps as they are drawn, with all that is derived from them (sewn
/// rim, normals, light, triangles), and where a ray of sight meets them. No OpenGL in here.
///
/// The lattice drawn is the tooth's own up to kMaxSide nodes a side and every second, third or fourth node of a finer
/// one. Ui thread.
class ToothSurface
{
public:
    static constexpr int kMaxSide = 300;
    static constexpr int kTileCells = 16;
    /// Square tile of cells that shares one stretch of the index buffer.
    static constexpr int kTileIndices = kTileCells * kTileCells * 6;

    /// Part of indices().
    struct Stretch
    {
        std::size_t begin = 0;
        std::size_t end = 0;  ///< one past the last
    };
    /// What a refresh() changed.
    struct Changes
    {
        core::terrain::NodeRect heights;  ///< heights and places
        core::terrain::NodeRect normals;
        core::terrain::NodeRect light;
        std::vector<Stretch> triangles;

        /// Of the rectangles in all maps they are in; without the triangles.
        [[nodiscard]] std::size_t bytes() const;
    };

    /// @param towardsLight  unit vector to the operating light, tooth frame, z > 0
    ToothSurface(std::shared_ptr<const core::terrain::ToothAnatomy> anatomy, glm::vec3 towardsLight);

    /// Takes over the heights of one tile. Nothing derived moves until refresh().
    void write(const core::servo::TilePatch& patch);
    /// The same for the whole top map, over the anatomy's grid.
    void write(const std::vector<float>& top);
    /// Brings everything derived up to date and says what that was. Hurried, the light further than half a millimetre
    /// from what was written is left for the next time without haste: it changes little, and takes the longest.
    Changes refresh(bool hurried = false);
    /// Light was left for later.
    [[nodiscard]] bool isBehind() const { return !m_lightDue.isEmpty() || isSweeping(); }
    /// Brings some rows of that light up to date, in a millisecond or two: as often as it takes, a sweep goes over all
    /// that was left when it began.
    Changes sweepLight();
    [[nodiscard]] bool isSweeping() const { return !m_sweep.isEmpty(); }
    /// The surface as it ought to become, over the anatomy's grid; null: as it was.
    void setIdeal(const core::grading::IdealTop& ideal);
    /// Moves the operating light; the next refresh() reports all shading as changed.
    void setLight(glm::vec3 towardsLight);

    [[nodiscard]] const core::terrain::ToothAnatomy& anatomy() const { return *m_anatomy; }
    [[nodiscard]] const std::shared_ptr<const core::terrain::ToothAnatomy>& anatomyPointer() const { return m_anatomy; }
    /// The lattice that is drawn.
    [[nodiscard]] const core::terrain::Grid& lattice() const { return m_lattice; }
    [[nodiscard]] bool isSolid(int i, int j) const { return m_nodes[m_lattice.index(i, j)] == Node::Solid; }

    /// Where a bur goes that follows the ray: first point where that meets the chewing surface from above or, beside
    /// it, the plane at restingHeightMm(). The two join without a step at the sides of the tooth, so that a moving ray
    /// finds a moving point. False when the ray does not go down.
    [[nodiscard]] bool meet(const Ray& ray, glm::dvec3& pointMm) const;
    /// Where a ray meets the horizontal plane at a height. False when the ray does not go down.
    [[nodiscard]] static bool meetPlane(const Ray& ray, double heightMm, glm::dvec3& pointMm);
    /// Highest point of the tooth within a radius, or restingHeightMm() where there is none.
    [[nodiscard]] double highestWithinMm(glm::dvec2 centreMm, double radiusMm) const;
    /// The same along the way from one point to another: over what a bur of that radius must be lifted to go there.
    [[nodiscard]] double highestBetweenMm(glm::dvec2 fromMm, glm::dvec2 toMm, double radiusMm) const;
    /// Height of the chewing surface below a point, restingHeightMm() beside it.
    [[nodiscard]] double heightMm(glm::dvec2 pointMm) const;

    /// Height of the tooth there as cut so far, down to the neck; nothing beside it and in a hole.
    [[nodiscard]] std::optional<double> topMm(glm::dvec2 pointMm) const;
    /// First point where the ray meets the tooth itself from above, flanks included.
    [[nodiscard]] std::optional<glm::dvec3> meetTooth(const Ray& ray) const;
    /// How far a point of the tooth lies below the uncut surface, mm.
    [[nodiscard]] double belowUncutMm(const glm::dvec3& pointMm) const;
    /// The same below the ideal surface; negative above it: so much is still to go.
    [[nodiscard]] double belowIdealMm(const glm::dvec3& pointMm) const;
    /// Height at which a bur waits beside the tooth.
    [[nodiscard]] double restingHeightMm() const { return m_restingMm; }
    /// Box of the uncut tooth.
    [[nodiscard]] glm::dvec3 lowestMm() const { return m_lowestMm; }
    [[nodiscard]] glm::dvec3 highestMm() const { return m_highestMm; }
    /// Ball around the crown, what there is of roots left out: what a view must show.
    [[nodiscard]] glm::dvec3 crownMiddleMm() const;
    [[nodiscard]] double crownRadiusMm() const;

    // What the renderer uploads: arrays over the lattice, row by row, i fast.
    [[nodiscard]] const std::vector<float>& tops() const { return m_tops; }  ///< as drawn: sewn, walls smoothed; mm
    [[nodiscard]] const std::vector<float>& bottoms() const { return m_bottoms; }
    [[nodiscard]] const std::vector<glm::vec2>& places() const { return m_places; }  ///< x, y of each node, mm
    using PackedNormal = std::array<std::int16_t, 2>;  ///< x and y of a unit normal, 32767 is one
    [[nodiscard]] const std::vector<PackedNormal>& topNormals() const { return m_topNormals; }
    [[nodiscard]] const std::vector<PackedNormal>& bottomNormals() const { return m_bottomNormals; }
    using Light = SurfaceLight::Light;
    [[nodiscard]] const std::vector<Light>& light() const { return m_light->nodes(); }
    [[nodiscard]] const std::vector<glm::vec4>& upperLayers() const
    {
        return m_upperLayers;
    }  ///< roof, floor, dej, pulp
    /// x: floor of the pulp, mm. y: share of decayed columns around a node, one half on the outline of a lesion. z: the
    /// uncut surface, mm. w: share of columns around whose decay is open.
    [[nodiscard]] const std::vector<glm::vec4>& lowerLayers() const { return m_lowerLayers; }
    /// Of the ideal preparation at each node: how far its surface lies below the uncut one, and how far the node is
    /// outside its outline, negative inside, at most kOutlineFarMm; mm.
    [[nodiscard]] const std::vector<glm::vec2>& ideal() const { return m_ideal; }
    static constexpr float kOutlineFarMm = 0.4F;
    /// Triangles of the upper surface, tile by tile; the lower surface has the same ones turned over.
    [[nodiscard]] int tilesPerSide() const { return m_tilesPerSide; }
    [[nodiscard]] const std::vector<std::uint32_t>& indices() const { return m_indices; }  ///< kTileIndices a tile
    [[nodiscard]] const std::vector<int>& indexCounts() const { return m_indexCounts; }    ///< used of each tile

private:
    enum class Node : std::uint8_t { Empty, Rim, Solid };
    static constexpr int kRimReach = 3;  ///< how far along the rim it is smoothed, nodes

    void takeAnatomy();
    void findResting();
    void smoothFlanks();
    void smoothFissures();
    void sew(const core::terrain::NodeRect& written);
    void smoothRim(const core::terrain::NodeRect& rect);
    void smoothOutline(const core::terrain::NodeRect& rect);
    void smoothIdealOutline();
    [[nodiscard]] float flankNormal(std::size_t map, std::size_t k, glm::vec3& normal) const;
    [[nodiscard]] float uncutAround(int i, int j) const;
    [[nodiscard]] glm::vec3 softNormal(int map, int i, int j) const;
    [[nodiscard]] core::terrain::NodeRect bendNormals(const core::terrain::NodeRect& rect);
    [[nodiscard]] core::terrain::NodeRect shineLight(const core::terrain::NodeRect& rect);
    [[nodiscard]] std::vector<Stretch> buildTriangles(const core::terrain::NodeRect& rect);
    template <class Use>
    void forRimAround(int i, int j, Use&& use) const;
    [[nodiscard]] glm::vec2 slope(const std::vector<float>& heights, int i, int j) const;
    [[nodiscard]] bool isShown(int i, int j) const
    {
        return m_lattice.contains(i, j) && m_nodes[m_lattice.index(i, j)] != Node::Empty;
    }
    [[nodiscard]] float pickHeight(std::size_t k) const;
    template <class Height>
    [[nodiscard]] std::optional<glm::dvec3> firstBelow(const Ray& ray, Height&& height) const;
    template <class IsThere, class Value>
    [[nodiscard]] std::optional<double> where(glm::dvec2 pointMm, IsThere&& isThere, Value&& value) const;
    template <class Value>
    [[nodiscard]] double between(glm::dvec2 pointMm, Value&& value) const;
    /// Uncut ground near the rim.
    [[nodiscard]] bool isFlank(std::size_t k) const { return m_top[k] >= m_wholeTop[k] && m_flanks->isNear(k); }

    std::shared_ptr<const core::terrain::ToothAnatomy> m_anatomy;
    core::terrain::Grid m_lattice;
    int m_stride = 1;  ///< nodes of the anatomy's grid to one of the lattice

    std::vector<float> m_wholeTop;
    std::vector<float> m_wholeBottom;
    std::vector<float> m_top;
    std::vector<float> m_flankTop;         ///< whole top as drawn: freed of the lattice's steps at flanks, fissures
    std::vector<float> m_flankBottom;      ///< likewise from below
    std::vector<glm::vec2> m_flankShifts;  ///< of uncut nodes at the flanks, mm
    std::vector<float> m_flankDej;         ///< enamel-dentin junction, so that thin enamel at a flank has no streaks
    std::vector<Node> m_nodes;
    std::vector<float> m_solidTop;     ///< as drawn, kEmptyTop where nothing is left
    std::vector<float> m_solidBottom;  ///< as drawn, kEmptyBottom where nothing is left
    std::optional<SteepGround> m_steep;
    std::optional<Flanks> m_flanks;
    std::vector<float> m_drawnTop;  ///< m_solidTop with its walls freed of the lattice's steps
    std::vector<float> m_drawnBottom;
    std::vector<float> m_risen;       ///< bottoms turned over, as SteepGround takes them
    std::vector<glm::vec2> m_shifts;  ///< of each solid node, mm
    std::vector<float> m_sewn;        ///< of rim nodes, before they are smoothed along the rim
    std::vector<float> m_tops;
    std::vector<float> m_bottoms;
    std::vector<glm::vec2> m_places;
    std::vector<glm::vec3> m_rawNormals[2];
    std::vector<glm::vec3> m_calmNormals[2];
    std::vector<PackedNormal> m_topNormals;
    std::vector<PackedNormal> m_bottomNormals;
    std::optional<SurfaceLight> m_light;
    std::vector<glm::vec4> m_upperLayers;
    std::vector<glm::vec4> m_lowerLayers;
    std::vector<glm::vec2> m_ideal;
    std::vector<std::uint32_t> m_indices;
    std::vector<int> m_indexCounts;
    std::vector<std::uint8_t> m_beside;  ///< 1: outside the chewing surface, a bur waits at the resting height
    int m_tilesPerSide = 0;
    double m_restingMm = 0.0;
    glm::dvec3 m_lowestMm{0.0};
    glm::dvec3 m_highestMm{0.0};
    core::terrain::NodeRect m_written;
    core::terrain::NodeRect m_lightDue;
    core::terrain::NodeRect m_sweep;  ///< what is left of it in a sweep
};

}  // namespace ui::render
