// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/terrain/DecayZones.h"
#include "core/terrain/Tooth.h"

/// Seeing inside a tooth: a cut through it, how deep a bur stands, how near to the pulp. Any thread that owns the
/// tooth.
namespace core::imaging {

/// A vertical plane. Seen with `direction()` to the right and +z up.
struct SectionPlane
{
    glm::dvec2 throughMm{0.0, 0.0};  ///< tooth frame
    double angleRad = 0.0;           ///< about +z: 0 runs along +x (mesio-distal), a quarter turn along +y

    [[nodiscard]] glm::dvec2 direction() const;
    /// Where a point lies along the plane, measured from the tooth frame's origin: x itself at 0, y at a quarter turn.
    [[nodiscard]] double alongMm(glm::dvec2 pointMm) const;
    /// The point of the plane that lies so far along it.
    [[nodiscard]] glm::dvec2 pointMm(double alongMm) const;
};

/// What the plane meets on one vertical line.
struct SectionSample
{
    bool wasTooth = false;                     ///< there was tooth before anyone cut; else the rest is empty
    float originalTopMm = 0.0F;                ///< the surface as it was
    float idealTopMm = 0.0F;                   ///< and as it ought to become; kEmptyTop where nothing is to be left
    terrain::MaterialSpans present;            ///< what is there now, from below upwards; none where it was cut through
    std::optional<terrain::DecayZones> zones;  ///< of the decay, if it has any
};

/// Samples at equal distances: sample k lies at fromMm + k * stepMm along the plane.
struct Section
{
    SectionPlane plane;
    double fromMm = 0.0;
    double stepMm = 0.0;
    std::vector<SectionSample> samples;
};

/// The cut of a tooth by a plane from `fromMm` to `toMm` along it, in `count` >= 2 samples. Heights and interfaces are
/// linear between the four nodes around a point; at the rim, and where only some of them have decay or pulp, the
/// nearest column speaks. On a node it says exactly what the column says.
/// @param ideal  heights of the surface as it ought to become, over the tooth's grid; null: as it was
[[nodiscard]] Section sectionOf(const terrain::Tooth& tooth, const SectionPlane& plane, double fromMm, double toMm,
                                int count, const std::vector<float>* ideal = nullptr);

/// The pulp of a tooth as it grew, opened or not: one box a column, as wide as its cell.
class PulpChamber
{
public:
    explicit PulpChamber(const terrain::ToothAnatomy& anatomy);
    [[nodiscard]] bool isEmpty() const { return m_boxes.empty(); }
    /// The point of the pulp nearest to a point, in any direction; nothing for a tooth without pulp. Looks at every
    /// box: 2 ns each, about 5 us in all at 150 x 150.
    [[nodiscard]] std::optional<glm::dvec3> nearest(glm::dvec3 pointMm) const;

private:
    struct Box
    {
        float x, y, low, high;
    };
    std::vector<Box> m_boxes;
    double m_halfCellMm;
};

/// How deep the tip of a bur stands and what is left under it. The column nearest to the tip speaks, except for
/// toPulpMm.
struct DepthReading
{
    bool overTooth = false;                  ///< this column was tooth before anyone cut
    double depthMm = 0.0;                    ///< below the original surface; negative above it
    std::optional<double> dentinOverPulpMm;  ///< sound dentin left between cut and pulp; nothing without pulp below
    std::optional<double> downToPulpMm;      ///< from the tip straight down, 0 in the pulp; nothing without pulp below
    std::optional<double> toPulpMm;          ///< shortest way from the head of the bur in any direction, 0 in the pulp
};

/// @param pulp  made for this tooth's anatomy
/// @param headRadiusMm  of the bur, whose head counts as a ball for toPulpMm; 0: the tip alone
[[nodiscard]] DepthReading readDepth(const terrain::Tooth& tooth, const PulpChamber& pulp, glm::dvec3 tipMm,
                                     double headRadiusMm = 0.0);

}  // namespace core::imaging
