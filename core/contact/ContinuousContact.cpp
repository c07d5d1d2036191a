// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/ContinuousContact.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/contact/HalfSpaces.h"
#include "core/contact/Lengths.h"
#include "core/contact/PatternSearch.h"

namespace core::contact {
namespace {

constexpr int kMaxSlides = 3;        ///< places looked at in a tick; the next tick goes on from there
constexpr double kAskMm = 0.15;      ///< that the hand goes before the search is asked, and again before the next time
constexpr double kStuckClimb = 0.5;  ///< cells a cell: out of a pocket there is no way
constexpr double kBehindMm = 0.1;    ///< a bur this near to the hand is not stuck
constexpr int kPatienceTicks = 2;    ///< without a way: then the search that knows no planes finds one
constexpr int kMaxSideSlides = 5;    ///< the same along upright sides, whose planes are forgotten after each move
constexpr double kLongestShare = 0.5;  ///< of the radius, in one move: it ends inside whatever it would pass through
/// Farthest that the bur slides in a tick: a bur that slips off a cusp under a hand that presses far into the tooth
/// takes ten ticks for a millimetre, and the force with it. In mm, and per mm that the hand moved.
constexpr double kSlipMm = 0.1;
constexpr double kSlipShare = 4.0;
constexpr double kRounding = 1.0e-6;    ///< mm: heights are floats
constexpr double kStillMm = 3.0e-4;     ///< a move shorter than that is none
constexpr double kSlackMm = 1.0e-5;     ///< a bur this far above the ground stands on it
constexpr double kNearMm = 0.002;       ///< ground this near is what stops a bur that moves on
constexpr double kSteepest = 20.0;      ///< ground steeper than that is an upright side
constexpr double kSmoothShare = 0.001;  ///< of a move, by which a tangent plane may cut off the place it began at
constexpr double kLiftShare = 0.1;      ///< of a move, by which its end is lifted onto the ground at most
constexpr double kNearerMm2 = 1.0e-9;
constexpr int kHalvings = 10;           ///< in looking for the place where the bur met the tooth
constexpr double kGrazedMm = 0.005;     ///< depth in an upright side that is put right and no more
constexpr double kStrayedCells = 1.0;   ///< the same where nothing is cut: so far behind a side its columns may stand
constexpr double kShorterShare = 0.25;  ///< of a way that led nowhere, so far is looked next
constexpr int kCornerLooks = 4;         ///< at nearer and nearer places, for what stops the bur at a corner
constexpr double kCornerShare = 0.25;   ///< of the way, to the next of them
constexpr double kCornerMm = 0.002;     ///< what stands behind a side by less stands before it
constexpr double kTouchedMm = 0.02;     ///< ground that came up by no more was touched, not entered
constexpr double kMostSettledMm = 0.3;  ///< most that a bur in a notch is lifted or lowered to fit
constexpr int kMaxFreeSamples = 128;    ///< points looked at along a move through the air

HalfSpace through(const glm::dvec3& point, const glm::dvec3& upwards)
{
    const glm::dvec3 normal = upwards / std::sqrt(glm::dot(upwards, upwards));
    return {normal, glm::dot(normal, point)};
}

/// What the ground over a point lets the tip have, as its tangent plane.
HalfSpace tangentAt(glm::dvec2 at, const Touch& touch)
{
    return through({at, touch.heightMm}, {-touch.slope, 1.0});
}

/// True if a bur on its way meets a side with its own upright one, not with its end.
bool isBeside(const bur::BurMask& mask, const glm::dvec3& from, const glm::dvec3& to, const Touch& side)
{
    return side.onMm.z - std::max(from.z, to.z) >= mask.sideMm;
}

/// The plane that keeps a tip at `from`, which is free, out of what it would enter on its straight way to `to`: the
/// tangent at `to` where the ground is smooth, else where the bur meets the point that carries it.
HalfSpace planeBetween(const bur::BurMask& mask, const glm::dvec3& from, const glm::dvec3& to, const Touch& touch)
{
    const auto radiusMm = static_cast<double>(mask.radiusMm);
    if (touch.isSide() && isBeside(mask, from, to, touch))
        return {{touch.outwards, 0.0}, glm::dot(glm::dvec2(touch.onMm), touch.outwards) + radiusMm + kSlackMm};
    const HalfSpace tangent = tangentAt(glm::dvec2(to), touch);
    const glm::dvec3 way = to - from;
    const double length = std::sqrt(glm::dot(way, way));
    if (glm::dot(tangent.normal, from) >= tangent.offset - kRounding - kSmoothShare * length)
        return tangent;
    const auto radiusAt = [&](const glm::dvec3& tip) {
        const glm::dvec2 apart = glm::dvec2(tip) - glm::dvec2(touch.onMm);
        return touch.isSide() ? std::max(0.0, glm::dot(apart, touch.outwards)) : std::sqrt(glm::dot(apart, apart));
    };
    const auto meets = [&](const glm::dvec3& tip) {
        const double r = radiusAt(tip);
        return r < radiusMm && tip.z + mask.heightAt(r) < touch.onMm.z;
    };
    double free = 0.0;
    double met = 1.0;
    for (int k = 0; k < kHalvings; ++k) {
        const double middle = 0.5 * (free + met);
        (meets(from + way * middle) ? met : free) = middle;
    }
    const glm::dvec3 entry = from + way * free;
    const double r = radiusAt(entry);
    glm::dvec2 outwards = touch.outwards;
    if (!touch.isSide() && r > 0.0)
        outwards = (glm::dvec2(entry) - glm::dvec2(touch.onMm)) / r;
    const double slope = std::max(touch.rise, mask.slopeAt(std::min(r, radiusMm)));
    if (r > 0.0 && (slope > kSteepest || r >= radiusMm))
        return through(entry, {outwards, 0.0});
    // The top of a side may slope along it.
    const glm::dvec2 along =
        touch.isSide() ? touch.slope - touch.outwards * glm::dot(touch.slope, touch.outwards) : glm::dvec2(0.0);
    return through(entry, {outwards * slope - along, 1.0});
}

/// True if a tip at `to` is stopped by a side that the tip at `from` already stands behind: the side goes round a
/// corner between them, and it is the corner that stops the tip first.
bool isRoundCorner(const bur::BurMask& mask, const glm::dvec3& from, const glm::dvec3& to, const Touch& touch)
{
    if (!touch.isSide() || !(touch.heightMm > to.z + kRounding))
        return false;
    const double needs = mask.reachAt(std::max(0.0, touch.onMm.z - from.z));
    return glm::dot(glm::dvec2(from) - glm::dvec2(touch.onMm), touch.outwards) < needs - kCornerMm;
}

/// True if a tip that is below what carries it is free beneath.
bool isFreeBeneath(LiveTooth& tooth, const Touch& touch, const glm::dvec3& tip) noexcept
{
    return !(touch.isSide() && touch.roofMm < tip.z) && tooth.undersideAt(glm::dvec2(tip), tip.z) >= tip.z;
}

/// True if the straight way from the anchor to a free device meets nothing.
bool wayIsFree(LiveTooth& tooth, Edges edges, const glm::dvec3& from, const glm::dvec3& to) noexcept
{
    const glm::dvec2 flat(to.x - from.x, to.y - from.y);
    const double length = std::sqrt(glm::dot(flat, flat));
    const int samples = static_cast<int>(length / (kLongestShare * static_cast<double>(tooth.mask().radiusMm))) + 1;
    if (samples > kMaxFreeSamples)
        return false;
    for (int k = 1; k <= samples; ++k) {
        const double share = static_cast<double>(k) / samples;
        const double z = from.z + (to.z - from.z) * share;
        if (tooth.isAbove({from.x + flat.x * share, from.y + flat.y * share}, z, edges))
            return false;
    }
    return true;
}

/// Slides an anchor that has no tooth above it to the nearest place to the device (god-object, Zilles & Salisbury
/// 1995, over the clearance field): ask for the nearest point in the half-spaces known so far, go there; if the tooth
/// is in the way, what it is met by is one half-space more.
///
/// @param left    how far it may get in this tick, mm
/// @param ground  touchAt() the anchor, and so again in the end
/// @return false if it got nowhere because every place that it looked at was taken: on rugged ground the half-spaces
/// may leave no way where there is one
bool slide(LiveTooth& tooth, Edges edges, const glm::dvec3& device, double left, Touch& ground,
           glm::dvec3& anchor) noexcept
{
    HalfSpaces planes;
    const double steep2 = glm::dot(ground.slope, ground.slope);
    if (steep2 < kSteepest * kSteepest && anchor.z <= ground.heightMm + kNearMm * std::sqrt(1.0 + steep2))
        planes.add(tangentAt(glm::dvec2(anchor), ground));
    const double longest = kLongestShare * static_cast<double>(tooth.mask().radiusMm);
    double best = distance2(anchor, device);
    bool metSide = false;
    bool hasMoved = false;
    // A hand that goes far in a tick, at a slow rate, is followed by more moves.
    const int more = static_cast<int>(left / (kSlipShare * longest));
    int most = kMaxSlides + more;
    for (int looks = 0; looks < most; ++looks) {
        glm::dvec3 next{0.0};
        if (!planes.nearest(device, next))
            return hasMoved;
        const glm::dvec3 move = next - anchor;
        const double length = std::sqrt(glm::dot(move, move));
        if (length < kStillMm)
            return true;
        const double reach = std::min(longest, left);
        if (length > reach)
            next = anchor + move * (reach / length);
        if (distance2(next, device) >= best)
            return true;
        Touch touch = tooth.touchAt(glm::dvec2(next), 1.0e9, edges);
        Touch met = touch;
        if (edges == Edges::Sides && touch.heightMm > next.z + kRounding) {
            // Far in, the columns behind a side and its other parts stand higher: the nearest part is met first.
            const Touch side = tooth.sideAt(glm::dvec2(next), std::max(anchor.z, next.z));
            if (side.isSide())
                met = side;
        }
        for (int k = 0; k < kCornerLooks && isRoundCorner(tooth.mask(), anchor, next, met); ++k) {
            next = anchor + (next - anchor) * kCornerShare;
            met = touch = tooth.touchAt(glm::dvec2(next), 1.0e9, edges);
        }
        const glm::dvec2 at(next);
        // A move cut short ends a little inside ground that bends: up onto it, if that is still nearer.
        if (touch.heightMm > next.z && touch.heightMm - next.z <= kLiftShare * std::min(length, reach) &&
            distance2({at, touch.heightMm}, device) < best - kNearerMm2)
            next.z = touch.heightMm;
        if (touch.heightMm > next.z + kRounding) {
            if (isFreeBeneath(tooth, touch, next)) {  // the way under an overhang is open
                anchor = next;
                ground = touch;
                return true;
            }
            planes.add(planeBetween(tooth.mask(), anchor, next, met));
            if (met.isSide()) {
                metSide = true;
                most = kMaxSideSlides + more;
            }
            continue;
        }
        // Planes that hold the tip off the ground are tangents of a hump that it has left: they cut off what is free.
        // So does a side that it may have come to the end of.
        if (next.z > touch.heightMm + kSlackMm || metSide)
            planes.clear();
        metSide = false;
        const glm::dvec3 from = anchor;
        anchor = {at, std::max(next.z, touch.heightMm)};
        ground = touch;
        best = distance2(anchor, device);
        left -= std::sqrt(distance2(from, anchor));
        hasMoved = true;
        if (left < kStillMm)
            return true;
        if (touch.heightMm > static_cast<double>(terrain::kEmptyTop) &&
            glm::dot(touch.slope, touch.slope) < kSteepest * kSteepest)
            planes.add(tangentAt(at, touch));
    }
    return hasMoved;
}

}  // namespace

void ContinuousContact::moveTo(const glm::dvec3& anchor) noexcept
{
    m_anchor = anchor;
}

void ContinuousContact::restart(const glm::dvec3& device) noexcept
{
    m_anchor = device;
    m_device = device;
    m_mayBeInside = true;
    m_known.tooth = nullptr;
    m_blockedTicks = 0;
}

/// Puts an anchor right that grazes an upright side, as where two chords meet, or has strayed into one by a way that
/// went by the columns. One that is in it by more, or cuts, or came from beneath: for this tick the side is its
/// columns.
/// @param ground  at the anchor, sides included; brought up to date
Edges ContinuousContact::standClear(LiveTooth& tooth, Touch& ground) noexcept
{
    if (!ground.isSide() || ground.heightMm <= m_anchor.z + kRounding)
        return Edges::Sides;
    const double reach = tooth.mask().reachAt(std::max(0.0, ground.onMm.z - m_anchor.z));
    const glm::dvec2 apart = glm::dvec2(m_anchor) - glm::dvec2(ground.onMm);
    const double depth = reach - glm::dot(apart, ground.outwards);
    const bool isCutting = m_revision != tooth.revision();
    if (ground.roofMm < m_anchor.z && depth <= (isCutting ? kGrazedMm : kStrayedCells * tooth.grid().cellMm)) {
        const glm::dvec2 aside = glm::dvec2(m_anchor) + ground.outwards * (depth + kSlackMm);
        const Touch there = tooth.touchAt(aside, 1.0e9, Edges::Sides);
        if (there.heightMm <= m_anchor.z + kRounding) {
            m_anchor = {aside, m_anchor.z};
            ground = there;
            return Edges::Sides;
        }
    }
    ground = tooth.touchAt(glm::dvec2(m_anchor));
    return Edges::Columns;
}

glm::dvec3 ContinuousContact::update(LiveTooth& tooth, const glm::dvec3& device) noexcept
{
    const glm::dvec3 moved = device - m_device;
    m_device = device;
    Touch ground =
        m_known.isOf(tooth, m_anchor) ? m_known.touch : tooth.touchAt(glm::dvec2(m_anchor), 1.0e9, Edges::Sides);
    m_known.tooth = nullptr;
    const Edges edges = standClear(tooth, ground);
    if (wayIsFree(tooth, edges, m_anchor, device)) {
        m_anchor = device;
        m_mayBeInside = false;
        return m_anchor;
    }

    double left = kSlipMm + kSlipShare * std::sqrt(glm::dot(moved, moved));
    bool inNotch = false;
    bool underRoof = false;
    if (ground.heightMm > m_anchor.z + kRounding) {
        const double roof = tooth.undersideAt({m_anchor.x, m_anchor.y});
        underRoof = roof >= m_anchor.z - kRounding;
        if (underRoof) {
            m_anchor.z = std::min(device.z, roof);
        } else if (m_mayBeInside || ground.heightMm <= m_anchor.z + kTouchedMm) {
            // Undo, or another bur: out by the way that is always open.
            m_anchor.z = std::max(device.z, ground.heightMm);
        } else {
            // It was free a tick ago and still is, column by column, or all but a rim that cutting will take.
            inNotch = true;
            const Room room = tooth.roomAt({m_anchor.x, m_anchor.y}, m_anchor.z);
            const double z = std::clamp(m_anchor.z, room.floorMm, std::max(room.floorMm, room.roofMm));
            if (room.floorMm <= room.roofMm && std::abs(z - m_anchor.z) <= kMostSettledMm)
                m_anchor.z = std::clamp(device.z, room.floorMm, room.roofMm);
        }
    } else {
        const double z = std::max({device.z, ground.heightMm, m_anchor.z - left});
        left -= std::max(0.0, m_anchor.z - z);
        m_anchor.z = z;
    }
    m_mayBeInside = false;
    // A bur that cuts is where it is because it cuts.
    if (m_revision != tooth.revision())
        m_blockedTicks = 0;
    m_revision = tooth.revision();
    if (m_blockedTicks == 0)
        m_askedFrom = device;
    const bool isStuck = m_blockedTicks > kPatienceTicks && distance2(device, m_askedFrom) > kAskMm * kAskMm;
    if (isStuck)
        m_askedFrom = device;
    if (underRoof || inNotch) {
        const glm::dvec3 before = m_anchor;
        searchAround(tooth, device, std::sqrt(glm::dot(moved, moved)), {inNotch, isStuck}, m_anchor);
        const bool isBehind = distance2(m_anchor, device) > kBehindMm * kBehindMm;
        m_blockedTicks = m_anchor == before && isBehind ? m_blockedTicks + 1 : 0;
        return m_anchor;
    }
    // Far inside the tooth nothing is learnt of the way along it, and too near one does not see over an edge: by turns.
    if (m_blockedTicks % 2 == 1)
        left *= kShorterShare;
    const bool isBlocked = !slide(tooth, edges, device, left, ground, m_anchor);
    m_blockedTicks = isBlocked ? m_blockedTicks + 1 : 0;
    if (isBlocked && isStuck)
        searchAround(tooth, device, std::sqrt(glm::dot(moved, moved)), {false, true, kStuckClimb}, m_anchor);
    else if (edges == Edges::Sides)
        m_known = {&tooth, tooth.revision(), glm::dvec2(m_anchor), ground};
    return m_anchor;
}

}  // namespace core::contact
