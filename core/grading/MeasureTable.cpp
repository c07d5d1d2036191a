// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grading/MeasureTable.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace core::grading {
namespace {

using Value = std::optional<double>;
using Node = std::optional<std::size_t>;
using terrain::Material;

constexpr std::string_view kMetrics = "docs/facts/teaching.md, section 3";
constexpr std::string_view kSturdevant = "Sturdevant's Art and Science of Operative Dentistry";
constexpr std::string_view kZones = "International Caries Consensus Collaboration (Schwendicke 2016)";
constexpr std::string_view kForms = "docs/teeth.md, Ideal preparations";
constexpr std::string_view kPad = "docs/facts/teaching.md, section 5 (Simodont)";
constexpr std::string_view kFirstMinutes = "ours: the first five minutes at the device";
constexpr std::string_view kStrokes = "docs/facts/teaching.md, section 1 (Ioannou 2010)";
constexpr std::string_view kHapTel = "docs/facts/teaching.md, section 1 (hapTEL)";

double removed(const Measured& m, Material material)
{
    return m.measures.removedMm3[static_cast<std::size_t>(material)];
}

/// Returns `say` of the deviation; empty if there is no deviation.
template <class Say>
auto ofDeviation(const Measured& m, Say say) -> decltype(say(*m.deviation))
{
    if (!m.deviation)
        return {};
    return say(*m.deviation);
}

/// Returns `say` of a part of the deviation; empty if the part is absent.
template <class Answer, class Part, class Say>
Answer ofPart(const Measured& m, std::optional<Part> Deviation::*part, Say say)
{
    if (!m.deviation || !((*m.deviation).*part))
        return {};
    return say(*((*m.deviation).*part));
}

template <class Say>
Value ofProcess(const Measured& m, Say say)
{
    return m.process ? Value(say(*m.process)) : std::nullopt;
}

/// Returns `say` of an exercise of this kind; empty for another kind.
template <class Kind, class Say>
Value ofExercise(const Measured& m, Say say)
{
    const Kind* practised = m.practised ? std::get_if<Kind>(&*m.practised) : nullptr;
    return practised != nullptr ? Value(say(*practised)) : std::nullopt;
}

Value valueOf(const std::optional<Placed>& placed)
{
    return placed ? Value(placed->value) : std::nullopt;
}

Node nodeOf(const std::optional<Placed>& placed)
{
    return placed ? Node(placed->node) : std::nullopt;
}

/// Returns the place where an error is largest; no place if the largest is 0.
Node worstOf(const Placed& placed)
{
    return placed.value > 0.0 ? Node(placed.node) : std::nullopt;
}

Value percent(double part, double whole)
{
    return whole > 0.0 ? Value(100.0 * (part / whole)) : std::nullopt;
}

std::optional<Placed> inForm(const Measured& m, std::optional<Placed> Form::*part)
{
    return m.deviation ? m.deviation->form.*part : std::nullopt;
}

std::optional<Placed> wall(const Measured& m, Side side)
{
    return m.deviation ? m.deviation->form.wallDeg.at(static_cast<std::size_t>(side)) : std::nullopt;
}

/// Returns the wall of a side, if the sides of the tooth are known.
std::optional<Placed> namedWall(const Measured& m, Side side)
{
    return m.deviation && m.deviation->buccalSign != 0 ? wall(m, side) : std::nullopt;
}

/// @param sign  1: the buccal wall, -1: the lingual one
std::optional<Placed> wallAcross(const Measured& m, int sign)
{
    return namedWall(m, m.deviation && m.deviation->buccalSign == sign ? Side::PlusY : Side::MinusY);
}

constexpr std::array kSides{Side::MinusX, Side::PlusX, Side::MinusY, Side::PlusY};

Value ofLesionCut(const Measured& m, Placed LesionCut::*part)
{
    return m.lesion ? Value(((*m.lesion).*part).value) : std::nullopt;
}

Node nodeOfLesionCut(const Measured& m, Placed LesionCut::*part)
{
    return m.lesion ? worstOf((*m.lesion).*part) : std::nullopt;
}

/// Returns how much of a marginal ridge is missing. Ridges that a box passes through do not count.
std::optional<Placed> ridgeLost(const Measured& m)
{
    constexpr double kLeftByIdealMm = 0.3;
    if (m.lesion)
        return m.lesion->ridgeLostMm;
    if (!m.deviation)
        return {};
    std::optional<Placed> most;
    for (const auto ridge : {&Form::ridgeMesialMm, &Form::ridgeDistalMm}) {
        const auto& asked = m.deviation->idealForm.*ridge;
        const auto& left = m.deviation->form.*ridge;
        if (!asked || !left || asked->value < kLeftByIdealMm)
            continue;
        if (const double lost = std::max(0.0, asked->value - left->value); !most || lost > most->value)
            most = Placed{lost, left->node};
    }
    return most;
}

Value ofZones(const Measured& m, Placed DecayZonesLeft::*part)
{
    return m.lesion && m.lesion->zones ? Value(((*m.lesion->zones).*part).value) : std::nullopt;
}

Node nodeOfZones(const Measured& m, Placed DecayZonesLeft::*part)
{
    return m.lesion && m.lesion->zones ? worstOf((*m.lesion->zones).*part) : std::nullopt;
}

/// Returns the wall that leans most (`sign` 1) or least (-1).
std::optional<Placed> extremeWall(const Measured& m, double sign)
{
    std::optional<Placed> most;
    for (const Side side : kSides)
        if (const auto here = wall(m, side); here && (!most || sign * here->value > sign * most->value))
            most = here;
    return most;
}

/// Returns whether enough of the ideal is cut to judge its walls and floor. A few holes are not enough.
bool isFormed(const Measured& m)
{
    return m.deviation && m.deviation->undercutMm3 <= (1.0 - kFormedShare) * m.deviation->idealMm3;
}

/// Returns the floor of a cut, if it has one.
std::optional<FloorForm> formedFloor(const Measured& m)
{
    return isFormed(m) ? m.deviation->floor : std::nullopt;
}

/// Returns the wall whose angle differs most from the ideal's on the same side, and the difference.
std::optional<Placed> wallError(const Measured& m)
{
    std::optional<Placed> most;
    if (!isFormed(m))
        return most;
    for (const Side side : kSides) {
        const auto here = wall(m, side);
        if (!here)
            continue;
        const auto& ideal = m.deviation->idealForm.wallDeg.at(static_cast<std::size_t>(side));
        if (ideal && (!most || std::abs(here->value - ideal->value) > most->value))
            most = Placed{std::abs(here->value - ideal->value), here->node};
    }
    return most;
}

Node worstStep(const Measured& m)
{
    const auto floor = formedFloor(m);
    return floor ? Node(worstOf(floor->stepMm)) : std::nullopt;
}

/// Returns the time when the last point was touched; empty until all are touched.
Value allTouchedS(const Touched& touched)
{
    Value last;
    for (const auto& at : touched.atS) {
        if (!at)
            return std::nullopt;
        last = std::max(last.value_or(0.0), *at);
    }
    return last;
}

/// Returns the difference of a size: that of the cut minus that of the ideal.
Value formError(const Measured& m, std::optional<Placed> Form::*part)
{
    const auto here = inForm(m, part);
    if (!here || !(m.deviation->idealForm.*part))
        return {};
    return here->value - (m.deviation->idealForm.*part)->value;
}

/// Returns the mesial or the distal ridge. `inDeviation` selects it in a preparation, `inLesion` after the removal of
/// decay.
std::optional<Placed> ridge(const Measured& m, std::optional<Placed> Form::*inDeviation,
                            std::optional<Placed> LesionCut::*inLesion)
{
    if (!m.deviation && m.lesion)
        return (*m.lesion).*inLesion;
    return inForm(m, inDeviation);
}

std::optional<Placed> mesialRidge(const Measured& m)
{
    return ridge(m, &Form::ridgeMesialMm, &LesionCut::ridgeMesialMm);
}

std::optional<Placed> distalRidge(const Measured& m)
{
    return ridge(m, &Form::ridgeDistalMm, &LesionCut::ridgeDistalMm);
}

std::optional<Placed> leastRidge(const Measured& m)
{
    const auto mesial = mesialRidge(m);
    const auto distal = distalRidge(m);
    return !distal || (mesial && mesial->value <= distal->value) ? mesial : distal;
}

Node overNode(const Measured& m)
{
    return ofDeviation(m, [](const Deviation& d) { return d.overcutNode; });
}

Node underNode(const Measured& m)
{
    return ofDeviation(m, [](const Deviation& d) { return d.undercutNode; });
}

Node eitherNode(const Measured& m)
{
    const bool over = m.deviation && m.deviation->overcutMm3() > m.deviation->undercutMm3;
    return over ? overNode(m) : underNode(m);
}

Node outlineNode(const Measured& m)
{
    return ofPart<Node>(m, &Deviation::outline, [](const OutlineDeviation& o) {
        return worstOf(o.underMm.value > o.overMm.value ? o.underMm : o.overMm);
    });
}

Node depthNode(const Measured& m)
{
    return ofPart<Node>(m, &Deviation::depth, [](const DepthError& d) {
        return worstOf(d.tooShallowMm.value > d.tooDeepMm.value ? d.tooShallowMm : d.tooDeepMm);
    });
}

std::optional<PieceError> worstPiece(const Measured& m)
{
    return m.deviation && m.deviation->depth ? m.deviation->depth->worstPiece : std::nullopt;
}

Node cariesNode(const Measured& m)
{
    return m.measures.cariesLeftNode;
}

Value ofLesion(const Measured& m, double value)
{
    return m.measures.lesionMm3 > 0.0 ? Value(value) : std::nullopt;
}

constexpr auto kTable = std::to_array<MeasureInfo>({
    {"caries_removed_mm3", "mm3", "Decay that was removed.", kMetrics,
     [](const Measured& m) -> Value { return ofLesion(m, removed(m, Material::Caries)); }, nullptr},
    {"caries_removed_percent", "percent", "Share of the lesion that was removed.", kHapTel,
     [](const Measured& m) -> Value { return ofLesion(m, 100.0 - m.measures.cariesLeftPercent); }, cariesNode},
    {"caries_left_mm3", "mm3", "Decay that is still in the tooth.", kMetrics,
     [](const Measured& m) -> Value { return ofLesion(m, m.measures.cariesLeftMm3); }, cariesNode},
    {"caries_left_percent", "percent", "Share of the lesion that is still in the tooth.", kHapTel,
     [](const Measured& m) -> Value { return ofLesion(m, m.measures.cariesLeftPercent); }, cariesNode},
    {"caries_largest_island_mm3", "mm3",
     "Largest piece of decay left; columns hang together where they share an edge and their decay overlaps in height.",
     kMetrics, [](const Measured& m) -> Value { return ofLesion(m, m.measures.largestIslandMm3); }, cariesNode},
    {"caries_at_junction_mm2", "mm2",
     "Area, seen from above, in which decay is left within 0.5 mm of the enamel-dentin junction.", kSturdevant,
     [](const Measured& m) -> Value { return ofLesionCut(m, &LesionCut::junctionMm2); },
     [](const Measured& m) -> Node { return nodeOfLesionCut(m, &LesionCut::junctionMm2); }},
    {"caries_on_floor_mm2", "mm2", "Area, seen from above, in which decay is left deeper than that.", kSturdevant,
     [](const Measured& m) -> Value { return ofLesionCut(m, &LesionCut::floorMm2); },
     [](const Measured& m) -> Node { return nodeOfLesionCut(m, &LesionCut::floorMm2); }},
    {"soft_left_percent", "percent",
     "Share of the soft decay that is still in the tooth, where decay has a soft, a leathery and a firm zone.", kZones,
     [](const Measured& m) -> Value { return ofZones(m, &DecayZonesLeft::softPercent); },
     [](const Measured& m) -> Node { return nodeOfZones(m, &DecayZonesLeft::softPercent); }},
    {"leathery_left_mm2", "mm2",
     "Area, seen from above, in which leathery or soft decay is left, but for where the pulp is 1.5 mm or less below the "
     "lesion.",
     kZones, [](const Measured& m) -> Value { return ofZones(m, &DecayZonesLeft::leatheryMm2); },
     [](const Measured& m) -> Node { return nodeOfZones(m, &DecayZonesLeft::leatheryMm2); }},
    {"beyond_lesion_mm", "mm",
     "Distance, seen from above, from the smallest cavity that clears the decay to what was cut 0.2 mm deep or deeper; "
     "0.1 mm² are as far away, or farther.",
     kSturdevant, [](const Measured& m) -> Value { return ofLesionCut(m, &LesionCut::beyondMm); },
     [](const Measured& m) -> Node { return nodeOfLesionCut(m, &LesionCut::beyondMm); }},
    {"ridge_lost_mm", "mm",
     "How much thinner a marginal ridge is than the ideal, or the smallest cavity that clears the decay, would leave it; 0 where there is none.",
     kSturdevant, [](const Measured& m) -> Value { return valueOf(ridgeLost(m)); },
     [](const Measured& m) -> Node { return nodeOf(ridgeLost(m)); }},
    {"below_lesion_mm", "mm",
     "Depth of the cut below the decay that had to go, and below what was deeper within 0.8 mm; 0.5 mm² are as deep, or "
     "deeper.",
     kSturdevant, [](const Measured& m) -> Value { return ofLesionCut(m, &LesionCut::belowMm); },
     [](const Measured& m) -> Node { return nodeOfLesionCut(m, &LesionCut::belowMm); }},
    {"lesion_mm3", "mm3", "Decay before anything was cut.", kMetrics,
     [](const Measured& m) -> Value { return m.measures.lesionMm3; }, nullptr},
    {"access_mm3", "mm3", "Sound tissue straight above the lesion, which has to go with it.", kMetrics,
     [](const Measured& m) -> Value { return ofLesion(m, m.measures.accessMm3); }, nullptr},
    {"smallest_cavity_mm3", "mm3", "The smallest cavity that clears the decay: the lesion, but for what of it may stay, and its access.", kMetrics,
     [](const Measured& m) -> Value {
         return ofLesion(m, m.measures.lesionMm3 - m.measures.decayToKeepMm3 + m.measures.accessMm3);
     },
     nullptr},
    {"sound_overcut_mm3", "mm3", "Sound enamel and dentin removed beside the lesion or below it.",
     "docs/facts/teaching.md, section 1 (Osnes 2021)", [](const Measured& m) -> Value { return m.measures.overcutMm3; },
     [](const Measured& m) -> Node { return m.measures.overcutNode; }},
    {"enamel_removed_mm3", "mm3", "Enamel that was removed.", kMetrics,
     [](const Measured& m) -> Value { return removed(m, Material::Enamel); }, nullptr},
    {"dentin_removed_mm3", "mm3", "Dentin that was removed.", kMetrics,
     [](const Measured& m) -> Value { return removed(m, Material::Dentin); }, nullptr},
    {"pulp_removed_mm3", "mm3", "Pulp that was removed.", kMetrics,
     [](const Measured& m) -> Value { return removed(m, Material::Pulp); },
     [](const Measured& m) -> Node { return m.measures.pulpNode; }},
    {"deepest_cut_mm", "mm", "Largest lowering of the surface, straight down.", kMetrics,
     [](const Measured& m) -> Value { return m.measures.deepestCutMm; },
     [](const Measured& m) -> Node { return m.measures.deepestCutNode; }},
    {"pulp_exposed_mm2", "mm2", "Area, seen from above, that was cut down to the pulp or through it.", kMetrics,
     [](const Measured& m) -> Value { return m.measures.pulpExposedMm2; },
     [](const Measured& m) -> Node { return m.measures.pulpNode; }},
    {"perforated_mm2", "mm2", "Area, seen from above, of holes that go right through the tooth.", kMetrics,
     [](const Measured& m) -> Value { return m.measures.perforatedMm2; },
     [](const Measured& m) -> Node { return m.measures.deepestCutNode; }},
    {"remaining_over_pulp_mm", "mm",
     "Shortest distance in any direction from a cut surface to the pulp; 5 stands for all beyond.",
     "docs/teeth.md, Ideal preparations (Murray 2003)",
     [](const Measured& m) -> Value {
         return m.measures.hasRemainingOverPulp ? Value(m.measures.remainingOverPulpMm) : std::nullopt;
     },
     [](const Measured& m) -> Node { return m.measures.pulpNode; }},

    {"ideal_mm3", "mm3", "What the ideal preparation takes away.", kMetrics,
     [](const Measured& m) -> Value { return ofDeviation(m, [](const Deviation& d) { return Value(d.idealMm3); }); },
     nullptr},
    {"removed_mm3", "mm3", "What was taken away, all tissues together.", kMetrics,
     [](const Measured& m) -> Value {
         const auto& all = m.measures.removedMm3;
         return all[0] + all[1] + all[2] + all[3];
     },
     nullptr},
    {"overcut_mm3", "mm3", "What was removed outside the ideal preparation, beside and below it.", kMetrics,
     [](const Measured& m) -> Value {
         return ofDeviation(m, [](const Deviation& d) { return Value(d.overcutMm3()); });
     },
     overNode},
    {"overcut_beside_mm3", "mm3", "What was removed of columns that the ideal preparation keeps.", kMetrics,
     [](const Measured& m) -> Value {
         return ofDeviation(m, [](const Deviation& d) { return Value(d.overcutBesideMm3); });
     },
     overNode},
    {"overcut_below_mm3", "mm3", "What was removed below the ideal preparation.", kMetrics,
     [](const Measured& m) -> Value {
         return ofDeviation(m, [](const Deviation& d) { return Value(d.overcutBelowMm3); });
     },
     overNode},
    {"undercut_mm3", "mm3", "What of the ideal preparation was not removed (under-cut, no retentive undercut).", kMetrics,
     [](const Measured& m) -> Value {
         return ofDeviation(m, [](const Deviation& d) { return Value(d.undercutMm3); });
     },
     underNode},
    {"overcut_percent", "percent", "What was removed outside the ideal preparation, over the ideal's volume.", kMetrics,
     [](const Measured& m) -> Value {
         return ofDeviation(m, [](const Deviation& d) { return percent(d.overcutMm3(), d.idealMm3); });
     },
     overNode},
    {"undercut_percent", "percent", "What of the ideal preparation was not removed, over the ideal's volume.", kMetrics,
     [](const Measured& m) -> Value {
         return ofDeviation(m, [](const Deviation& d) { return percent(d.undercutMm3, d.idealMm3); });
     },
     underNode},
    {"ideal_cut_percent", "percent", "What of the ideal preparation was removed, over the ideal's volume.", kMetrics,
     [](const Measured& m) -> Value {
         return ofDeviation(m, [](const Deviation& d) { return percent(d.idealMm3 - d.undercutMm3, d.idealMm3); });
     },
     underNode},
    {"dice", "", "Twice the volume common to what was removed and the ideal, over the sum of both volumes.", kMetrics,
     [](const Measured& m) -> Value { return ofDeviation(m, [](const Deviation& d) { return d.dice; }); }, eitherNode},
    {"iou", "", "Volume common to what was removed and the ideal, over the volume of either.", kMetrics,
     [](const Measured& m) -> Value { return ofDeviation(m, [](const Deviation& d) { return d.iou; }); }, eitherNode},

    {"depth_error_mean_mm", "mm", "Mean size of the floor's error in height, over the ideal floor's area.", kMetrics,
     [](const Measured& m) -> Value {
         return ofPart<Value>(m, &Deviation::depth, [](const DepthError& d) { return d.meanMm; });
     },
     depthNode},
    {"depth_error_signed_mm", "mm", "Mean of the floor's error in height; negative is too deep.", kMetrics,
     [](const Measured& m) -> Value {
         return ofPart<Value>(m, &Deviation::depth, [](const DepthError& d) { return d.signedMm; });
     },
     depthNode},
    {"depth_error_p95_mm", "mm", "Size of the floor's error in height that 95 percent of the floor stay within.",
     kMetrics,
     [](const Measured& m) -> Value {
         return ofPart<Value>(m, &Deviation::depth, [](const DepthError& d) { return d.p95Mm; });
     },
     depthNode},
    {"depth_too_deep_mm", "mm", "Most that the floor lies below the ideal one.", kMetrics,
     [](const Measured& m) -> Value {
         return ofPart<Value>(m, &Deviation::depth, [](const DepthError& d) { return d.tooDeepMm.value; });
     },
     [](const Measured& m) -> Node {
         return ofPart<Node>(m, &Deviation::depth, [](const DepthError& d) { return worstOf(d.tooDeepMm); });
     }},
    {"depth_too_shallow_mm", "mm", "Most that the floor lies above the ideal one.", kMetrics,
     [](const Measured& m) -> Value {
         return ofPart<Value>(m, &Deviation::depth, [](const DepthError& d) { return d.tooShallowMm.value; });
     },
     [](const Measured& m) -> Node {
         return ofPart<Node>(m, &Deviation::depth, [](const DepthError& d) { return worstOf(d.tooShallowMm); });
     }},
    {"depth_deep_p95_mm", "mm", "Distance below the ideal floor that 95 percent of the floor do not exceed.", kSturdevant,
     [](const Measured& m) -> Value {
         return ofPart<Value>(m, &Deviation::depth, [](const DepthError& d) { return d.deepP95Mm; });
     },
     [](const Measured& m) -> Node {
         return ofPart<Node>(m, &Deviation::depth, [](const DepthError& d) { return worstOf(d.tooDeepMm); });
     }},
    {"depth_shallow_p95_mm", "mm", "Distance above the ideal floor that 95 percent of the floor do not exceed.",
     kSturdevant,
     [](const Measured& m) -> Value {
         return ofPart<Value>(m, &Deviation::depth, [](const DepthError& d) { return d.shallowP95Mm; });
     },
     [](const Measured& m) -> Node {
         return ofPart<Node>(m, &Deviation::depth, [](const DepthError& d) { return worstOf(d.tooShallowMm); });
     }},
    {"floor_gouge_mm", "mm", "Distance below the ideal floor of its deepest 0.5 mm².", kSturdevant,
     [](const Measured& m) -> Value {
         return ofPart<Value>(m, &Deviation::depth, [](const DepthError& d) { return d.gougeMm.value; });
     },
     [](const Measured& m) -> Node {
         return ofPart<Node>(m, &Deviation::depth, [](const DepthError& d) { return worstOf(d.gougeMm); });
     }},
    {"plunge_error_worst_mm", "mm",
     "Of a floor in separate pieces, such as a row of pits, the size of the mean error in height of the worst piece.",
     kPad,
     [](const Measured& m) -> Value {
         const auto worst = worstPiece(m);
         return worst ? Value(std::abs(worst->meanMm)) : std::nullopt;
     },
     [](const Measured& m) -> Node {
         const auto worst = worstPiece(m);
         return worst && worst->meanMm != 0.0 ? Node(worst->node) : std::nullopt;
     }},

    {"outline_mean_mm", "mm", "Mean distance between the outline cut and the ideal one.", kMetrics,
     [](const Measured& m) -> Value {
         return ofPart<Value>(m, &Deviation::outline, [](const OutlineDeviation& o) { return o.meanMm; });
     },
     outlineNode},
    {"outline_signed_mm", "mm",
     "Mean signed distance between the outline cut and the ideal one; positive is over-extended.", kMetrics,
     [](const Measured& m) -> Value {
         return ofPart<Value>(m, &Deviation::outline, [](const OutlineDeviation& o) { return o.signedMm; });
     },
     outlineNode},
    {"outline_p95_mm", "mm", "Distance between the outlines that 95 percent of their length stay within.", kMetrics,
     [](const Measured& m) -> Value {
         return ofPart<Value>(m, &Deviation::outline, [](const OutlineDeviation& o) { return o.p95Mm; });
     },
     outlineNode},
    {"outline_max_mm", "mm", "Largest distance between the outline cut and the ideal one, either way.", kMetrics,
     [](const Measured& m) -> Value {
         return ofPart<Value>(m, &Deviation::outline,
                       [](const OutlineDeviation& o) { return std::max(o.overMm.value, o.underMm.value); });
     },
     outlineNode},
    {"outline_over_mm", "mm", "Farthest that the cut goes beyond the ideal outline.", kForms,
     [](const Measured& m) -> Value {
         return ofPart<Value>(m, &Deviation::outline, [](const OutlineDeviation& o) { return o.overMm.value; });
     },
     [](const Measured& m) -> Node {
         return ofPart<Node>(m, &Deviation::outline, [](const OutlineDeviation& o) { return worstOf(o.overMm); });
     }},
    {"outline_under_mm", "mm", "Farthest that the cut stays behind the ideal outline.", kForms,
     [](const Measured& m) -> Value {
         return ofPart<Value>(m, &Deviation::outline, [](const OutlineDeviation& o) { return o.underMm.value; });
     },
     [](const Measured& m) -> Node {
         return ofPart<Node>(m, &Deviation::outline, [](const OutlineDeviation& o) { return worstOf(o.underMm); });
     }},
    {"beyond_ideal_mm", "mm",
     "Distance, seen from above, from the ideal outline to what was cut 0.2 mm deep or deeper outside it; 0.1 mm² are as "
     "far away, or farther.",
     kSturdevant,
     [](const Measured& m) -> Value {
         return ofDeviation(m, [](const Deviation& d) { return Value(d.beyondMm.value); });
     },
     [](const Measured& m) -> Node { return ofDeviation(m, [](const Deviation& d) { return worstOf(d.beyondMm); }); }},

    {"gingival_floor_error_mm", "mm",
     "Size of the error in height of a box's gingival floor that 95 percent of it stay within.", kForms,
     [](const Measured& m) -> Value {
         return ofPart<Value>(m, &Deviation::gingivalFloorErrorMm, [](const Placed& p) { return p.value; });
     },
     [](const Measured& m) -> Node { return ofPart<Node>(m, &Deviation::gingivalFloorErrorMm, worstOf); }},
    {"axial_depth_mm", "mm",
     "Mean distance from the surface of the uncut tooth to the axial wall of a box, at the level of the ideal's gingival "
     "floor.",
     kForms, [](const Measured& m) -> Value { return valueOf(inForm(m, &Form::axialDepthMm)); },
     [](const Measured& m) -> Node { return nodeOf(inForm(m, &Form::axialDepthMm)); }},
    {"axial_depth_error_mm", "mm", "Axial depth less that of the ideal, measured the same way.", kForms,
     [](const Measured& m) -> Value { return formError(m, &Form::axialDepthMm); },
     [](const Measured& m) -> Node { return nodeOf(inForm(m, &Form::axialDepthMm)); }},

    {"isthmus_width_mm", "mm", "Shortest run of cut across the isthmus; 0 where the cut is interrupted there.", kForms,
     [](const Measured& m) -> Value { return valueOf(inForm(m, &Form::isthmusMm)); },
     [](const Measured& m) -> Node { return nodeOf(inForm(m, &Form::isthmusMm)); }},
    {"isthmus_error_mm", "mm", "Isthmus width less that of the ideal, measured the same way.", kForms,
     [](const Measured& m) -> Value { return formError(m, &Form::isthmusMm); },
     [](const Measured& m) -> Node { return nodeOf(inForm(m, &Form::isthmusMm)); }},
    {"ridge_mesial_mm", "mm", "Least distance from the cut to the mesial surface of the tooth, between the cusps.", kForms,
     [](const Measured& m) -> Value { return valueOf(mesialRidge(m)); },
     [](const Measured& m) -> Node { return nodeOf(mesialRidge(m)); }},
    {"ridge_distal_mm", "mm", "Least distance from the cut to the distal surface of the tooth, between the cusps.", kForms,
     [](const Measured& m) -> Value { return valueOf(distalRidge(m)); },
     [](const Measured& m) -> Node { return nodeOf(distalRidge(m)); }},
    {"ridge_least_mm", "mm", "The thinner of the two marginal ridges left.", kForms,
     [](const Measured& m) -> Value { return valueOf(leastRidge(m)); },
     [](const Measured& m) -> Node { return nodeOf(leastRidge(m)); }},
    {"oblique_ridge_least_mm", "mm",
     "Narrowest width of the oblique ridge between the cuts on both sides of it; 0 where its crest is cut.", kForms,
     [](const Measured& m) -> Value { return valueOf(inForm(m, &Form::obliqueRidgeMm)); },
     [](const Measured& m) -> Node { return nodeOf(inForm(m, &Form::obliqueRidgeMm)); }},

    {"wall_angle_mesial_deg", "deg", "Angle of the mesial wall from upright; positive opens towards the occlusal.", kForms,
     [](const Measured& m) -> Value { return valueOf(namedWall(m, Side::MinusX)); },
     [](const Measured& m) -> Node { return nodeOf(namedWall(m, Side::MinusX)); }},
    {"wall_angle_distal_deg", "deg", "Angle of the distal wall from upright; positive opens towards the occlusal.", kForms,
     [](const Measured& m) -> Value { return valueOf(namedWall(m, Side::PlusX)); },
     [](const Measured& m) -> Node { return nodeOf(namedWall(m, Side::PlusX)); }},
    {"wall_angle_buccal_deg", "deg", "Angle of the buccal wall from upright; positive opens towards the occlusal.", kForms,
     [](const Measured& m) -> Value { return valueOf(wallAcross(m, 1)); },
     [](const Measured& m) -> Node { return nodeOf(wallAcross(m, 1)); }},
    {"wall_angle_lingual_deg", "deg", "Angle of the lingual wall from upright; positive opens towards the occlusal.",
     kForms, [](const Measured& m) -> Value { return valueOf(wallAcross(m, -1)); },
     [](const Measured& m) -> Node { return nodeOf(wallAcross(m, -1)); }},
    {"wall_angle_least_deg", "deg", "Angle of the most upright wall, whichever side it is on.", kForms,
     [](const Measured& m) -> Value { return valueOf(extremeWall(m, -1.0)); },
     [](const Measured& m) -> Node { return nodeOf(extremeWall(m, -1.0)); }},
    {"wall_angle_most_deg", "deg", "Angle of the wall that leans out most, whichever side it is on.", kForms,
     [](const Measured& m) -> Value { return valueOf(extremeWall(m, 1.0)); },
     [](const Measured& m) -> Node { return nodeOf(extremeWall(m, 1.0)); }},
    {"wall_angle_error_deg", "deg",
     "Largest difference between a wall's angle and that of the ideal on the same side, once half of the ideal is cut.",
     kForms, [](const Measured& m) -> Value { return valueOf(wallError(m)); },
     [](const Measured& m) -> Node { return nodeOf(wallError(m)); }},
    {"wall_roughness_mm", "mm",
     "Root mean square distance of the cut's outline from the ideal one, less its mean along 2 mm of the same wall.",
     kSturdevant,
     [](const Measured& m) -> Value {
         return ofPart<Value>(m, &Deviation::outline, [](const OutlineDeviation& o) { return o.roughnessMm.value; });
     },
     [](const Measured& m) -> Node {
         return ofPart<Node>(m, &Deviation::outline, [](const OutlineDeviation& o) { return o.roughnessMm.node; });
     }},

    {"floor_flatness_mm", "mm",
     "Root mean square distance of the floor from the ideal one, tilted and lifted to fit, once half of the ideal is cut.",
     kMetrics,
     [](const Measured& m) -> Value {
         const auto floor = formedFloor(m);
         return floor ? Value(floor->flatnessMm) : std::nullopt;
     },
     worstStep},
    {"floor_slope_deg", "deg", "Slope of most of the floor against the ideal one, once half of the ideal is cut.", kForms,
     [](const Measured& m) -> Value {
         const auto floor = formedFloor(m);
         return floor ? Value(floor->slopeDeg) : std::nullopt;
     },
     worstStep},
    {"floor_step_mm", "mm", "Largest step in the floor within 0.2 mm, once half of the ideal is cut.", kForms,
     [](const Measured& m) -> Value {
         const auto floor = formedFloor(m);
         return floor ? Value(floor->stepMm.value) : std::nullopt;
     },
     worstStep},
    {"floor_into_dentin_mm", "mm", "Mean depth of the pulpal floor below the enamel-dentin junction; negative in enamel.", kForms,
     [](const Measured& m) -> Value {
         return ofPart<Value>(m, &Deviation::floor, [](const FloorForm& f) { return f.intoDentinMm; });
     },
     nullptr},
    {"unsupported_enamel_mm3", "mm3", "Enamel left above decay, or whose rods stand on dentin that was cut away.",
     kForms,
     [](const Measured& m) -> Value {
         return ofPart<Value>(m, &Deviation::unsupportedEnamelMm3, [](const Placed& u) { return u.value; });
     },
     [](const Measured& m) -> Node {
         return ofPart<Node>(m, &Deviation::unsupportedEnamelMm3, worstOf);
     }},

    {"target_removed_percent", "percent", "Share of the target zone that was removed.", kPad,
     [](const Measured& m) -> Value {
         return ofDeviation(m, [](const Deviation& d) {
             return d.zones ? percent(d.zones->targetRemovedMm3, d.zones->targetMm3) : std::nullopt;
         });
     },
     [](const Measured& m) -> Node {
         return ofDeviation(m, [](const Deviation& d) { return d.zones ? d.zones->targetLeftNode : std::nullopt; });
     }},
    {"leeway_sides_removed_percent", "percent", "Share of the leeway beside the target that was removed.", kPad,
     [](const Measured& m) -> Value {
         return ofDeviation(m, [](const Deviation& d) {
             return d.zones ? percent(d.zones->leewaySidesRemovedMm3, d.zones->leewaySidesMm3) : std::nullopt;
         });
     },
     overNode},
    {"leeway_bottom_removed_percent", "percent", "Share of the leeway below the target that was removed.", kPad,
     [](const Measured& m) -> Value {
         return ofDeviation(m, [](const Deviation& d) {
             return d.zones ? percent(d.zones->leewayBottomRemovedMm3, d.zones->leewayBottomMm3) : std::nullopt;
         });
     },
     overNode},
    {"container_sides_mm3", "mm3", "What was removed beside target and leeway.", kPad,
     [](const Measured& m) -> Value {
         return ofPart<Value>(m, &Deviation::zones, [](const Zones& z) { return z.containerSidesMm3.value; });
     },
     [](const Measured& m) -> Node {
         return ofPart<Node>(m, &Deviation::zones, [](const Zones& z) { return worstOf(z.containerSidesMm3); });
     }},
    {"container_bottom_mm3", "mm3", "What was removed below target and leeway.", kPad,
     [](const Measured& m) -> Value {
         return ofPart<Value>(m, &Deviation::zones, [](const Zones& z) { return z.containerBottomMm3.value; });
     },
     [](const Measured& m) -> Node {
         return ofPart<Node>(m, &Deviation::zones, [](const Zones& z) { return worstOf(z.containerBottomMm3); });
     }},

    {"time_total_s", "s", "Time of the attempt, without what was spent away from the work.", kMetrics,
     [](const Measured& m) -> Value { return ofProcess(m, [](const Process& p) { return p.totalS; }); }, nullptr},
    {"time_to_first_cut_s", "s", "Time until material first came away.", kHapTel,
     [](const Measured& m) -> Value { return m.process ? m.process->firstCutS : std::nullopt; }, nullptr},
    {"time_cutting_s", "s", "Time that was spent in strokes.", kHapTel,
     [](const Measured& m) -> Value { return ofProcess(m, [](const Process& p) { return p.cuttingS; }); }, nullptr},
    {"longest_pause_s", "s", "Longest time without cutting between two strokes.", kMetrics,
     [](const Measured& m) -> Value { return ofProcess(m, [](const Process& p) { return p.longestPauseS; }); }, nullptr},
    {"path_mm", "mm", "Way of the bur's tip.", "docs/facts/teaching.md, section 1 (Suebnukarn 2014)",
     [](const Measured& m) -> Value { return ofProcess(m, [](const Process& p) { return p.pathMm; }); }, nullptr},
    {"path_cutting_mm", "mm", "Way of the bur's tip in strokes.", kMetrics,
     [](const Measured& m) -> Value { return ofProcess(m, [](const Process& p) { return p.cuttingPathMm; }); }, nullptr},
    {"strokes", "", "Number of strokes: stretches of cutting without a pause of 150 ms.",
     kStrokes,
     [](const Measured& m) -> Value { return ofProcess(m, [](const Process& p) { return p.strokes; }); }, nullptr},
    {"stroke_length_mean_mm", "mm", "Mean way of the bur's tip in a stroke.", kStrokes,
     [](const Measured& m) -> Value { return m.process ? m.process->strokeMm : std::nullopt; }, nullptr},
    {"stroke_time_mean_s", "s", "Mean time of a stroke.", kStrokes,
     [](const Measured& m) -> Value { return m.process ? m.process->strokeS : std::nullopt; }, nullptr},
    {"lift_offs", "", "Times that a bur which has cut left the tooth for 50 ms or longer.",
     kStrokes,
     [](const Measured& m) -> Value { return ofProcess(m, [](const Process& p) { return p.liftOffs; }); }, nullptr},
    {"force_mean_n", "N", "Mean force on the hand in contact.", "docs/facts/haptics.md, section 8.5",
     [](const Measured& m) -> Value {
         return m.process && m.process->force ? Value(m.process->force->meanN) : std::nullopt;
     },
     nullptr},
    {"force_sd_n", "N", "Standard deviation of the force on the hand in contact.", kMetrics,
     [](const Measured& m) -> Value {
         return m.process && m.process->force ? Value(m.process->force->sdN) : std::nullopt;
     },
     nullptr},
    {"force_p95_n", "N", "Force that is not passed in 95 percent of the time in contact.", kMetrics,
     [](const Measured& m) -> Value {
         return m.process && m.process->force ? Value(m.process->force->p95N) : std::nullopt;
     },
     nullptr},
    {"force_largest_n", "N", "Largest force on the hand in contact.", "docs/facts/haptics.md, section 8.5",
     [](const Measured& m) -> Value {
         return m.process && m.process->force ? Value(m.process->force->largestN) : std::nullopt;
     },
     nullptr},
    {"force_over_limit_s", "s", "Time in contact with more force than the limit of the lesson.", kMetrics,
     [](const Measured& m) -> Value { return ofProcess(m, [](const Process& p) { return p.overLimitS; }); }, nullptr},
    {"jerk_rms_mm_s3", "mm/s3", "Root mean square jerk of the hand while the drill is on, up to about 5 Hz.",
     "docs/facts/teaching.md, section 3 (Hogan and Sternad 2009)",
     [](const Measured& m) -> Value { return m.process ? m.process->jerkMmPerS3 : std::nullopt; }, nullptr},
    {"drill_in_air_s", "s", "Time with the drill on and no contact.", kMetrics,
     [](const Measured& m) -> Value { return ofProcess(m, [](const Process& p) { return p.drillInAirS; }); }, nullptr},
    {"contact_bur_off_s", "s", "Time in contact with the drill off.", kMetrics,
     [](const Measured& m) -> Value { return ofProcess(m, [](const Process& p) { return p.contactBurOffS; }); }, nullptr},
    {"undo_count", "", "Times that the tooth was put back to an earlier state.", kMetrics,
     [](const Measured& m) -> Value { return ofProcess(m, [](const Process& p) { return p.undos; }); }, nullptr},
    {"neighbour_hits", "", "Times that the turning bur touched a tooth beside.", kSturdevant,
     [](const Measured& m) -> Value { return m.neighbourHits; }, nullptr},
    {"infractions", "", "Breaches of the lesson's rules.", kMetrics,
     [](const Measured& m) -> Value { return m.infractions; }, nullptr},
    {"aids_used", "", "Aids that were used at any time: section, depth gauge, X-ray, heat map, mirror, ideal, colour of the bur, fixture.",
     kMetrics, [](const Measured& m) -> Value { return m.aidsUsed; }, nullptr},

    {"points_touched_percent", "percent", "Share of the points asked for that the bur touched with the drill off.",
     kFirstMinutes,
     [](const Measured& m) -> Value {
         return ofExercise<Touched>(m, [](const Touched& t) {
             return percent(static_cast<double>(t.count()), static_cast<double>(t.atS.size()));
         });
     },
     nullptr},
    {"time_to_touch_all_s", "s", "Time until the last of the points was touched; not measured before all are.",
     kFirstMinutes, [](const Measured& m) -> Value { return ofExercise<Touched>(m, allTouchedS); }, nullptr},
    {"hold_longest_s", "s", "Longest time at a stretch that the force was held, up to the time asked for.", kFirstMinutes,
     [](const Measured& m) -> Value { return ofExercise<Held>(m, [](const Held& h) { return h.longestS; }); }, nullptr},
    {"hold_within_percent", "percent", "Share of the time in contact, once the force was right, that it was held.",
     kFirstMinutes,
     [](const Measured& m) -> Value {
         return ofExercise<Held>(m, [](const Held& h) { return percent(h.heldS, h.pressedS); });
     },
     nullptr},
    {"hold_error_n", "N", "Mean distance from the force asked for in contact, once it was right.", kFirstMinutes,
     [](const Measured& m) -> Value {
         return ofExercise<Held>(m, [](const Held& h) { return h.pressedS > 0.0 ? Value(h.meanErrorN) : std::nullopt; });
     },
     nullptr},
    {"layers_named_percent", "percent", "Share of the pads whose tissue was named rightly, the answer given last.",
     kFirstMinutes,
     [](const Measured& m) -> Value {
         return ofExercise<Named>(m, [](const Named& n) {
             return percent(static_cast<double>(n.right), static_cast<double>(kPads));
         });
     },
     nullptr},
});

}  // namespace

std::span<const MeasureInfo> measureTable()
{
    return kTable;
}

std::optional<MeasureInfo> findMeasure(std::string_view id)
{
    const auto found = std::find_if(kTable.begin(), kTable.end(), [&](const MeasureInfo& row) { return row.id == id; });
    return found != kTable.end() ? std::optional(*found) : std::nullopt;
}

bool isOfExercise(const MeasureInfo& measure)
{
    Measured done;
    bool isTold = false;
    // An attempt has only one kind of exercise, so the table is tested with each.
    for (const Practised& practised : {Practised(Touched{{0.0}}), Practised(Held{1.0, 1.0, 1.0, 1.0, 0.0, true}),
                                       Practised(Named{{terrain::Material::Enamel}, 1})}) {
        done.practised = practised;
        isTold = isTold || measure.value(done).has_value();
    }
    return isTold && !measure.value(Measured{}).has_value();
}

bool isOfProcess(const MeasureInfo& measure)
{
    Process complete;
    complete.firstCutS = complete.strokeMm = complete.strokeS = complete.jerkMmPerS3 = 0.0;
    complete.force = Process::Force{};
    Measured way;
    way.process = complete;
    way.infractions = 0;
    way.neighbourHits = 0;
    way.aidsUsed = 0;
    return isOfExercise(measure) || (measure.value(way).has_value() && !measure.value(Measured{}).has_value());
}

}  // namespace core::grading
