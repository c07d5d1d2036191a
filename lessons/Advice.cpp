// SPDX-License-Identifier: GPL-3.0-or-later
#include "lessons/Advice.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

namespace lessons {
namespace {

using core::grading::Measured;
using Rule = Advice::Rule;

struct Finding
{
    Rule rule;
    double amount = 0.0;
    double askedMm = 0.0;
};

bool isOneOf(std::string_view measure, std::initializer_list<std::string_view> prefixes)
{
    return std::any_of(prefixes.begin(), prefixes.end(),
                       [&](std::string_view prefix) { return measure.starts_with(prefix); });
}

/// Returns the moment that lost most of a criterion's points.
const Moment* worstOf(const std::vector<Moment>& moments)
{
    const auto worst = std::max_element(moments.begin(), moments.end(),
                                        [](const Moment& a, const Moment& b) { return a.lostTenths < b.lostTenths; });
    return worst == moments.end() ? nullptr : &*worst;
}

/// Returns how far the floor is below the ideal one and above it, mm.
std::pair<double, double> depthOf(const Measured& measured)
{
    if (!measured.deviation || !measured.deviation->depth)
        return {0.0, 0.0};
    return {measured.deviation->depth->tooDeepMm.value, measured.deviation->depth->tooShallowMm.value};
}

/// Returns how far the outline is outside the ideal one and inside it, mm.
std::pair<double, double> outlineOf(const Measured& measured)
{
    if (!measured.deviation || !measured.deviation->outline)
        return {0.0, 0.0};
    return {measured.deviation->outline->overMm.value, measured.deviation->outline->underMm.value};
}

/// Returns how much of the ideal preparation is not cut, per cent.
double leftPercent(const Measured& measured)
{
    if (!measured.deviation || measured.deviation->idealMm3 <= 0.0)
        return 0.0;
    return 100.0 * measured.deviation->undercutMm3 / measured.deviation->idealMm3;
}

Finding pitFinding(const Measured& measured, double value)
{
    const auto& worst =
        measured.deviation && measured.deviation->depth ? measured.deviation->depth->worstPiece : std::nullopt;
    if (!worst)
        return {Rule::TooShallow, value};
    return {worst->meanMm < 0.0 ? Rule::PitTooDeep : Rule::PitTooShallow, value, worst->depthMm};
}

/// Converts the advice on a floor that is too deep or too shallow: if only enamel had to be cut, it is about dentin cut
/// or enamel left.
Finding toTheJunction(const Finding& finding, const Measured& measured)
{
    constexpr auto kDentin = static_cast<std::size_t>(core::terrain::Material::Dentin);
    if (finding.rule == Rule::TooDeep)
        return {Rule::DentinCut, measured.measures.removedMm3[kDentin]};
    if (finding.rule == Rule::TooShallow)
        return {Rule::EnamelLeft, finding.amount};
    return finding;
}

/// Advice that depends only on the id of the measure. Its amount is the measured value.
constexpr std::pair<std::string_view, Rule> kByMeasure[] = {{"soft_left_percent", Rule::SoftDecayLeft},
                                                            {"leathery_left_mm2", Rule::LeatheryLeft},
                                                            {"perforated_mm2", Rule::Perforated},
                                                            {"unsupported_enamel_mm3", Rule::UnsupportedEnamel},
                                                            {"ridge_lost_mm", Rule::RidgeThinned},
                                                            {"ridge_", Rule::RidgeThin},
                                                            {"wall_angle", Rule::WallsLean},
                                                            {"wall_roughness_mm", Rule::WallsRough},
                                                            {"oblique_ridge_", Rule::ObliqueRidgeThin},
                                                            {"gingival_floor_", Rule::GingivalFloorOff},
                                                            {"floor_slope_deg", Rule::FloorTilted},
                                                            {"floor_", Rule::FloorUneven},
                                                            {"neighbour_hits", Rule::NeighbourTouched},
                                                            {"force_", Rule::PushedTooHard},
                                                            {"hold_", Rule::ForceNotHeld},
                                                            {"time_", Rule::TooSlow},
                                                            {"points_touched_percent", Rule::NotTouched},
                                                            {"layers_named_percent", Rule::NotNamed},
                                                            {"removed_mm3", Rule::CutInExercise}};

/// @param feed  of the bur when most points were lost, mm/s
std::optional<Finding> findingOf(const Criterion& line, const Measured& measured, double feed)
{
    if (line.isTooEarly)
        return Finding{Rule::TooLittleDone, line.onceMeasured.value_or(0.0)};
    if (!line.measured)
        return std::nullopt;
    const std::string_view id = line.measure;
    const double value = *line.measured;
    const auto fastOr = [feed](Rule fast, Rule usual, double amount) {
        return feed >= kFastFeedMmPerS ? Finding{fast, feed} : Finding{usual, amount};
    };
    if (id == "pulp_exposed_mm2" && line.side == Side::Under)
        return Finding{Rule::PulpNotReached};
    if (id == "remaining_over_pulp_mm" && value > 0.0)
        return Finding{Rule::NearPulp, value};
    if (isOneOf(id, {"pulp_", "remaining_over_pulp"}))
        return fastOr(Rule::PulpOpenedFast, Rule::PulpOpened, 0.0);
    // In decay with zones, some decay may stay.
    const bool hasZones = measured.lesion && measured.lesion->zones;
    if (hasZones && id == "caries_at_junction_mm2")
        return Finding{Rule::LeftAtJunction, value};
    if (id.starts_with("caries_")) {
        const core::grading::Measures& all = measured.measures;
        return Finding{Rule::DecayLeft, all.lesionMm3 > 0.0 ? 100.0 * all.cariesLeftMm3 / all.lesionMm3 : 0.0};
    }
    if (id == "sound_overcut_mm3")
        return fastOr(Rule::SoundTissueFast, Rule::SoundTissue, value);
    if (id == "beyond_lesion_mm")
        return Finding{Rule::FarFromDecay, value};
    if (id == "below_lesion_mm")
        return Finding{hasZones ? Rule::BelowFirmDecay : Rule::BelowDecay, value};
    if (id == "floor_into_dentin_mm")
        return Finding{Rule::FloorInEnamel};
    if (id == "dentin_removed_mm3")
        return Finding{Rule::DentinCut, value};
    if (id == "plunge_error_worst_mm")
        return pitFinding(measured, value);
    if (id == "floor_gouge_mm")
        return fastOr(Rule::TooDeepFast, Rule::TooDeep, value);
    const auto [deep, shallow] = depthOf(measured);
    if (isOneOf(id, {"depth_too_deep", "overcut_below", "leeway_bottom", "container_bottom"}))
        return fastOr(Rule::TooDeepFast, Rule::TooDeep, deep);
    // While most of the preparation is uncut, the depth of its floor and its outline mean little.
    const double left = leftPercent(measured);
    if (isOneOf(id, {"depth_", "outline_"}) && left > 50.0)
        return Finding{Rule::NotAllCut, left};
    if (id.starts_with("depth_"))
        return deep >= shallow && !isOneOf(id, {"depth_too_shallow", "depth_shallow"})
                   ? fastOr(Rule::TooDeepFast, Rule::TooDeep, deep)
                   : Finding{Rule::TooShallow, shallow};
    if (isOneOf(id, {"undercut_", "ideal_cut", "target_removed"}))
        return Finding{Rule::NotAllCut, id == "undercut_percent" ? value : std::max(0.0, 100.0 - value)};
    const auto [beyond, behind] = outlineOf(measured);
    if (id == "beyond_ideal_mm")
        return Finding{Rule::OutlineBeyond, value};
    if (isOneOf(id, {"outline_over", "overcut_", "leeway_sides", "container_sides"}))
        return Finding{Rule::OutlineBeyond, beyond};
    if (id.starts_with("outline_"))
        return beyond >= behind && id != "outline_under_mm" ? Finding{Rule::OutlineBeyond, beyond}
                                                            : Finding{Rule::OutlineShort, behind};
    if (id == "isthmus_error_mm")
        return Finding{value > 0.0 ? Rule::IsthmusWide : Rule::IsthmusNarrow, std::abs(value)};
    if (id.starts_with("axial_depth_")) {
        const double off = value - line.target;
        return Finding{off > 0.0 ? Rule::AxialWallDeep : Rule::AxialWallShallow, std::abs(off)};
    }
    for (const auto& [prefix, rule] : kByMeasure)
        if (id.starts_with(prefix))
            return Finding{rule, std::abs(value)};
    return std::nullopt;
}

}  // namespace

std::vector<Advice> adviceOn(const ScoreSheet& sheet, const Measured& measured,
                             const std::vector<std::vector<Moment>>& moments)
{
    std::vector<Advice> all;
    const bool sparesDentin = std::any_of(sheet.criteria.begin(), sheet.criteria.end(),
                                          [](const Criterion& line) { return line.measure == "dentin_removed_mm3"; });
    for (std::size_t k = 0; k < sheet.criteria.size(); ++k) {
        const Criterion& line = sheet.criteria[k];
        const bool hasFailed = line.critical && line.capTenths == 0 && line.share > 0.0;
        if (line.lostTenths == 0 && !hasFailed)
            continue;
        const Moment* worst = k < moments.size() ? worstOf(moments[k]) : nullptr;
        auto found = findingOf(line, measured, worst != nullptr ? worst->feedMmPerS : 0.0);
        if (found && sparesDentin)
            found = toTheJunction(*found, measured);
        if (found)
            all.push_back({found->rule, k, found->amount, found->askedMm,
                           worst != nullptr ? std::optional(*worst) : std::nullopt});
    }
    std::stable_sort(all.begin(), all.end(), [&](const Advice& a, const Advice& b) {
        const Criterion& first = sheet.criteria[a.criterion];
        const Criterion& second = sheet.criteria[b.criterion];
        return first.critical != second.critical ? first.critical : first.lostTenths > second.lostTenths;
    });
    std::vector<Advice> each;
    for (const Advice& advice : all) {
        const auto same =
            std::find_if(each.begin(), each.end(), [&](const Advice& told) { return told.rule == advice.rule; });
        if (same == each.end())
            each.push_back(advice);
        else if (sheet.criteria[same->criterion].critical && !sheet.criteria[advice.criterion].critical)
            *same = advice;
    }
    return each;
}

}  // namespace lessons
