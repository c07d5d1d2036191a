// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/preparation/ToothPreparation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "core/preparation/AccessOpening.h"
#include "core/preparation/AxisRegion.h"
#include "core/preparation/OcclusalOutline.h"
#include "core/preparation/OcclusalReduction.h"
#include "core/teeth/ToothBuilder.h"
#include "core/teeth/ToothGenerator.h"

namespace core::preparation {
namespace {

using grading::Part;

constexpr float kFarMm = 1.0e3F;
constexpr double kBesideMm = 1.6;     ///< distances are computed up to this far beyond the region of the bur's axis
constexpr double kLeastCutMm = 0.02;  ///< a shallower floor is no cut

/// Computes the distances over the grid to the region of the axis along one stroke. They are negative inside the
/// region.
void sweep(const terrain::Grid& grid, const std::vector<OcclusalCavity::Spot>& spots, std::vector<float>& distance)
{
    std::fill(distance.begin(), distance.end(), kFarMm);
    for (const OcclusalCavity::Spot& spot : spots) {
        const glm::dvec2 middle = grid.latticeOf(spot.atMm);
        const double reach = (kBesideMm + spot.halfMm) / grid.cellMm;
        const int beginI = std::max(0, static_cast<int>(std::ceil(middle.x - reach)));
        const int beginJ = std::max(0, static_cast<int>(std::ceil(middle.y - reach)));
        const int lastI = std::min(grid.side - 1, static_cast<int>(std::floor(middle.x + reach)));
        const int lastJ = std::min(grid.side - 1, static_cast<int>(std::floor(middle.y + reach)));
        for (int j = beginJ; j <= lastJ; ++j)
            for (int i = beginI; i <= lastI; ++i) {
                const glm::dvec2 off = grid.nodeMm(i, j) - spot.atMm;
                float& here = distance[grid.index(i, j)];
                here = std::min(here, static_cast<float>(std::sqrt(glm::dot(off, off)) - spot.halfMm));
            }
    }
}

/// Returns 0 where the wall is vertical, and up to 1 beyond an end of the axis.
double leanShare(const OcclusalCavity& cavity, double x, double radiusMm)
{
    double beyond = 0.0;
    if (cavity.mesialEndX)
        beyond = std::max(beyond, *cavity.mesialEndX - x);
    if (cavity.distalEndX)
        beyond = std::max(beyond, x - *cavity.distalEndX);
    const double t = std::clamp(beyond / radiusMm, 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// Lowers an ideal top by one pocket after another.
class Carver
{
public:
    Carver(const ToothDesign& design, const terrain::ToothAnatomy& anatomy)
        : m_design(design), m_anatomy(anatomy), m_top(anatomy.top), m_parts(anatomy.grid.count(), Part::Keep)
    {}

    void carve(const OcclusalCavity& cavity, const AxisRegion* box, double boxFloorMm)
    {
        const terrain::Grid& grid = m_anatomy.grid;
        std::vector<float> all(grid.count(), kFarMm);
        std::vector<float> one(grid.count());
        for (const auto& spots : cavity.strokes) {
            sweep(grid, spots, one);
            for (std::size_t k = 0; k < all.size(); ++k)
                if (one[k] < kFarMm)
                    all[k] = static_cast<float>(roundJoin(static_cast<double>(all[k]), static_cast<double>(one[k])));
        }
        const double radius = m_design.burRadiusMm;
        const double tangent = std::tan(m_design.divergeDeg * std::numbers::pi / 180.0);
        for (int j = 0; j < grid.side; ++j)
            for (int i = 0; i < grid.side; ++i) {
                const std::size_t k = grid.index(i, j);
                if (!(m_anatomy.top[k] > m_anatomy.bottom[k]))
                    continue;
                const glm::dvec2 at = grid.nodeMm(i, j);
                double away = static_cast<double>(all[k]);
                if (box != nullptr) {
                    const double toBox = box->distance(at);
                    if (toBox <= radius)
                        lower(k, boxFloorMm, riseBeside(toBox, radius, m_design.lineAngleMm));
                    away = away < static_cast<double>(kFarMm) ? roundJoin(away, toBox) : away;
                }
                const double floor = floorAt(cavity, k);
                if (away <= radius) {
                    lower(k, floor, riseBeside(away, radius, m_design.lineAngleMm));
                } else if (const double share = leanShare(cavity, at.x, radius); share > 0.0 && tangent > 0.0) {
                    lower(k, floor, m_design.lineAngleMm + (away - radius) / (share * tangent));
                }
            }
    }

    [[nodiscard]] grading::Preparation finish() &&
    {
        return {std::make_shared<const std::vector<float>>(std::move(m_top)), std::move(m_parts), {}};
    }

private:
    [[nodiscard]] double floorAt(const OcclusalCavity& cavity, std::size_t k) const
    {
        if (m_design.followsJunction == 0.0)
            return cavity.floorMm;
        return static_cast<double>(m_anatomy.layers[k].dej) - m_design.intoDentinMm;
    }

    void lower(std::size_t k, double floorMm, double riseMm)
    {
        const auto height = static_cast<float>(floorMm + riseMm);
        if (!(height < m_top[k] - static_cast<float>(kLeastCutMm)))
            return;
        m_top[k] = height > m_anatomy.bottom[k] ? height : terrain::kEmptyTop;
        m_parts[k] = riseMm > 0.0 ? Part::Wall : Part::Floor;
    }

    const ToothDesign& m_design;
    const terrain::ToothAnatomy& m_anatomy;
    std::vector<float> m_top;
    std::vector<Part> m_parts;
};

const char* opensPulp(Kind kind)
{
    switch (kind) {
    case Kind::ClassOne:
        return "this preparation would open the pulp; make its depth (depth_mm) less";
    case Kind::OcclusalReduction:
        return "this preparation would open the pulp; make the reduction (reduction_mm, functional_mm) less";
    case Kind::SlotMesial:
    case Kind::SlotDistal:
        return "this preparation would open the pulp; make the depth of the box (box_floor_mm, box_axial_mm) less";
    default:
        return "this preparation would open the pulp; make its depth (depth_mm) or that of the box (box_floor_mm, "
               "box_axial_mm) less";
    }
}

Status checkPulp(Kind kind, const grading::Preparation& ideal, const terrain::ToothAnatomy& anatomy)
{
    for (std::size_t k = 0; k < ideal.parts.size(); ++k)
        if (ideal.parts[k] != Part::Keep && terrain::hasPulp(anatomy, k) &&
            (*ideal.top)[k] <= anatomy.layers[k].pulpRoof)
            return unexpected(ErrorCode::OutOfRange, LocalizableText{opensPulp(kind)});
    return {};
}

/// Returns the region of the axis in a box: from beyond the surface of the tooth inwards.
AxisRegion boxRegion(const OcclusalCavity::Box& box, const ToothDesign& design)
{
    constexpr double kOutMm = 3.0;
    const glm::dvec2 out = box.outwards;
    const glm::dvec2 beside = glm::dvec2{-out.y, out.x} * std::max(0.0, 0.5 * design.boxWidthMm - design.burRadiusMm);
    const glm::dvec2 inner = box.atMm - out * (design.boxAxialMm - design.burRadiusMm);
    const glm::dvec2 outer = box.atMm + out * kOutMm;
    AxisRegion region;
    region.addPolygon({inner - beside, outer - beside, outer + beside, inner + beside});
    return region;
}

Result<grading::Preparation> makeOcclusal(Kind kind, const ToothDesign& design, const terrain::ToothAnatomy& anatomy)
{
    const auto form = teeth::posteriorForm(anatomy.fdi, anatomy.seed);
    if (!form)
        return tl::unexpected<Error>(form.error());
    const auto cavities = occlusalCavities(kind, anatomy.fdi, *form, design);
    if (!cavities)
        return tl::unexpected<Error>(cavities.error());
    Carver carver(design, anatomy);
    std::optional<grading::Preparation::Isthmus> isthmus;
    std::optional<grading::Preparation::Box> opening;
    for (const OcclusalCavity& cavity : *cavities) {
        if (cavity.box) {
            const AxisRegion box = boxRegion(*cavity.box, design);
            const double floorMm = cavity.floorMm - design.boxFloorMm;
            carver.carve(cavity, &box, floorMm);
            opening = grading::Preparation::Box{cavity.box->atMm, cavity.box->outwards, design.boxWidthMm, floorMm};
        } else {
            carver.carve(cavity, nullptr, 0.0);
        }
        if (cavity.isthmus && !isthmus)
            isthmus =
                grading::Preparation::Isthmus{cavity.isthmus->atMm, cavity.isthmus->across, cavity.isthmus->lengthMm};
    }
    grading::Preparation ideal = std::move(carver).finish();
    ideal.isthmus = isthmus;
    ideal.box = opening;
    ideal.obliqueCrest = obliqueCrest(anatomy.fdi, *form);
    if (Status safe = checkPulp(kind, ideal, anatomy); !safe)
        return tl::unexpected(std::move(safe).error());
    return ideal;
}

/// Checks whether a tooth has a design for the kind. A scan has none, and some kinds exist for some teeth only.
Result<ToothDesign> checkTooth(Kind kind, const terrain::ToothAnatomy& anatomy)
{
    if (!teeth::isGenerated(anatomy))
        return unexpected(
            ErrorCode::UnknownName,
            LocalizableText{"nobody knows where the fissures of '%1' run or which side is mesial; choose a tooth "
                            "by its FDI number, or take an ideal from attempts at this one",
                            {noted(anatomy.name)}});
    if (!anatomy.lying.isUpright() && !(kind == Kind::Access && opensFromLingual(anatomy.lying, anatomy.fdi)))
        return unexpected(
            ErrorCode::OutOfRange,
            LocalizableText{"this preparation is made for a tooth that stands upright; leave out \"lies\", or take "
                            "an ideal from attempts at this tooth"});
    return usualDesign(kind, anatomy.fdi);
}

}  // namespace

Result<ToothDesign> fittedDesign(Kind kind, const terrain::ToothAnatomy& anatomy)
{
    constexpr double kLeastRidgeMm = 0.8;
    auto design = checkTooth(kind, anatomy);
    if (!design || kind == Kind::Access || kind == Kind::OcclusalReduction)
        return design;
    const auto form = teeth::posteriorForm(anatomy.fdi, anatomy.seed);
    if (!form)
        return tl::unexpected<Error>(form.error());
    const ToothDesign usual = *design;
    Error fault;
    for (int less = 0; usual.ridgeMm - 0.1 * less > kLeastRidgeMm - 0.05; ++less) {
        design->ridgeMm = usual.ridgeMm - 0.1 * less;
        for (const int step : {0, 1, 2}) {
            design->divergeDeg = step == 0 ? usual.divergeDeg : 0.0;
            design->obliqueMm = step == 2 ? 0.5 * usual.obliqueMm : usual.obliqueMm;
            const auto cavities = occlusalCavities(kind, anatomy.fdi, *form, *design);
            if (cavities)
                return design;
            fault = cavities.error();
        }
    }
    return tl::unexpected<Error>(fault);
}

Result<grading::Preparation> makePreparation(Kind kind, const ToothDesign& design, const terrain::ToothAnatomy& anatomy)
{
    if (const auto usual = checkTooth(kind, anatomy); !usual)
        return tl::unexpected<Error>(usual.error());
    if (Status good = validate(kind, design); !good)
        return tl::unexpected(std::move(good).error());
    if (kind == Kind::Access)
        return accessOpening(design, anatomy);
    if (kind != Kind::OcclusalReduction)
        return makeOcclusal(kind, design, anatomy);
    auto ideal = occlusalReduction(design, anatomy);
    if (ideal)
        if (Status safe = checkPulp(kind, *ideal, anatomy); !safe)
            return tl::unexpected(std::move(safe).error());
    return ideal;
}

}  // namespace core::preparation
