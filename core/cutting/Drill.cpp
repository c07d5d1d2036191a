// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cutting/Drill.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <span>

#include <glm/geometric.hpp>

#include "core/contact/BurHead.h"

namespace core::cutting {
namespace {

/// Largest number of tries to find the advance. It is found when the removal uses 95 to 100 % of the granted time. The
/// rest of the time is added to the next tick.
constexpr int kMaxTries = 6;
constexpr double kMostExcess = 8.0;      ///< times the granted time: a needed time beyond that counts as this much
constexpr double kFarther = 4.0;         ///< as a multiple of the last advance tried
constexpr double kFirstGuessMm = 0.001;  ///< advance tried first in fresh material
constexpr double kTightMm = 0.0005;      ///< if the bracket is narrower, it contains a wall and not the advance
constexpr double kCloseEnough = 0.95;
constexpr double kAim = 0.975;  ///< of the granted time: target while no upper end is known
/// Share of the path of a column. Below it, the material does not yield to the force.
constexpr double kLeastShare = 1.0e-6;
constexpr double kRoundingMm = 1.0e-5;  ///< heights are floats
constexpr double kRoundingCells = 1.0e-3;
/// Seconds per mm3 of a material that does not yield to the force.
constexpr double kNever = 1.0e30;
/// Impulse, N s, up to which a contact is only a brush. A contact of 0.3 N for 20 ms must leave no mark (dentists,
/// 2011). With only a threshold of force, the tip of a ball would leave a mark 30 um deep.
constexpr double kBrushNS = 0.008;

/// One advance of the bur: the tooth, the start of the tip, and copies of the columns that the bur may meet.
struct Advance
{
    contact::LiveTooth& tooth;
    double beginZ;
    std::span<contact::Columns> columns;

    [[nodiscard]] contact::BurHead headAt(const glm::dvec3& tip) const noexcept
    {
        const glm::dvec2 at = tooth.grid().latticeOf({tip.x, tip.y});
        return contact::headAt(tooth.mask(), tooth.grid().cellMm, at.x, at.y);
    }
    [[nodiscard]] contact::Descent descentTo(const glm::dvec3& tip) const noexcept
    {
        return {static_cast<float>(tip.z), static_cast<float>(std::max(tip.z, beginZ))};
    }

    /// Copies the columns that a bur may lower when it moves from `from` towards `towards` by up to `reachMm`. Misses
    /// none, but may copy more than needed. Returns false if there are too many.
    bool collect(const glm::dvec3& from, const glm::dvec3& towards, double reachMm) noexcept
    {
        const double sideways = reachMm * std::sqrt(towards.x * towards.x + towards.y * towards.y);
        const double radius = static_cast<double>(tooth.mask().radiusMm) + sideways;
        // (r - sideways)^2 is at least r^2 - 2 radius sideways everywhere in the circle, so no column needs a square
        // root.
        const contact::Reach reach{radius / tooth.grid().cellMm + kRoundingCells,
                                   static_cast<float>(2.0 * radius * sideways + kRoundingMm),
                                   static_cast<float>(from.z + std::min(0.0, reachMm * towards.z) - kRoundingMm)};
        const std::span<contact::Columns> room = tooth.columnsRoom();
        const std::size_t count = tooth.kernels().columnsUnder(tooth.view(), headAt(from), reach, room);
        if (count > room.size())
            return false;
        columns = room.first(count);
        return true;
    }

    /// Returns the time to remove the material under a bur with its tip at `tip`.
    [[nodiscard]] double secondsTo(const glm::dvec3& tip, const contact::RemovalTimes& secondsPerMm3) const noexcept
    {
        return tooth.kernels().secondsToRemove(columns, headAt(tip), descentTo(tip), secondsPerMm3);
    }

    /// Lowers the copy of every column that a bur with its tip at `tip` would lower, by a share of the path, and adds
    /// the removed volume to `done`.
    void removeTo(const glm::dvec3& tip, float share, Cut& done) const noexcept
    {
        tooth.kernels().remove(columns, headAt(tip), descentTo(tip), share, done.removedMm3);
    }

    /// Lowers the tooth to the copies, and returns the rectangle of the changes.
    [[nodiscard]] CutRect giveBack() const noexcept
    {
        CutRect rect;
        for (const contact::Columns& eight : columns) {
            if (eight.lowered == 0)
                continue;
            tooth.take(eight);
            const int first = eight.i + std::countr_zero(eight.lowered);
            const int last = eight.i + std::bit_width(eight.lowered) - 1;
            if (rect.isEmpty())
                rect = {first, eight.j, last, eight.j};
            rect = {std::min(rect.i0, first), std::min(rect.j0, eight.j), std::max(rect.i1, last),
                    std::max(rect.j1, eight.j)};
        }
        if (!rect.isEmpty())
            tooth.refreshBlocks(rect.i0, rect.j0, rect.i1, rect.j1);
        return rect;
    }
};

}  // namespace

Drill::Drill(const settings::HardnessPreset& preset, const settings::Handpiece& handpiece) noexcept
    : m_preset(preset), m_handpiece(handpiece)
{}

/// Returns the time that each material takes to remove when the bur is pushed with `forceN` newtons in the direction
/// `towards`.
contact::RemovalTimes Drill::removalTimes(const contact::LiveTooth& tooth, const glm::dvec3& towards,
                                          double forceN) const noexcept
{
    const double sideways = std::sqrt(towards.x * towards.x + towards.y * towards.y);
    const double share = m_preset.shareOfEnd(bur::isFlatEnd(tooth.mask().flatMm));
    const double direction = share + (1.0 - share) * sideways;
    const auto radiusMm = static_cast<double>(tooth.mask().radiusMm);
    const auto speedAt = [&](double newtons) { return rpmUnder(newtons, radiusMm) * radiusMm / kReferenceRpmMm; };
    const auto secondsOf = [&](const settings::MaterialHardness& hardness) {
        const double rate = paceMm3PerS(m_preset, hardness, forceN, direction, speedAt);
        return rate > 0.0 ? 1.0 / rate : kNever;
    };
    contact::RemovalTimes secondsPerMm3;
    for (std::size_t m = 0; m < secondsPerMm3.ofMaterial.size(); ++m)
        secondsPerMm3.ofMaterial[m] = secondsOf(m_preset.material[m]);
    if (m_preset.decayZones && tooth.tooth().anatomy->hasDecayZones) {
        secondsPerMm3.hasDecayZones = true;
        secondsPerMm3.leatheryDecay = secondsOf(m_preset.decayZones->leathery);
        secondsPerMm3.firmDecay = secondsOf(m_preset.decayZones->firm);
    }
    return secondsPerMm3;
}

Cut Drill::cut(contact::LiveTooth& tooth, const glm::dvec3& anchor, const glm::dvec3& device, double forceN,
               double seconds) noexcept
{
    assert(forceN >= 0.0 && seconds >= 0.0);
    Cut done;
    done.tipMm = anchor;
    const glm::dvec3 pull = device - anchor;
    const double gap = std::sqrt(glm::dot(pull, pull));
    m_pressedNS = std::min(kBrushNS, m_pressedNS + forceN * seconds);
    if (!(gap > 0.0) || m_pressedNS < kBrushNS)
        return done;
    const glm::dvec3 towards = pull / gap;
    const contact::RemovalTimes secondsPerMm3 = removalTimes(tooth, towards, forceN);

    // The time that the removal takes increases with the advance. The advance is bracketed, starting from the speed of
    // the last tick, and then found by false position. If one end does not move, its value is halved (Illinois).
    const double granted = seconds + m_leftS;
    const double aim = kAim * granted;
    double near = 0.0;
    double nearLack = granted;
    double far = -1.0;  // no upper end is known yet
    double farNeeded = 0.0;
    double farExcess = 0.0;
    double spent = 0.0;
    double tried = std::min(gap, std::max(m_lastMmPerS * aim, kFirstGuessMm));
    int side = 0;
    double listed = -1.0;  // the list holds the columns up to this advance
    Advance advance{tooth, anchor.z, {}};
    for (int attempt = 0; attempt < kMaxTries; ++attempt) {
        if (tried > listed) {
            listed = std::min(gap, 2.0 * tried);
            while (!advance.collect(anchor, towards, listed))
                listed *= 0.5;  // the bur moves too far sideways, so half the path is used
            tried = std::min(tried, listed);
        }
        const double needed = advance.secondsTo(anchor + towards * tried, secondsPerMm3);
        if (needed <= granted) {
            near = tried;
            spent = needed;
            nearLack = granted - spent;
            if (near >= gap || spent >= kCloseEnough * granted)
                break;
            if (side == 1)
                farExcess *= 0.5;
            side = 1;
        } else {
            far = tried;
            farNeeded = needed;
            farExcess = std::min(needed, kMostExcess * granted) - granted;
            if (side == -1)
                nearLack *= 0.5;
            side = -1;
        }
        if (far > 0.0 && far - near < kTightMm)
            break;
        if (far > 0.0)
            tried = near + (far - near) * std::clamp(nearLack / (nearLack + farExcess), 0.02, 0.98);
        else
            tried = std::min(gap, tried * std::min(kFarther, needed > 0.0 ? aim / needed : kFarther));
    }
    // A tick that removed hardly any material says nothing about the speed of the next.
    m_lastMmPerS = spent > 0.0 ? near / std::max(spent, 0.5 * granted) : far > 0.0 ? far / farNeeded : 0.0;
    done.tipMm = anchor + towards * near;
    if (spent > 0.0)
        advance.removeTo(done.tipMm, 1.0F, done);

    // When the rim of the bur reaches a column of a high wall, that column may need more than a tick. No advance then
    // uses up the time. So the columns just beyond are lowered by the share of their path that fits the time.
    if (far > 0.0 && spent < kCloseEnough * granted) {
        const glm::dvec3 beyond = anchor + towards * far;
        const double part = (granted - spent) / (farNeeded - spent);
        if (part > kLeastShare) {
            advance.removeTo(beyond, static_cast<float>(std::min(1.0, part)), done);
            spent = granted;
        }
    }
    done.changed = advance.giveBack();
    m_leftS = std::min(seconds, granted - spent);
    return done;
}

}  // namespace core::cutting
