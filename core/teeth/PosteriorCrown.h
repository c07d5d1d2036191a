// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/teeth/MeshBuilder.h"
#include "core/teeth/PosteriorDesign.h"
#include "core/teeth/ToothTable.h"

namespace core::teeth {

/// The crown of a premolar or molar: an occlusal field of lobes inside sides that are lofted from the CEJ over the
/// height of contour to a dome. Design frame.
class PosteriorCrown
{
public:
    struct Top
    {
        double z = 0.0;        ///< surface, with fissures
        double fissure = 0.0;  ///< depth of the nearest fissure
        double lipMm = 0.0;    ///< half the width of its mouth
        double carved = 0.0;   ///< depth that the fissures removed
        double grooveDistanceMm = 1.0e3;
        double bank = 1.0;  ///< side of the groove: 1 or -1
        glm::dvec2 awayFromGroove{0.0};
    };

    PosteriorCrown(PosteriorDesign design, std::vector<OcclusalField::Wave> wander, double beadPhase);

    /// Returns the radius of the height of contour at an angle (radians, from distal to buccal), mm.
    [[nodiscard]] double outlineMm(double angle) const;

    /// Returns the height of the surface above a point inside the outline.
    [[nodiscard]] Top top(glm::dvec2 point) const;

    /// Raises or lowers the lobe of each cusp until its tip on the finished crown has the height of the design: where
    /// the sides round a cusp off, its tip is lower than that of its lobe.
    void settleTips();

    /// Builds the crown down to the CEJ and returns the ring there.
    ///
    /// @param sizes  the CEJ is sizes.crownHeightMm below the buccal tip
    [[nodiscard]] MeshBuilder::Ring build(MeshBuilder& builder, const ToothSizes& sizes,
                                          const MeshDetail& detail) const;

    [[nodiscard]] const PosteriorDesign& design() const { return m_design; }
    [[nodiscard]] const OcclusalField& field() const { return m_field; }

private:
    /// Aligns each side groove with the fissure that it continues.
    void alignSideGrooves();
    /// Returns the highest point of the surface near a place, design frame.
    [[nodiscard]] double tipNear(glm::dvec2 place) const;
    /// Returns points of the CEJ line, from distal to buccal.
    [[nodiscard]] std::vector<glm::dvec3> cej(std::size_t count, double facialZ, const ToothSizes& sizes) const;

    PosteriorDesign m_design;
    OcclusalField m_field;
    double m_beadPhase;
    FourSides m_contour{};
    FourSides m_rise{};
    FourSides m_power{};
};

}  // namespace core::teeth
