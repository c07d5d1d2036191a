// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/teeth/LesionSite.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/base/NumberField.h"
#include "core/base/Rng.h"
#include "core/teeth/Caries.h"
#include "core/teeth/LaidSolid.h"
#include "core/teeth/Lattice.h"

namespace core::teeth {
namespace {

using terrain::Lying;
using terrain::ToothSide;

// Lengths in mm of the tooth's own frame.
constexpr double kAboveNeckMm = 1.2;
constexpr double kUnderContactMm = 0.75;
constexpr double kHalfHeightMm = 0.9;
constexpr double kCervicalHalfWidthMm = 1.6;
constexpr double kContactHalfWidthMm = 1.3;
constexpr double kWanderMm = 0.4;
// The part of the crown's height with pits, and their distance from its middle as a share of half its width.
constexpr double kPitFrom = 0.2;
constexpr double kPitTo = 0.75;
constexpr double kPitAside = 0.4;
constexpr double kPitHalfMouthMm = 0.7;
constexpr float kLeastPitMm = 0.04F;
constexpr float kGrooveEnd = 0.5F;   ///< share of its greatest depth at which a groove ends
constexpr double kGroovePit = 0.55;  ///< greatest height of the pit of a posterior tooth, share of the crown
constexpr float kLeastEnamelMm = 0.25F;
constexpr float kLeastDentinMm = 1.5F;

bool showsMesialOrDistal(const Lying& lying)
{
    return lying.up == ToothSide::MinusX || lying.up == ToothSide::PlusX;
}

/// Searches the surface of a laid tooth.
class SurfaceSearch
{
public:
    SurfaceSearch(const LaidTooth& laid, const terrain::Grid& grid, std::span<const float> top,
                  std::span<const float> bottom)
        : m_laid(laid), m_grid(grid), m_top(top), m_bottom(bottom)
    {}

    /// Returns the node of the surface whose point, in the own frame, has the smallest `cost`.
    template <class Cost>
    [[nodiscard]] std::size_t best(const Cost& cost) const
    {
        std::size_t found = 0;
        double least = std::numeric_limits<double>::max();
        for (std::size_t k = 0; k < m_grid.count(); ++k) {
            if (!(m_top[k] > m_bottom[k]))
                continue;
            if (const double here = cost(ownMm(k)); here < least) {
                found = k;
                least = here;
            }
        }
        return found;
    }

    [[nodiscard]] glm::dvec3 ownMm(std::size_t k) const { return m_laid.ownMm({m_grid.nodeMm(k), m_top[k]}); }

    /// Returns the deepest pit in the middle of the crown with enamel and dentin below it; its depth is measured from
    /// the surface closed by a disc. In a posterior tooth, it is the place about halfway down the crown in line with
    /// the deepest groove.
    [[nodiscard]] std::optional<std::size_t> deepestPit(const std::vector<terrain::ColumnLayers>& layers) const
    {
        const Lattice lattice(m_grid);
        const std::vector<float> lowest = lattice.pickLowest(m_top, terrain::kEmptyTop);
        const std::vector<float> closed = lattice.close(lowest, kPitHalfMouthMm, terrain::kEmptyTop);
        struct Place
        {
            std::size_t node;
            float depthMm;
            double heightMm;  ///< own z
        };
        std::vector<Place> places;
        float deepest = kLeastPitMm;
        for (int b = 0; b * lattice.stride() < m_grid.side; ++b)
            for (int a = 0; a * lattice.stride() < m_grid.side; ++a) {
                const std::size_t k = m_grid.index(a * lattice.stride(), b * lattice.stride());
                if (!mayHoldPit(k, layers[k]))
                    continue;
                places.push_back({k, closed[lattice.index(a, b)] - lowest[lattice.index(a, b)], ownMm(k).z});
                deepest = std::max(deepest, places.back().depthMm);
            }
        const bool isPosterior = m_laid.own.fdi % 10 > 3;
        const float least = isPosterior ? kGrooveEnd * deepest : deepest;
        std::optional<Place> found;
        for (const Place& place : places)
            if (place.depthMm >= least && place.depthMm > kLeastPitMm && (!found || place.heightMm < found->heightMm))
                found = place;
        if (!found)
            return {};
        return isPosterior ? pitBelowGroove(found->node, layers) : found->node;
    }

private:
    [[nodiscard]] std::size_t pitBelowGroove(std::size_t grooveEnd,
                                             const std::vector<terrain::ColumnLayers>& layers) const
    {
        const glm::dvec3 end = ownMm(grooveEnd);
        const double height = m_laid.neckMm() + kGroovePit * m_laid.crownHeightMm;
        if (end.z <= height)
            return grooveEnd;
        const std::size_t pit = best(
            [&](const glm::dvec3& own) { return glm::distance(glm::dvec2(own.x, own.z), glm::dvec2(end.x, height)); });
        return mayHoldPit(pit, layers[pit]) ? pit : grooveEnd;
    }

    [[nodiscard]] bool mayHoldPit(std::size_t k, const terrain::ColumnLayers& column) const
    {
        if (!(m_top[k] > m_bottom[k]) || m_top[k] - std::max(column.dej, m_bottom[k]) < kLeastEnamelMm ||
            column.dej < m_bottom[k] + kLeastDentinMm)
            return false;
        const terrain::Grid& ownGrid = m_laid.own.grid;
        const glm::dvec3 own = ownMm(k);
        const double height = (own.z - m_laid.neckMm()) / m_laid.crownHeightMm;
        return height >= kPitFrom && height <= kPitTo &&
               std::abs(own.x - ownGrid.middleMm().x) < kPitAside * 0.5 * ownGrid.cellMm * ownGrid.side;
    }

    const LaidTooth& m_laid;
    const terrain::Grid& m_grid;
    std::span<const float> m_top;
    std::span<const float> m_bottom;
};

/// Adds the fissure decay of the upright tooth to the columns of the laid one.
void addFissureLesion(double extent, const LaidTooth& laid, const terrain::Grid& grid, std::span<const float> top,
                      std::span<const float> bottom, std::vector<terrain::ColumnLayers>& layers)
{
    LaidTooth decayed = laid;
    terrain::ToothAnatomy& own = decayed.own;
    addCaries(own.grid, own.top, own.bottom, own.layers, {CariesRule::FissureWalk, extent, own.seed, {}, {}});
    const LaidSolid lesion(decayed, &terrain::ColumnLayers::cariesRoof, &terrain::ColumnLayers::cariesFloor);
    for (std::size_t k = 0; k < grid.count(); ++k) {
        if (!(top[k] > bottom[k]))
            continue;
        if (const auto met = lesion.along(grid.nodeMm(k), top[k], bottom[k])) {
            layers[k].cariesRoof = met->first;
            layers[k].cariesFloor = met->second;
        }
    }
}

SurfaceLesion ellipseAt(glm::dvec2 atMm, double halfWidthMm, const Lying& lying)
{
    // Along the bur, heights of a side wall appear shorter, the more so the less the tooth is tilted.
    const double half = kHalfHeightMm * std::sin(glm::radians(lying.tiltDeg));
    return {atMm, showsMesialOrDistal(lying) ? glm::dvec2(half, halfWidthMm) : glm::dvec2(halfWidthMm, half)};
}

}  // namespace

LesionSite usualSite(const Lying& lying)
{
    if (lying.tiltDeg <= kSideTiltDeg)
        return LesionSite::Fissure;
    return showsMesialOrDistal(lying) ? LesionSite::Contact : LesionSite::Cervical;
}

Status checkSite(LesionSite site, const Lying& lying)
{
    if (site == LesionSite::Fissure && lying.tiltDeg > kSideTiltDeg)
        return unexpected(ErrorCode::OutOfRange,
                          LocalizableText{"a bur reaches no fissure of a tooth that is tilted by more than %1 degrees",
                                          {noted(plainNumber(kSideTiltDeg))}});
    if (site == LesionSite::Contact && !showsMesialOrDistal(lying))
        return unexpected(
            ErrorCode::OutOfRange,
            LocalizableText{"decay below a contact is on the mesial or distal side; let the tooth lie that way"});
    if ((site == LesionSite::Cervical || site == LesionSite::Pit) && (lying.isUpright() || showsMesialOrDistal(lying)))
        return unexpected(ErrorCode::OutOfRange,
                          LocalizableText{"decay at the neck or in a pit of a side is on the buccal or "
                                          "lingual side; let the tooth lie that way"});
    return {};
}

Status addLesion(LesionSite site, double extent, const LaidTooth& laid, const terrain::Grid& grid,
                 std::span<const float> top, std::span<const float> bottom, std::vector<terrain::ColumnLayers>& layers)
{
    const Lying& lying = laid.own.lying;
    if (Status fits = checkSite(site, lying); !fits)
        return fits;
    if (site == LesionSite::Fissure) {
        addFissureLesion(extent, laid, grid, top, bottom, layers);
        return {};
    }
    CariesOptions options{CariesRule::FissureWalk, extent, laid.own.seed, {}, {}};
    const SurfaceSearch search(laid, grid, top, bottom);
    if (site == LesionSite::Pit) {
        const auto pit = search.deepestPit(layers);
        if (!pit)
            return unexpected(
                ErrorCode::BadStructure,
                LocalizableText{"there is no pit on the side that tooth '%1' shows", {noted(laid.own.name)}});
        const double room = static_cast<double>(layers[*pit].dej) - static_cast<double>(bottom[*pit]);
        const LesionStop stop{grid.nodeMm(*pit), 0.0, std::max(0.0, room)};
        options.line = std::span(&stop, 1);
        addCaries(grid, top, bottom, layers, options);
        return {};
    }
    Rng rng(laid.own.seed ^ 0x73697465ULL);
    const double wander = laid.own.seed == 0 ? 0.0 : kWanderMm;
    const double aside = rng.uniform(-wander, wander);
    const double higher = 0.5 * rng.uniform(-wander, wander);
    if (site == LesionSite::Cervical) {
        const glm::dvec2 place(laid.own.grid.middleMm().x + aside, laid.neckMm() + kAboveNeckMm + higher);
        const std::size_t found =
            search.best([&](const glm::dvec3& own) { return glm::distance(glm::dvec2(own.x, own.z), place); });
        options.surface = ellipseAt(grid.nodeMm(found), kCervicalHalfWidthMm, lying);
    } else {
        const double outwards = lying.up == ToothSide::PlusX ? 1.0 : -1.0;
        const glm::dvec3 contact = search.ownMm(search.best([&](const glm::dvec3& own) { return -outwards * own.x; }));
        const glm::dvec2 place(contact.y + aside, contact.z + higher - kUnderContactMm);
        const std::size_t found =
            search.best([&](const glm::dvec3& own) { return glm::distance(glm::dvec2(own.y, own.z), place); });
        options.surface = ellipseAt(grid.nodeMm(found), kContactHalfWidthMm, lying);
    }
    addCaries(grid, top, bottom, layers, options);
    return {};
}

}  // namespace core::teeth
