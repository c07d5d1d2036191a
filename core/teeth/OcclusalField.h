// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

namespace core::teeth {

/// The cusp that a lobe forms: buccal or lingual on a premolar, the others on a molar. None: a ridge.
enum class Cusp : std::uint8_t { None, B, L, MB, ML, DB, DL, D };

/// A developmental lobe: a four-ridged pyramid with a rounded tip. Cusps, marginal ridges and oblique ridges are all
/// lobes; the occlusal surface is the highest lobe everywhere, as a dental technician builds a crown from drops of wax,
/// and the developmental grooves are where two lobes meet.
///
/// Design frame of all posterior teeth: mm, x from mesial to distal, y towards the cheek, z occlusal.
struct Lobe
{
    double x = 0.0;
    double y = 0.0;
    double z = 0.0;            ///< height of the tip; for a cusp, on the finished crown
    double turnDeg = 0.0;      ///< rotation of the ridges about the tip, from x towards y
    double slopeMesial = 0.5;  ///< fall along each of the four ridges, mm per mm
    double slopeDistal = 0.5;
    double slopeBuccal = 0.5;
    double slopeLingual = 0.5;
    double power = 1.5;   ///< 1 a pyramid with four sharp ridges, 2 a cone
    double groove = 1.0;  ///< share of the fissure depth for its grooves
    int group = 0;        ///< lobes of one group join without a fissure
    Cusp cusp = Cusp::None;
};

/// The occlusal surface of a posterior tooth as a height over the design plane, before the sides round it off.
class OcclusalField
{
public:
    /// One long wave of the displacement: a shift along a fixed direction.
    struct Wave
    {
        glm::dvec2 perMm{0.0};  ///< phase per mm, radians
        double phase = 0.0;
        glm::dvec2 shiftMm{0.0};
    };

    struct Sample
    {
        double height = 0.0;              ///< of the lobes, smoothly joined
        double grooveDistanceMm = 1.0e3;  ///< to the nearest line where two lobes of different groups meet
        glm::dvec2 awayFromGroove{0.0};   ///< unit direction in which that distance grows
        double bank = 1.0;                ///< 1 on one bank of that line, -1 on the other
        double groove = 0.0;              ///< share of the fissure depth there, 0 where lobes join
    };

    /// @param blendMm  height over which lobes join smoothly
    /// @param furrows  relative variation of a lobe's slope around its tip: supplemental ridges and furrows
    OcclusalField(const std::vector<Lobe>& lobes, double blendMm, double furrows, std::vector<Wave> wander);

    void setLobes(const std::vector<Lobe>& lobes);
    [[nodiscard]] Sample at(glm::dvec2 point) const;
    /// Returns the height of one lobe alone, by its index in the design's list.
    [[nodiscard]] double lobeHeight(std::size_t lobe, glm::dvec2 point) const;

private:
    struct Prepared
    {
        Lobe lobe;
        double cosine = 1.0;
        double sine = 0.0;
        glm::dvec2 furrows{0.0};  ///< share, at its phase
    };
    struct Value;
    [[nodiscard]] glm::dvec2 wandered(glm::dvec2 point) const;
    [[nodiscard]] static Value valueOf(const Prepared& prepared, glm::dvec2 moved);
    std::vector<Prepared> m_lobes;
    std::vector<Wave> m_wander;
    double m_blendMm;
    double m_furrows;
};

}  // namespace core::teeth
