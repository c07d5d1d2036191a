// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "core/terrain/Grid.h"
#include "core/terrain/NodeRect.h"

namespace ui::render {

class Flanks;

/// The maps of a tooth that its lighting depends on: [side * side] of the drawn lattice, mm.
struct LitMaps
{
    const std::vector<float>& wholeTop;     ///< before anything was cut
    const std::vector<float>& top;          ///< as cut so far
    const std::vector<float>& solidTop;     ///< as drawn; kEmptyTop where no material is left
    const std::vector<float>& drawnTop;     ///< the same without the lattice's steps in walls
    const std::vector<glm::vec3>& normals;  ///< unit vectors of the upper surface
    const Flanks& flanks;
};

/// The light on the upper surface of a tooth: openness to the sky, shadows of the operating light, cut ground and
/// crevices. Ui thread.
class SurfaceLight
{
public:
    /// Red: openness to the sky. Green: share of the operating light that arrives. Blue: cut since the tooth was whole.
    /// Alpha: above one half in a crevice, below on a ridge. 255 is one.
    using Light = std::array<std::uint8_t, 4>;

    /// Length to which shadows of the operating light are followed, mm. A 3 mm cusp under a light at 55 degrees
    /// elevation casts a shadow of 2.1 mm.
    static constexpr float kShadowReachMm = 2.4F;

    /// @param towardsLight  unit vector to the operating light, tooth frame, z > 0
    SurfaceLight(const core::terrain::Grid& lattice, glm::vec3 towardsLight);

    /// Moves the operating light. Values that shine() has already computed do not change.
    void setDirection(glm::vec3 towardsLight);
    [[nodiscard]] glm::vec3 direction() const { return m_towardsLight; }

    /// Computes the light of all nodes in a rectangle. Returns the rectangle of the nodes whose light has changed.
    core::terrain::NodeRect shine(const LitMaps& maps, const core::terrain::NodeRect& rect);

    /// Returns the light of every node of the lattice, row by row.
    [[nodiscard]] const std::vector<Light>& nodes() const { return m_light; }

private:
    static constexpr std::size_t kSkyDirections = 8;
    static constexpr std::size_t kSkySamples = 7;
    /// A node at which the horizon is sampled.
    struct Sample
    {
        int di;
        int dj;
        float distanceMm;
    };
    struct Sky
    {
        float open;     ///< 0 .. 1
        float crevice;  ///< above 0 in a fissure, below 0 on a ridge
    };

    [[nodiscard]] glm::vec4 lightAt(const LitMaps& maps, int i, int j) const;
    [[nodiscard]] Sky skyAt(const LitMaps& maps, int i, int j, glm::vec2 slope) const;
    [[nodiscard]] float climb(const LitMaps& maps, const std::vector<float>& tops, glm::ivec2 node, float here,
                              const Sample& sample) const;
    [[nodiscard]] float litAt(const LitMaps& maps, int i, int j, glm::vec2 slope) const;
    [[nodiscard]] glm::vec4 meanAround(const LitMaps& maps, int i, int j) const;
    [[nodiscard]] bool isSolid(const LitMaps& maps, int i, int j) const;

    core::terrain::Grid m_lattice;
    glm::vec3 m_towardsLight;
    std::array<std::array<Sample, kSkySamples>, kSkyDirections> m_sky{};
    std::array<glm::vec2, kSkyDirections> m_directions{};
    std::vector<float> m_lightPath;  ///< distances at which the path of the light is sampled, mm
    std::vector<glm::vec4> m_raw;
    std::vector<Light> m_light;
};

}  // namespace ui::render
