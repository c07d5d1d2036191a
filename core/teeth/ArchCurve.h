// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <glm/vec2.hpp>

namespace core::teeth {

/// Upper or lower teeth.
enum class Jaw { Upper, Lower };

/// A place beside a dental arch: the distance along it from the midline, and towards lip or cheek, mm.
struct ArchPlace
{
    double alongMm = 0.0;
    double outwardMm = 0.0;
};

/// The left half of the curve through incisal edges, canine tips and buccal cusps, seen along the axis of the teeth: x
/// towards the patient's left, y backwards, origin between the central incisors; mm.
///
/// y = a x^2 + b x^4 (an even polynomial describes an arch better than a parabola or a catenary: Pepe 1975), through
/// the canine's tip and the mesiobuccal cusp of the first molar at their mean distances from the midline in adults.
class ArchCurve
{
public:
    explicit ArchCurve(Jaw jaw);

    /// Distance of canine tips and of mesiobuccal cusps of the first molars across the jaw, mm: means of adults as
    /// textbooks give them after Moorrees 1959, standard deviation about 2.
    [[nodiscard]] static double intercanineMm(Jaw jaw) { return jaw == Jaw::Upper ? 34.5 : 26.0; }
    [[nodiscard]] static double intermolarMm(Jaw jaw) { return jaw == Jaw::Upper ? 51.5 : 45.5; }

    [[nodiscard]] glm::dvec2 point(double alongMm) const;
    /// Returns the unit vector along the curve, away from the midline.
    [[nodiscard]] glm::dvec2 tangent(double alongMm) const;
    /// Returns the unit vector towards lip or cheek.
    [[nodiscard]] glm::dvec2 outward(double alongMm) const;
    /// Returns the nearest place; beyond its ends the curve continues straight.
    [[nodiscard]] ArchPlace placeOf(glm::dvec2 point) const;

private:
    std::vector<glm::dvec2> m_points;  ///< every kStepMm
};

}  // namespace core::teeth
