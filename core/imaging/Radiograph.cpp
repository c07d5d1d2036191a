// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/imaging/Radiograph.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "core/base/Rng.h"

namespace core::imaging {
namespace {

using terrain::Grid;
using terrain::Tooth;
using terrain::ToothAnatomy;

/// Optical density of a developed film that was not exposed, and of a fully black one.
constexpr double kFog = 0.2;
constexpr double kBlackest = 3.0;
/// Below this value, a direction counts as perpendicular to an axis.
constexpr double kSquare = 1.0e-12;

/// The beam and the film in the common frame. A point is u * across + v * up + q * along, where q is measured along the
/// ray.
struct Film
{
    glm::dvec2 along;   ///< horizontal direction of the beam
    glm::dvec2 across;  ///< direction of u, to the right when looking along the beam
    double cosTilt;
    double sinTilt;

    explicit Film(const Beam& beam)
        : along(std::cos(beam.angleRad), std::sin(beam.angleRad)), across(along.y, -along.x),
          cosTilt(std::cos(beam.tiltRad)), sinTilt(std::sin(beam.tiltRad))
    {}
    /// Returns v of the point at height z that is `s` along the horizontal direction of the beam.
    [[nodiscard]] double v(double s, double z) const { return z * cosTilt - s * sinTilt; }
};

/// Returns the position of a point on the film turned by the roll, from its position on a film without roll.
glm::dvec2 rolled(glm::dvec2 point, double rollRad)
{
    const double cosine = std::cos(rollRad);
    const double sine = std::sin(rollRad);
    return {cosine * point.x + sine * point.y, cosine * point.y - sine * point.x};
}

/// Returns the attenuation at a point between pixels; 0 outside the film.
float attenuationAt(const Shadow& shadow, glm::dvec2 point)
{
    const double column = (point.x - shadow.area.lowMm.x) / shadow.pixelMm - 0.5;
    const double row = (shadow.area.highMm.y - point.y) / shadow.pixelMm - 0.5;
    const int c0 = static_cast<int>(std::floor(column));
    const int r0 = static_cast<int>(std::floor(row));
    double sum = 0.0;
    for (int r = r0; r <= r0 + 1; ++r)
        for (int c = c0; c <= c0 + 1; ++c)
            if (r >= 0 && c >= 0 && r < shadow.height && c < shadow.width)
                sum += (1.0 - std::abs(column - c)) * (1.0 - std::abs(row - r)) * static_cast<double>(shadow.at(c, r));
    return static_cast<float>(sum);
}

/// Returns an empty film of this area, with pixels of this size.
Shadow emptyShadow(const FilmArea& area, double pixelMm)
{
    Shadow shadow;
    shadow.pixelMm = pixelMm;
    shadow.width = std::max(1, static_cast<int>(std::ceil((area.highMm.x - area.lowMm.x) / pixelMm)));
    shadow.height = std::max(1, static_cast<int>(std::ceil((area.highMm.y - area.lowMm.y) / pixelMm)));
    shadow.area = {{area.lowMm.x, area.highMm.y - shadow.height * pixelMm},
                   {area.lowMm.x + shadow.width * pixelMm, area.highMm.y}};
    shadow.attenuation.assign(static_cast<std::size_t>(shadow.width) * static_cast<std::size_t>(shadow.height), 0.0F);
    return shadow;
}

/// Limits [from, to] to the part in which base + q * slope is between `lowest` and `highest`.
void clip(double base, double slope, double lowest, double highest, double& from, double& to)
{
    if (std::abs(slope) < kSquare) {
        if (base < lowest || base >= highest)
            to = from;
        return;
    }
    const double a = (lowest - base) / slope;
    const double b = (highest - base) / slope;
    from = std::max(from, std::min(a, b));
    to = std::min(to, std::max(a, b));
}

/// The rays of one column of pixels. They are in one vertical plane, so they cross the same columns of a tooth.
class PixelColumn
{
public:
    PixelColumn(const Film& film, const FilmArea& area, double pixelMm, int height)
        : m_film(film), m_highMm(area.highMm.y), m_pixelMm(pixelMm), m_sum(static_cast<std::size_t>(height), 0.0)
    {}

    void clear() { std::fill(m_sum.begin(), m_sum.end(), 0.0); }
    [[nodiscard]] const std::vector<double>& sum() const { return m_sum; }

    /// Adds the attenuation of the rectangle [s0, s1] x [low, high] of the plane to each ray.
    void add(double s0, double s1, double low, double high, double perMm)
    {
        const double corners[] = {m_film.v(s0, low), m_film.v(s1, low), m_film.v(s0, high), m_film.v(s1, high)};
        const auto [least, most] = std::minmax_element(std::begin(corners), std::end(corners));
        const int count = static_cast<int>(m_sum.size());
        const double firstRow = std::floor((m_highMm - *most) / m_pixelMm - 0.5);
        const double lastRow = std::ceil((m_highMm - *least) / m_pixelMm - 0.5);
        const int first = firstRow > 0.0 ? static_cast<int>(std::min<double>(firstRow, count)) : 0;
        const int last = lastRow < count - 1.0 ? static_cast<int>(std::max(lastRow, -1.0)) : count - 1;
        for (int row = first; row <= last; ++row) {
            const double v = m_highMm - (row + 0.5) * m_pixelMm;
            double from = -std::numeric_limits<double>::max();
            double to = std::numeric_limits<double>::max();
            clip(-v * m_film.sinTilt, m_film.cosTilt, s0, s1, from, to);
            clip(v * m_film.cosTilt, m_film.sinTilt, low, high, from, to);
            if (to > from)
                m_sum[static_cast<std::size_t>(row)] += perMm * (to - from);
        }
    }

private:
    const Film& m_film;
    double m_highMm;
    double m_pixelMm;
    std::vector<double> m_sum;
};

/// Calls visit(node, s0, s1) for the cells that the horizontal line start + s * direction crosses, in order.
void walkCells(const Grid& grid, glm::dvec2 start, glm::dvec2 direction, const auto& visit)
{
    // Positions are in cells, so that cell (i, j) is [i, i + 1] x [j, j + 1].
    const glm::dvec2 origin = grid.latticeOf(start) + 0.5;
    const glm::dvec2 step = direction / grid.cellMm;
    double s = -std::numeric_limits<double>::max();
    double end = std::numeric_limits<double>::max();
    clip(origin.x, step.x, 0.0, grid.side, s, end);
    clip(origin.y, step.y, 0.0, grid.side, s, end);
    const auto next = [&](double base, double slope, int cell) {
        return std::abs(slope) < kSquare ? std::numeric_limits<double>::max()
                                         : (cell + (slope > 0.0 ? 1 : 0) - base) / slope;
    };
    if (!(end > s))
        return;
    const auto cellAt = [&](double base, double slope) {
        const double place = base + slope * s;
        // On the border between two cells, the next one is entered.
        const double cell = slope < 0.0 ? std::ceil(place - 1.0e-9) - 1.0 : std::floor(place + 1.0e-9);
        return static_cast<int>(std::clamp(cell, 0.0, grid.side - 1.0));
    };
    int i = cellAt(origin.x, step.x);
    int j = cellAt(origin.y, step.y);
    while (grid.contains(i, j)) {
        const double nextI = next(origin.x, step.x, i);
        const double nextJ = next(origin.y, step.y, j);
        const double leave = std::min({nextI, nextJ, end});
        if (leave > s)
            visit(grid.index(i, j), s, leave);
        if (leave >= end)
            return;
        if (nextI <= nextJ)
            i += step.x > 0.0 ? 1 : -1;
        else
            j += step.y > 0.0 ? 1 : -1;
        s = std::max(s, leave);
    }
}

void addTooth(const XrayedTooth& xrayed, const Film& film, double u, const terrain::PerMaterial& perMm,
              PixelColumn& column)
{
    const Tooth& tooth = *xrayed.tooth;
    const ToothAnatomy& anatomy = *tooth.anatomy;
    const Grid& grid = anatomy.grid;
    glm::dvec2 start = u * film.across - glm::dvec2(xrayed.placeMm);
    glm::dvec2 direction = film.along;
    if (xrayed.mirrored) {
        start.x = -start.x;
        direction.x = -direction.x;
    }
    const double cellMm2 = grid.cellMm * grid.cellMm;
    walkCells(grid, start, direction, [&](std::size_t k, double s0, double s1) {
        if (!tooth.isSolid(k))
            return;
        const double share = static_cast<double>(anatomy.areaMm2[k]) / cellMm2;
        for (const terrain::MaterialSpan& span :
             terrain::spansBetween(anatomy.layers[k], tooth.bottom[k], tooth.top[k])) {
            const double weakens = share * perMm.at(static_cast<std::size_t>(span.material));
            if (weakens > 0.0)
                column.add(s0, s1, xrayed.placeMm.z + static_cast<double>(span.lowMm),
                           xrayed.placeMm.z + static_cast<double>(span.highMm), weakens);
        }
    });
}

/// Casts the shadow without the roll, over the whole area of the turned film, then turns it.
Shadow turnedShadow(std::span<const XrayedTooth> teeth, const Beam& beam, const FilmArea& area, double pixelMm,
                    const terrain::PerMaterial& perMm)
{
    Shadow shadow = emptyShadow(area, pixelMm);
    FilmArea covered{glm::dvec2(std::numeric_limits<double>::max()), glm::dvec2(-std::numeric_limits<double>::max())};
    for (const double x : {shadow.area.lowMm.x, shadow.area.highMm.x})
        for (const double y : {shadow.area.lowMm.y, shadow.area.highMm.y}) {
            const glm::dvec2 corner = rolled({x, y}, -beam.rollRad);
            covered = {glm::min(covered.lowMm, corner), glm::max(covered.highMm, corner)};
        }
    const Shadow cast = castShadow(teeth, {beam.angleRad, beam.tiltRad, 0.0}, covered, pixelMm, perMm);
    for (int row = 0; row < shadow.height; ++row)
        for (int column = 0; column < shadow.width; ++column) {
            const glm::dvec2 point(shadow.area.lowMm.x + (column + 0.5) * pixelMm,
                                   shadow.area.highMm.y - (row + 0.5) * pixelMm);
            shadow.attenuation[static_cast<std::size_t>(row) * static_cast<std::size_t>(shadow.width) +
                               static_cast<std::size_t>(column)] = attenuationAt(cast, rolled(point, -beam.rollRad));
        }
    return shadow;
}

}  // namespace

Beam laidBeam(const terrain::Lying& lying, const Beam& own)
{
    if (lying.isUpright())
        return own;
    constexpr double kUpright = 1.0e-9;
    const Film film(own);
    const glm::dmat3 turn = lying.cutFromOwn();
    const glm::dvec3 way = turn * glm::dvec3(film.along * film.cosTilt, film.sinTilt);
    const glm::dvec3 toTheRight = turn * glm::dvec3(film.across, 0.0);
    Beam beam;
    const bool isVertical = std::hypot(way.x, way.y) < kUpright;
    beam.angleRad = isVertical ? 0.0 : std::atan2(way.y, way.x);
    beam.tiltRad = std::asin(std::clamp(way.z, -1.0, 1.0));
    const Film level(beam);
    const glm::dvec3 u(level.across, 0.0);
    const glm::dvec3 v(-level.along * level.sinTilt, level.cosTilt);
    beam.rollRad = std::atan2(glm::dot(toTheRight, v), glm::dot(toTheRight, u));
    return beam;
}

FilmArea shadowArea(std::span<const XrayedTooth> teeth, const Beam& beam, double marginMm)
{
    const Film film(beam);
    FilmArea area{glm::dvec2(std::numeric_limits<double>::max()), glm::dvec2(-std::numeric_limits<double>::max())};
    for (const XrayedTooth& xrayed : teeth) {
        const ToothAnatomy& anatomy = *xrayed.tooth->anatomy;
        for (int j = 0; j < anatomy.grid.side; ++j) {
            for (int i = 0; i < anatomy.grid.side; ++i) {
                const std::size_t k = anatomy.grid.index(i, j);
                if (!(anatomy.top[k] > anatomy.bottom[k]))
                    continue;
                glm::dvec2 at = anatomy.grid.nodeMm(i, j);
                if (xrayed.mirrored)
                    at.x = -at.x;
                at += glm::dvec2(xrayed.placeMm);
                const double u = at.x * film.across.x + at.y * film.across.y;
                const double s = at.x * film.along.x + at.y * film.along.y;
                for (const float z : {anatomy.bottom[k], anatomy.top[k]}) {
                    const glm::dvec2 here =
                        rolled({u, film.v(s, xrayed.placeMm.z + static_cast<double>(z))}, beam.rollRad);
                    area.lowMm = {std::min(area.lowMm.x, here.x), std::min(area.lowMm.y, here.y)};
                    area.highMm = {std::max(area.highMm.x, here.x), std::max(area.highMm.y, here.y)};
                }
            }
        }
    }
    if (area.lowMm.x > area.highMm.x)
        area = {};
    area.lowMm -= marginMm;
    area.highMm += marginMm;
    return area;
}

Shadow castShadow(std::span<const XrayedTooth> teeth, const Beam& beam, const FilmArea& area, double pixelMm,
                  const terrain::PerMaterial& perMm)
{
    if (beam.rollRad != 0.0)
        return turnedShadow(teeth, beam, area, pixelMm, perMm);
    const Film film(beam);
    Shadow shadow = emptyShadow(area, pixelMm);
    const auto width = static_cast<std::size_t>(shadow.width);
    PixelColumn column(film, shadow.area, pixelMm, shadow.height);
    for (std::size_t c = 0; c < width; ++c) {
        column.clear();
        for (const XrayedTooth& tooth : teeth)
            addTooth(tooth, film, area.lowMm.x + (static_cast<double>(c) + 0.5) * pixelMm, perMm, column);
        for (std::size_t row = 0; row < column.sum().size(); ++row)
            shadow.attenuation[row * width + c] = static_cast<float>(column.sum()[row]);
    }
    return shadow;
}

double usualExposure(const terrain::ToothAnatomy& anatomy, const Beam& beam)
{
    constexpr double kPixelMm = 0.25;
    constexpr float kTooth = 0.05F;      // a weaker shadow counts as the rim of the tooth
    constexpr double kCrownShare = 0.9;  // of the rays through the tooth: the crown is where it weakens most
    constexpr double kMolar = 1.95;      // attenuation of that ray through a molar
    // A pointer without ownership: the tooth exists only during this call.
    const Tooth tooth(std::shared_ptr<const ToothAnatomy>(std::shared_ptr<const ToothAnatomy>(), &anatomy));
    const XrayedTooth one{&tooth};
    Shadow shadow = castShadow(std::span(&one, 1), beam, shadowArea(std::span(&one, 1), beam, 0.0), kPixelMm);
    std::erase_if(shadow.attenuation, [](float attenuation) { return attenuation < kTooth; });
    if (shadow.attenuation.empty())
        return 1.0;
    const auto crown = shadow.attenuation.begin() +
                       static_cast<std::ptrdiff_t>(kCrownShare * static_cast<double>(shadow.attenuation.size() - 1));
    std::nth_element(shadow.attenuation.begin(), crown, shadow.attenuation.end());
    return std::exp(static_cast<double>(*crown) - kMolar);
}

std::vector<float> quantaOn(const Shadow& shadow, const Exposure& exposure)
{
    const double unweakened = kQuantaPerMm2 * exposure.relative * shadow.pixelMm * shadow.pixelMm;
    std::vector<float> quanta(shadow.attenuation.size());
    Rng rng(exposure.noiseSeed.value_or(0));
    for (std::size_t k = 0; k < quanta.size(); ++k) {
        double caught = unweakened * std::exp(-static_cast<double>(shadow.attenuation[k]));
        if (exposure.noiseSeed)
            caught = std::max(0.0, caught + std::sqrt(caught) * rng.normal());
        quanta[k] = static_cast<float>(caught);
    }
    return quanta;
}

double opticalDensity(double quanta, double pixelMm)
{
    const double hits = kHitsAtExposure1 * quanta / (kQuantaPerMm2 * pixelMm * pixelMm);
    return kFog + (kBlackest - kFog) * (1.0 - std::exp(-hits));
}

}  // namespace core::imaging
