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

/// A film of teeth: how much of a parallel X-ray beam comes through them, and what that leaves on a dental film.
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
    double angleRad = 1.5707963267948966;  ///< horizontal direction it runs in, about +z from +x
    double tiltRad = 0.0;                  ///< how much it rises, -pi/2 .. pi/2; pi/2 runs straight up
    double rollRad = 0.0;                  ///< how far the film is turned about the beam, from its u towards its v
};

/// The beam, and the film turned with it, that takes the same picture of a tooth which lies on a side: mesial, distal
/// and the crown are on the film where they are for an upright tooth.
/// @param own  in the tooth's own frame, without a roll
[[nodiscard]] Beam laidBeam(const terrain::Lying& lying, const Beam& own);

/// One tooth before the film.
struct XrayedTooth
{
    const terrain::Tooth* tooth = nullptr;  ///< borrowed for the call
    glm::dvec3 placeMm{0.0};                ///< of its origin, in the common frame
    bool mirrored = false;                  ///< x and -x change places: a tooth of the other side
};

/// A rectangle of the film: u to the right as one looks along the beam, v up and square to the beam, mm.
struct FilmArea
{
    glm::dvec2 lowMm{0.0};
    glm::dvec2 highMm{0.0};
};

/// What lies between source and film.
struct Shadow
{
    int width = 0;
    int height = 0;
    double pixelMm = 0.0;
    FilmArea area;                   ///< as large as the pixels
    std::vector<float> attenuation;  ///< line integrals at pixel centres, [width * height], uppermost row first
    [[nodiscard]] float at(int column, int row) const
    {
        return attenuation[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                           static_cast<std::size_t>(column)];
    }
};

/// The part of the film on which the whole teeth, uncut, throw their shadow, with a margin around it.
[[nodiscard]] FilmArea shadowArea(std::span<const XrayedTooth> teeth, const Beam& beam, double marginMm);

/// Integrates the attenuation along the ray of every pixel, each ray exactly: the columns it crosses are walked one by
/// one and its length in each stretch of material is clipped. A column is a square prism around its node; one at the
/// rim that stands for more or less than its cell attenuates in proportion, so that the picture holds the volumes of
/// terrain::volumes(). A film with a roll is cast without one and turned afterwards, linear between its pixels. Any
/// thread; about 50 ms for a molar at 150 x 150 and pixels of 0.05 mm.
/// @param perMm  attenuation of each material
[[nodiscard]] Shadow castShadow(std::span<const XrayedTooth> teeth, const Beam& beam, const FilmArea& area,
                                double pixelMm, const terrain::PerMaterial& perMm = kAttenuationPerMm);

/// How much radiation is given.
struct Exposure
{
    double relative = 1.0;                   ///< 1 is right for a molar
    std::optional<std::uint64_t> noiseSeed;  ///< none: a film without grain, which no exposure gives
};

/// Exposure with which the film of this tooth alone, uncut, shows its crown as a film of a molar does at exposure 1: a
/// front tooth is thinner, lets more of the beam through and needs less. About 5 ms; any thread.
[[nodiscard]] double usualExposure(const terrain::ToothAnatomy& anatomy, const Beam& beam);

/// Quanta that are caught from an unweakened beam at exposure 1, to the mm2. Chosen so that the noise shows as on a
/// fast dental film; films differ by several times.
inline constexpr double kQuantaPerMm2 = 4.0e5;

/// Hits of a grain of the film by that many quanta: its speed. With four of them the air beside a molar is all but as
/// black as the film can become, and the crown, which lets about a sixth of the beam through, lies where the curve of
/// opticalDensity() is steep: films are exposed so that it does.
inline constexpr double kHitsAtExposure1 = 4.0;

/// Quanta caught in each pixel: Beer-Lambert, and with a seed its noise, which grows with the square root of their
/// number (a normal distribution stands for Poisson's: pixels catch tens and more). The same seed gives the same film.
[[nodiscard]] std::vector<float> quantaOn(const Shadow& shadow, const Exposure& exposure);

/// Optical density (minus the decimal logarithm of the share of light that passes) of a developed film where a pixel
/// caught these quanta, 0.2 (fog) .. 3. A grain is black once hit, so the density is
/// fog + (most - fog) * (1 - exp(-hits)): straight at first, then saturating.
[[nodiscard]] double opticalDensity(double quanta, double pixelMm);

}  // namespace core::imaging
