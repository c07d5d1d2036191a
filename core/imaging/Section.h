// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/terrain/DecayZones.h"
#include "core/terrain/Tooth.h"

/// Views of the inside of a tooth: a section through it, the depth of a bur, the distance to the pulp. Any thread that
/// owns the tooth.
namespace core::imaging {

/// A vertical plane, seen with `direction()` to the right and +z up.
struct SectionPlane
{
    glm::dvec2 throughMm{0.0, 0.0};  ///< tooth frame
    double angleRad = 0.0;           ///< about +z: 0 is along +x (mesio-distal), a quarter turn along +y

    [[nodiscard]] glm::dvec2 direction() const;
    /// Returns the position of a point along the plane, from the tooth frame's origin: x at angle 0, y at a quarter
    /// turn.
    [[nodiscard]] double alongMm(glm::dvec2 pointMm) const;
    /// Returns the point of the plane at a position along it.
    [[nodiscard]] glm::dvec2 pointMm(double alongMm) const;
};

/// The contents of the plane on one vertical line.
struct SectionSample
{
    bool wasTooth = false;                     ///< there was tooth before cutting; otherwise the other members are
                                               ///< empty
    float originalTopMm = 0.0F;                ///< the original surface
    float idealTopMm = 0.0F;                   ///< the ideal surface; kEmptyTop where no material is to be left
    terrain::MaterialSpans present;            ///< the current materials, from below upwards; none where it was cut
                                               ///< through
    std::optional<terrain::DecayZones> zones;  ///< of the decay, if it has zones
};

/// Samples at equal distances: sample k is at fromMm + k * stepMm along the plane.
struct Section
{
    SectionPlane plane;
    double fromMm = 0.0;
    double stepMm = 0.0;
    std::vector<SectionSample> samples;
};

/// Returns the section of a tooth by a plane from `fromMm` to `toMm` along it, in `count` >= 2 samples. Heights and
/// interfaces are linear between the four nodes around a point; at the rim, and where only some of them have decay or
/// pulp, those of the nearest column. On a node exactly those of its column.
/// @param ideal  heights of the ideal surface, over the tooth's grid; null: the original one
[[nodiscard]] Section sectionOf(const terrain::Tooth& tooth, const SectionPlane& plane, double fromMm, double toMm,
                                int count, const std::vector<float>* ideal = nullptr);

/// The pulp of an uncut tooth: one box per column, as wide as its cell.
class PulpChamber
{
public:
    explicit PulpChamber(const terrain::ToothAnatomy& anatomy);
    [[nodiscard]] bool isEmpty() const { return m_boxes.empty(); }
    /// Returns the point of the pulp nearest to a point, in any direction; empty for a tooth without pulp. Searches all
    /// boxes: 2 ns each, about 5 us in total at 150 x 150.
    [[nodiscard]] std::optional<glm::dvec3> nearest(glm::dvec3 pointMm) const;

private:
    struct Box
    {
        float x, y, low, high;
    };
    std::vector<Box> m_boxes;
    double m_halfCellMm;
};

/// The depth of the tip of a bur and the tissue below it. All values but toPulpMm are those of the column nearest to
/// the tip.
struct DepthReading
{
    bool overTooth = false;                  ///< this column was tooth before cutting
    double depthMm = 0.0;                    ///< below the original surface; negative above it
    std::optional<double> dentinOverPulpMm;  ///< sound dentin between cut and pulp; empty without pulp below
    std::optional<double> downToPulpMm;      ///< from the tip straight down, 0 in the pulp; empty without pulp below
    std::optional<double> toPulpMm;          ///< shortest distance from the head of the bur in any direction, 0 in the
                                             ///< pulp
};

/// Returns the depth of the tip and the distance to the pulp.
/// @param pulp  of this tooth's anatomy
/// @param headRadiusMm  of the bur, whose head is treated as a ball for toPulpMm; 0: only the tip
[[nodiscard]] DepthReading readDepth(const terrain::Tooth& tooth, const PulpChamber& pulp, glm::dvec3 tipMm,
                                     double headRadiusMm = 0.0);

}  // namespace core::imaging
