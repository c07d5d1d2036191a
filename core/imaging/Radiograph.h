// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/terrain/Lying.h"
#include "core/terrain/Tooth.h"

/// The radiograph of teeth: the transmission of a parallel X-ray beam, and its effect on a dental film.
///
/// Primary beam only. Scatter, the beam's hardening, the blur of the focal spot, bone and gums are not modelled.
namespace core::imaging {

/// Linear attenuation of decay, enamel, dentin and pulp, 1/mm: the values at 40 keV of docs/teeth.md, which
/// agree with film densitometry at 70 kVp (enamel 2.97 +- 0.71, dentin 2.12 +- 0.92 1/cm measured). Decay is taken as
/// half the mineral of sound dentin.
inline constexpr terrain::PerMaterial kAttenuationPerMm{0.10, 0.28, 0.16, 0.028};

/// A parallel beam. At the defaults it runs along +y and the film shows mesial at the left, distal at the right.
struct Beam
{
    double angleRad = 1.5707963267948966;  ///< horizontal direction of the beam, about +z from +x
    double tiltRad = 0.0;                  ///< elevation of the beam, -pi/2 to pi/2; pi/2 points straight up
    double rollRad = 0.0;                  ///< rotation of the film about the beam, from its u towards its v
};

/// Returns the beam and film rotation that give the same picture of a tooth on its side: mesial, distal and the crown
/// are on the film where they are for an upright tooth.
/// @param own  in the tooth's own frame, without a roll
[[nodiscard]] Beam laidBeam(const terrain::Lying& lying, const Beam& own);

/// One tooth in front of the film.
struct XrayedTooth
{
    const terrain::Tooth* tooth = nullptr;  ///< borrowed for the call
    glm::dvec3 placeMm{0.0};                ///< of its origin, in the common frame
    bool mirrored = false;                  ///< x and -x are swapped: a tooth of the other side
};

/// A rectangle of the film: u to the right as seen along the beam, v up and at right angles to the beam, mm.
struct FilmArea
{
    glm::dvec2 lowMm{0.0};
    glm::dvec2 highMm{0.0};
};

/// The integrated attenuation between source and film.
struct Shadow
{
    int width = 0;
    int height = 0;
    double pixelMm = 0.0;
    FilmArea area;                   ///< extent of the pixels
    std::vector<float> attenuation;  ///< line integrals at pixel centres, [width * height], top row first
    [[nodiscard]] float at(int column, int row) const
    {
        return attenuation[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                           static_cast<std::size_t>(column)];
    }
};

/// Returns the part of the film that the whole uncut teeth cover, with a margin around it.
[[nodiscard]] FilmArea shadowArea(std::span<const XrayedTooth> teeth, const Beam& beam, double marginMm);

/// Integrates the attenuation along the ray of every pixel, each ray exactly: visits the columns that it crosses one by
/// one and clips its length in each material. A column is a square prism around its node; one at the rim that
/// represents more or less than its cell attenuates in proportion, so that the picture has the volumes of
/// terrain::volumes(). A film with a roll is computed without one and rotated afterwards, with linear interpolation.
/// Any thread; about 50 ms for a molar at 150 x 150 and pixels of 0.05 mm.
/// @param perMm  attenuation of each material
[[nodiscard]] Shadow castShadow(std::span<const XrayedTooth> teeth, const Beam& beam, const FilmArea& area,
                                double pixelMm, const terrain::PerMaterial& perMm = kAttenuationPerMm);

/// The exposure of a film.
struct Exposure
{
    double relative = 1.0;                   ///< 1 is right for a molar
    std::optional<std::uint64_t> noiseSeed;  ///< empty: a film without grain, which no real exposure gives
};

/// Returns the exposure at which the film of this tooth alone, uncut, shows its crown like that of a molar at exposure
/// 1: a front tooth is thinner, transmits more of the beam and needs less. About 5 ms; any thread.
[[nodiscard]] double usualExposure(const terrain::ToothAnatomy& anatomy, const Beam& beam);

/// Quanta per mm2 absorbed from the unattenuated beam at exposure 1. Chosen so that the noise looks as on a fast dental
/// film; films differ by several times.
inline constexpr double kQuantaPerMm2 = 4.0e5;

/// Hits per grain of the film by that many quanta: its speed. With four of them the air beside a molar is nearly as
/// black as the film can become, and the crown, which transmits about a sixth of the beam, is where the curve of
/// opticalDensity() is steep, as for real films.
inline constexpr double kHitsAtExposure1 = 4.0;

/// Returns the quanta absorbed in each pixel: Beer-Lambert, and with a seed the noise, which grows with the square root
/// of their number (a normal distribution approximates Poisson's: pixels absorb tens and more). The same seed gives the
/// same film.
[[nodiscard]] std::vector<float> quantaOn(const Shadow& shadow, const Exposure& exposure);

/// Returns the optical density (minus the decimal logarithm of the transmitted share of light) of a developed film
/// where a pixel absorbed these quanta, 0.2 (fog) to 3. A grain is black once hit, so the density is fog + (most - fog)
/// * (1 - exp(-hits)): linear at first, then saturating.
[[nodiscard]] double opticalDensity(double quanta, double pixelMm);

}  // namespace core::imaging
