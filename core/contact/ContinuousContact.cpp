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

constexpr int kMaxSlides = 3;          ///< positions tried in a tick; the next tick continues from there
constexpr double kAskMm = 0.15;        ///< motion of the hand before each search
constexpr double kStuckClimb = 0.5;    ///< most climb in the search of a stuck bur, cells a cell: it must not leave a
                                       ///< pocket
constexpr double kBehindMm = 0.1;      ///< a bur this near to the hand is not stuck
constexpr int kPatienceTicks = 2;      ///< ticks without progress before the pattern search, which does not use planes
constexpr int kMaxSideSlides = 5;      ///< like kMaxSlides along upright sides, whose planes are dropped after each
                                       ///< move
constexpr double kLongestShare = 0.5;  ///< of the radius, in one move, so that its end is inside any obstacle
/// Longest slide of the bur in a tick, in mm, and per mm that the hand moved. When a bur slips off a cusp while the
/// hand presses far into the tooth, it takes ten ticks for a millimetre, and so does its force.
constexpr double kSlipMm = 0.1;
constexpr double kSlipShare = 4.0;
constexpr double kRounding = 1.0e-6;    ///< mm: heights are floats
constexpr double kStillMm = 3.0e-4;     ///< a shorter move counts as none
constexpr double kSlackMm = 1.0e-5;     ///< a bur at most this far above the ground rests on it
constexpr double kNearMm = 0.002;       ///< distance at which ground stops a bur that moves on
constexpr double kSteepest = 20.0;      ///< ground that is steeper is an upright side
constexpr double kSmoothShare = 0.001;  ///< of a move: share of its start that a tangent plane may cut off
constexpr double kLiftShare = 0.1;      ///< of a move: largest share by which its end may be raised onto the ground
constexpr double kNearerMm2 = 1.0e-9;
constexpr int kHalvings = 10;           ///< steps of the bisection for the place where the bur met the tooth
constexpr double kGrazedMm = 0.005;     ///< a cutting bur that is deeper than this in an upright side is moved out
constexpr double kStrayedCells = 1.0;   ///< the same without cutting: the columns may extend beyond a side by this much
constexpr double kShorterShare = 0.25;  ///< share of a blocked way that is tried next
constexpr int kCornerLooks = 4;         ///< nearer and nearer places tried for what stops the bur at a corner
constexpr double kCornerShare = 0.25;   ///< of the path, to the next of them
constexpr double kCornerMm = 0.002;     ///< a bur that is behind a side by less counts as being in front of it
constexpr double kTouchedMm = 0.02;     ///< if the ground rose by less, the bur touched it but did not enter it
constexpr double kMostSettledMm = 0.3;  ///< largest distance by which a bur in a notch is raised or lowered to fit
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

/// Returns the plane that keeps a tip out of the tooth on its straight path from a free position `from` to `to`. On
/// smooth ground it is the tangent plane at `to`, otherwise the plane where the bur meets the point that supports it.
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

/// Returns whether a tip at `to` is stopped by a side that the tip at `from` is already behind. In that case the side
/// turns a corner between the two positions, and the tip meets the corner first.
bool isRoundCorner(const bur::BurMask& mask, const glm::dvec3& from, const glm::dvec3& to, const Touch& touch)
{
    if (!touch.isSide() || !(touch.heightMm > to.z + kRounding))
        return false;
    const double needs = mask.reachAt(std::max(0.0, touch.onMm.z - from.z));
    return glm::dot(glm::dvec2(from) - glm::dvec2(touch.onMm), touch.outwards) < needs - kCornerMm;
}

/// Returns whether a tip below the ground that supports it is free there, as under an overhang.
bool isFreeBeneath(LiveTooth& tooth, const Touch& touch, const glm::dvec3& tip) noexcept
{
    return !(touch.isSide() && touch.roofMm < tip.z) && tooth.undersideAt(glm::dvec2(tip), tip.z) >= tip.z;
}

/// Returns whether the straight path from the anchor to a free device is free.
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

/// Moves an anchor without tooth above it to the free position nearest to the device (god-object, Zilles & Salisbury
/// 1995, over the clearance field). Tries the nearest point in the half-spaces known so far. If the tooth is in the
/// way, the obstacle adds another half-space.
///
/// @param left    farthest motion in this tick, mm
/// @param ground  touchAt() the anchor; updated
/// @return false if every position tried was blocked: on rugged ground the half-spaces may leave no path although there
///         is one
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
            // Deep inside the tooth, the columns behind a side and its other parts are higher. The bur meets the
            // nearest part first.
            const Touch side = tooth.sideAt(glm::dvec2(next), std::max(anchor.z, next.z));
            if (side.isSide())
                met = side;
        }
        for (int k = 0; k < kCornerLooks && isRoundCorner(tooth.mask(), anchor, next, met); ++k) {
            next = anchor + (next - anchor) * kCornerShare;
            met = touch = tooth.touchAt(glm::dvec2(next), 1.0e9, edges);
        }
        const glm::dvec2 at(next);
        // The end of a move that was cut short is a little inside curved ground. It is raised onto the ground if that
        // is still nearer to the device.
        if (touch.heightMm > next.z && touch.heightMm - next.z <= kLiftShare * std::min(length, reach) &&
            distance2({at, touch.heightMm}, device) < best - kNearerMm2)
            next.z = touch.heightMm;
        if (touch.heightMm > next.z + kRounding) {
            if (isFreeBeneath(tooth, touch, next)) {  // the path under an overhang is free
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
        // A plane that keeps the tip above the ground is tangent to a hump that the tip has left, and excludes free
        // space. So does a plane of a side whose end the tip may have reached.
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
/// the columns. An anchor that is deeper inside, or came from below, collides only with the columns of the side in this
/// tick. While the bur cuts, the limit is smaller.
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
            // After an undo or a change of the bur, moves the anchor out upwards, which is always free.
            m_anchor.z = std::max(device.z, ground.heightMm);
        } else {
            // The anchor was free a tick ago and still is in all columns, except for a rim that cutting will remove.
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
    // While the bur cuts, the cut determines its position.
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
    // Planes deep inside the tooth do not help along the path, and planes too near do not reach past an edge. So ticks
    // alternate between the two.
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
