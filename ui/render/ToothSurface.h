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
#include "ui/render/Bleeding.h"
#include "ui/render/Flanks.h"
#include "ui/render/SteepGround.h"
#include "ui/render/SurfaceLight.h"

namespace ui::render {

/// A view ray in the tooth frame; the direction has length 1.
struct Ray
{
    glm::dvec3 originMm{0.0};
    glm::dvec3 direction{0.0, 0.0, -1.0};
};

/// The view's copy of a tooth: the two height maps as drawn, all data derived from them (sewn rim, normals, light,
/// triangles), and intersections with view rays. No OpenGL.
///
/// The drawn lattice is the tooth's own if that has at most kMaxSide nodes on a side. Otherwise it is every second,
/// third or fourth node of it. Ui thread.
class ToothSurface
{
public:
    static constexpr int kMaxSide = 300;
    static constexpr int kTileCells = 16;
    /// Number of indices of a square tile. Each tile has its own range of the index buffer.
    static constexpr int kTileIndices = kTileCells * kTileCells * 6;

    /// A range of indices().
    struct Stretch
    {
        std::size_t begin = 0;
        std::size_t end = 0;  ///< one past the last
    };
    /// The parts that a refresh() changed.
    struct Changes
    {
        core::terrain::NodeRect heights;  ///< heights and positions
        core::terrain::NodeRect normals;
        core::terrain::NodeRect light;
        core::terrain::NodeRect blood;
        std::vector<Stretch> triangles;

        /// Adds the parts that a later refresh() changed.
        void add(const Changes& other)
        {
            heights = united(heights, other.heights);
            normals = united(normals, other.normals);
            light = united(light, other.light);
            blood = united(blood, other.blood);
            triangles.insert(triangles.end(), other.triangles.begin(), other.triangles.end());
        }
        /// Returns the size in bytes of these rectangles in all their maps, without the triangles.
        [[nodiscard]] std::size_t bytes() const;
    };

    /// @param towardsLight  unit vector to the operating light, tooth frame, z > 0
    ToothSurface(std::shared_ptr<const core::terrain::ToothAnatomy> anatomy, glm::vec3 towardsLight);

    /// Sets the heights of one tile. Derived data are updated by the next refresh().
    void write(const core::servo::TilePatch& patch);
    /// Sets the whole top map, over the anatomy's grid.
    void write(const std::vector<float>& top);
    /// Updates all derived data and returns what has changed.
    /// @param hurried  does not update light farther than half a millimetre from a change, which changes little and
    ///                 takes the longest
    Changes refresh(bool hurried = false);
    /// Returns whether some light has not been updated yet.
    [[nodiscard]] bool isBehind() const { return !m_lightDue.isEmpty() || isSweeping(); }
    /// Updates some rows of that light, in a millisecond or two. Repeated calls complete all that was pending when the
    /// first one began.
    Changes sweepLight();
    [[nodiscard]] bool isSweeping() const { return !m_sweep.isEmpty(); }
    /// Sets the ideal surface, over the anatomy's grid; null: the original surface.
    void setIdeal(const core::grading::IdealTop& ideal);
    /// Sets the direction of the operating light. The next refresh() reports all shading as changed.
    void setLight(glm::vec3 towardsLight);

    [[nodiscard]] const core::terrain::ToothAnatomy& anatomy() const { return *m_anatomy; }
    [[nodiscard]] const std::shared_ptr<const core::terrain::ToothAnatomy>& anatomyPointer() const { return m_anatomy; }
    /// Returns the drawn lattice.
    [[nodiscard]] const core::terrain::Grid& lattice() const { return m_lattice; }
    [[nodiscard]] bool isSolid(int i, int j) const { return m_nodes[m_lattice.index(i, j)] == Node::Solid; }

    /// Finds the position of a bur that follows the ray: the first point where the ray meets the occlusal surface from
    /// above or, beside it, the plane at restingHeightMm(). The two join without a step at the sides of the tooth, so a
    /// moving ray moves the point continuously. Returns false if the ray does not point downwards.
    [[nodiscard]] bool meet(const Ray& ray, glm::dvec3& pointMm) const;
    /// Finds the point where a ray meets the horizontal plane at a height. Returns false if the ray does not point
    /// downwards.
    [[nodiscard]] static bool meetPlane(const Ray& ray, double heightMm, glm::dvec3& pointMm);
    /// Returns the highest point of the tooth within a radius, or restingHeightMm() if there is none.
    [[nodiscard]] double highestWithinMm(glm::dvec2 centreMm, double radiusMm) const;
    /// Returns the highest point along the path between two points, over which a bur of that radius must be lifted.
    [[nodiscard]] double highestBetweenMm(glm::dvec2 fromMm, glm::dvec2 toMm, double radiusMm) const;
    /// Returns the height of the occlusal surface below a point, or restingHeightMm() beside it.
    [[nodiscard]] double heightMm(glm::dvec2 pointMm) const;

    /// Returns the current height of the tooth at a point, down to the neck. Empty beside the tooth and in a
    /// perforation.
    [[nodiscard]] std::optional<double> topMm(glm::dvec2 pointMm) const;
    /// Returns the first point where the ray meets the tooth from above, flanks included. Empty if there is none.
    [[nodiscard]] std::optional<glm::dvec3> meetTooth(const Ray& ray) const;
    /// Returns the depth of a point of the tooth below the uncut surface, mm.
    [[nodiscard]] double belowUncutMm(const glm::dvec3& pointMm) const;
    /// Returns the depth below the ideal surface, mm. Negative above it, where material is left.
    [[nodiscard]] double belowIdealMm(const glm::dvec3& pointMm) const;
    /// Returns the height at which a bur waits beside the tooth.
    [[nodiscard]] double restingHeightMm() const { return m_restingMm; }
    /// Return the bounding box of the uncut tooth.
    [[nodiscard]] glm::dvec3 lowestMm() const { return m_lowestMm; }
    [[nodiscard]] glm::dvec3 highestMm() const { return m_highestMm; }
    /// Return the bounding sphere of the crown without roots, which a view must show.
    [[nodiscard]] glm::dvec3 crownMiddleMm() const;
    [[nodiscard]] double crownRadiusMm() const;

    // The arrays that the renderer uploads: one value per node of the lattice, row by row, i fastest.
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
    /// uncut surface, mm. w: share of columns around it with open decay.
    [[nodiscard]] const std::vector<glm::vec4>& lowerLayers() const { return m_lowerLayers; }
    /// The ideal preparation at each node, mm: the depth of its surface below the uncut one, and the distance of the
    /// node from its outline, which is negative inside and at most kOutlineFarMm.
    [[nodiscard]] const std::vector<glm::vec2>& ideal() const { return m_ideal; }
    static constexpr float kOutlineFarMm = 0.4F;
    /// Blood of an opened pulp on each node, 0 to 255.
    [[nodiscard]] const std::vector<std::uint8_t>& blood() const { return m_bleeding->nodes(); }
    /// Returns the number of tiles on a side. The triangles of the upper surface are stored tile by tile; the lower
    /// surface has the same triangles with opposite orientation.
    [[nodiscard]] int tilesPerSide() const { return m_tilesPerSide; }
    [[nodiscard]] const std::vector<std::uint32_t>& indices() const { return m_indices; }  ///< kTileIndices per tile
    [[nodiscard]] const std::vector<int>& indexCounts() const { return m_indexCounts; }    ///< number used in each tile

private:
    enum class Node : std::uint8_t { Empty, Rim, Solid };
    static constexpr int kRimReach = 3;  ///< range of smoothing along the rim, nodes

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
    /// Returns whether a node is uncut and near the rim.
    [[nodiscard]] bool isFlank(std::size_t k) const { return m_top[k] >= m_wholeTop[k] && m_flanks->isNear(k); }

    std::shared_ptr<const core::terrain::ToothAnatomy> m_anatomy;
    core::terrain::Grid m_lattice;
    int m_stride = 1;  ///< nodes of the anatomy's grid per node of the lattice

    std::vector<float> m_wholeTop;
    std::vector<float> m_wholeBottom;
    std::vector<float> m_top;
    std::vector<float> m_flankTop;         ///< uncut top as drawn: without the lattice's steps at flanks and fissures
    std::vector<float> m_flankBottom;      ///< uncut bottom, likewise
    std::vector<glm::vec2> m_flankShifts;  ///< displacement of uncut nodes at the flanks, mm
    std::vector<float> m_flankDej;         ///< enamel-dentin junction without streaks in the thin enamel of a flank
    std::vector<Node> m_nodes;
    std::vector<float> m_solidTop;     ///< as drawn, kEmptyTop where no material is left
    std::vector<float> m_solidBottom;  ///< as drawn, kEmptyBottom where no material is left
    std::optional<SteepGround> m_steep;
    std::optional<Flanks> m_flanks;
    std::vector<float> m_drawnTop;  ///< m_solidTop without the lattice's steps in its walls
    std::vector<float> m_drawnBottom;
    std::vector<float> m_risen;       ///< inverted bottoms, as SteepGround expects them
    std::vector<glm::vec2> m_shifts;  ///< displacement of each solid node, mm
    std::vector<float> m_sewn;        ///< heights of rim nodes before smoothing along the rim
    std::vector<float> m_tops;
    std::vector<float> m_bottoms;
    std::vector<glm::vec2> m_places;
    std::vector<glm::vec3> m_rawNormals[2];
    std::vector<glm::vec3> m_calmNormals[2];
    std::vector<PackedNormal> m_topNormals;
    std::vector<PackedNormal> m_bottomNormals;
    std::optional<SurfaceLight> m_light;
    std::optional<Bleeding> m_bleeding;
    std::vector<glm::vec4> m_upperLayers;
    std::vector<glm::vec4> m_lowerLayers;
    std::vector<glm::vec2> m_ideal;
    std::vector<std::uint32_t> m_indices;
    std::vector<int> m_indexCounts;
    std::vector<std::uint8_t> m_beside;  ///< 1: outside the occlusal surface, where a bur rests at the resting height
    int m_tilesPerSide = 0;
    double m_restingMm = 0.0;
    glm::dvec3 m_lowestMm{0.0};
    glm::dvec3 m_highestMm{0.0};
    core::terrain::NodeRect m_written;
    core::terrain::NodeRect m_lightDue;
    core::terrain::NodeRect m_sweep;  ///< the part of m_lightDue that a sweep has not reached
};

}  // namespace ui::render
