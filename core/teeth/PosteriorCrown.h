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
        double z = 0.0;        ///< surface, fissures carved
        double fissure = 0.0;  ///< depth of the fissure that runs nearby
        double lipMm = 0.0;    ///< half the width of its mouth
        double carved = 0.0;   ///< how much of that the fissures took
        double grooveDistanceMm = 1.0e3;
        double bank = 1.0;  ///< which bank of the groove: 1 or -1
        glm::dvec2 awayFromGroove{0.0};
    };

    PosteriorCrown(PosteriorDesign design, std::vector<OcclusalField::Wave> wander, double beadPhase);

    /// Radius of the height of contour at an angle (radians, distal over buccal), mm.
    [[nodiscard]] double outlineMm(double angle) const;

    /// Height of the surface above a point inside the outline.
    [[nodiscard]] Top top(glm::dvec2 point) const;

    /// Raises or lowers the lobe of each cusp until its tip on the finished crown is as high as the design says: where
    /// the sides round a cusp off, its tip is lower than that of its lobe.
    void settleTips();

    /// Builds the crown down to the CEJ and returns the ring there.
    ///
    /// @param sizes  the CEJ lies sizes.crownHeightMm below the buccal tip
    [[nodiscard]] MeshBuilder::Ring build(MeshBuilder& builder, const ToothSizes& sizes,
                                          const MeshDetail& detail) const;

    [[nodiscard]] const PosteriorDesign& design() const { return m_design; }
    [[nodiscard]] const OcclusalField& field() const { return m_field; }

private:
    /// Turns each side groove into line with the fissure that it continues.
    void alignSideGrooves();
    /// The highest point of the surface near a place, design frame.
    [[nodiscard]] double tipNear(glm::dvec2 place) const;
    /// Points of the CEJ line, from distal over buccal.
    [[nodiscard]] std::vector<glm::dvec3> cej(std::size_t count, double facialZ, const ToothSizes& sizes) const;

    PosteriorDesign m_design;
    OcclusalField m_field;
    double m_beadPhase;
    FourSides m_contour{};
    FourSides m_rise{};
    FourSides m_power{};
};

}  // namespace core::teeth
