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

constexpr int kMaxSlides = 3;          ///< places tried in a tick; the next tick continues from there
constexpr double kAskMm = 0.15;        ///< motion of the hand before the search is tried, and before it is tried again
constexpr double kStuckClimb = 0.5;    ///< most climb in the search of a stuck bur, cells a cell: it must not leave a
                                       ///< pocket
constexpr double kBehindMm = 0.1;      ///< a bur this near to the hand is not stuck
constexpr int kPatienceTicks = 2;      ///< ticks without progress before the pattern search, which needs no planes
constexpr int kMaxSideSlides = 5;      ///< like kMaxSlides along upright sides, whose planes are dropped after each
                                       ///< move
constexpr double kLongestShare = 0.5;  ///< of the radius, in one move: so the end of the move is inside any obstacle
/// Farthest that the bur slides in a tick. A bur that slips off a cusp under a hand that presses far into the tooth
/// takes ten ticks for a millimetre, and so does its force. In mm, and per mm that the hand moved.
constexpr double kSlipMm = 0.1;
constexpr double kSlipShare = 4.0;
constexpr double kRounding = 1.0e-6;    ///< mm: heights are floats
constexpr double kStillMm = 3.0e-4;     ///< a shorter move counts as none
constexpr double kSlackMm = 1.0e-5;     ///< a bur at most this far above the ground rests on it
constexpr double kNearMm = 0.002;       ///< ground this near stops a bur that moves on
constexpr double kSteepest = 20.0;      ///< steeper ground is an upright side
constexpr double kSmoothShare = 0.001;  ///< of a move: a tangent plane may cut off its start by so much
constexpr double kLiftShare = 0.1;      ///< of a move: its end is raised onto the ground by at most so much
constexpr double kNearerMm2 = 1.0e-9;
constexpr int kHalvings = 10;           ///< steps of the bisection for the place where the bur met the tooth
constexpr double kGrazedMm = 0.005;     ///< depth in an upright side out of which a cutting bur is moved
constexpr double kStrayedCells = 1.0;   ///< the same without a cut: the columns may reach so far beyond a side
constexpr double kShorterShare = 0.25;  ///< share of a blocked way that is tried next
constexpr int kCornerLooks = 4;         ///< nearer and nearer places tried for what stops the bur at a corner
constexpr double kCornerShare = 0.25;   ///< of the way, to the next of them
constexpr double kCornerMm = 0.002;     ///< a bur behind a side by no more counts as before it
constexpr double kTouchedMm = 0.02;     ///< ground that rose by no more was touched, not entered
constexpr double kMostSettledMm = 0.3;  ///< a bur in a notch is raised or lowered by at most so much to fit
constexpr int kMaxFreeSamples = 128;    ///< points checked along a move through the air

HalfSpace through(const glm::dvec3& point, const glm::dvec3& upwards)
{
    const glm::dvec3 normal = upwards / std::sqrt(glm::dot(upwards, upwards));
    return {normal, glm::dot(normal, point)};
}

/// Returns the half-space of free tip positions above the tangent plane of the ground.
HalfSpace tangentAt(glm::dvec2 at, const Touch& touch)
{
    return through({at, touch.heightMm}, {-touch.slope, 1.0});
}

/// Returns whether a bur meets a side with its own upright side and not with its end.
bool isBeside(const bur::BurMask& mask, const glm::dvec3& from, const glm::dvec3& to, const Touch& side)
{
    return side.onMm.z - std::max(from.z, to.z) >= mask.sideMm;
}

/// Returns the plane that keeps a tip out of the tooth on its straight way from a free place `from` to `to`. On smooth
/// ground it is the tangent plane at `to`, otherwise the plane where the bur meets the point that carries it.
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

/// Returns whether a tip at `to` is stopped by a side that the tip at `from` is already behind. Then the side turns a
/// corner between them, and the corner stops the tip first.
bool isRoundCorner(const bur::BurMask& mask, const glm::dvec3& from, const glm::dvec3& to, const Touch& touch)
{
    if (!touch.isSide() || !(touch.heightMm > to.z + kRounding))
        return false;
    const double needs = mask.reachAt(std::max(0.0, touch.onMm.z - from.z));
    return glm::dot(glm::dvec2(from) - glm::dvec2(touch.onMm), touch.outwards) < needs - kCornerMm;
}

/// Returns whether a tip below the ground that carries it is free beneath.
bool isFreeBeneath(LiveTooth& tooth, const Touch& touch, const glm::dvec3& tip) noexcept
{
    return !(touch.isSide() && touch.roofMm < tip.z) && tooth.undersideAt(glm::dvec2(tip), tip.z) >= tip.z;
}

/// Returns whether the straight way from the anchor to a free device is free.
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

/// Moves an anchor that has no tooth above it to the nearest free place to the device (god-object, Zilles & Salisbury
/// 1995, over the clearance field). The nearest point in the half-spaces known so far is tried. If the tooth is in the
/// way, the obstacle adds another half-space.
///
/// @param left    farthest motion in this tick, mm
/// @param ground  touchAt() the anchor; updated
/// @return false if every place tried was taken: on rugged ground the half-spaces may leave no way although there is
/// one
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
    // If the hand moves far in a tick, at a slow rate, more moves follow it.
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
            // Deep inside, the columns behind a side and its other parts are higher. The nearest part is met first.
            const Touch side = tooth.sideAt(glm::dvec2(next), std::max(anchor.z, next.z));
            if (side.isSide())
                met = side;
        }
        for (int k = 0; k < kCornerLooks && isRoundCorner(tooth.mask(), anchor, next, met); ++k) {
            next = anchor + (next - anchor) * kCornerShare;
            met = touch = tooth.touchAt(glm::dvec2(next), 1.0e9, edges);
        }
        const glm::dvec2 at(next);
        // A move cut short ends a little inside curved ground. It is raised onto the ground if that is still nearer.
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
        // Planes that hold the tip off the ground are tangents of a hump that it has left, and cut off free space. So
        // do planes of a side whose end the tip may have reached.
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

/// Moves an anchor out of an upright side that it grazes, for example where two chords meet, or that it entered through
/// the columns. An anchor that is deeper inside or came from below meets only the columns of the side in this tick.
/// While the bur cuts, the limit is smaller.
/// @param ground  at the anchor, sides included; updated
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
            // After an undo or a change of the bur: out upwards, which is always free.
            m_anchor.z = std::max(device.z, ground.heightMm);
        } else {
            // The anchor was free a tick ago and still is, column by column, except for a rim that cutting will remove.
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
    // While the bur cuts, cutting decides its place.
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
    // Planes deep inside the tooth do not help along the way, and planes too near do not reach past an edge. So both
    // are tried in turn.
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
