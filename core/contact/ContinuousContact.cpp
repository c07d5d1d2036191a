// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/ContinuousContact.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>

namespace core::contact {
namespace {

constexpr double kMaxSlope = 4.0;  ///< steepest climb of one step
constexpr int kFinestLevel = 7;    ///< smallest step: cell / 2^7
constexpr int kFinestLevelOnCut = 5;
constexpr int kMaxLooks = 48;           ///< places looked at in a tick; the next tick goes on from there
constexpr double kRounding = 1.0e-6;    ///< mm: heights are floats
constexpr double kTouchedMm = 0.02;     ///< ground that came up by no more was touched, not entered
constexpr double kMostSettledMm = 0.3;  ///< most that a bur in a notch is lifted or lowered to fit
constexpr int kMaxFreeSamples = 128;    ///< points looked at along a move through the air

constexpr double kDiagonal = 0.7071067811865476;
/// The four along the lattice first: only the finest step tries the others, unless one of them helped last.
constexpr std::size_t kAlong = 4;
constexpr std::array<glm::dvec2, 8> kDirections{{{1.0, 0.0},
                                                 {0.0, 1.0},
                                                 {-1.0, 0.0},
                                                 {0.0, -1.0},
                                                 {kDiagonal, kDiagonal},
                                                 {-kDiagonal, kDiagonal},
                                                 {-kDiagonal, -kDiagonal},
                                                 {kDiagonal, -kDiagonal}}};

double distance2(const glm::dvec3& a, const glm::dvec3& b)
{
    const glm::dvec3 apart = a - b;
    return glm::dot(apart, apart);
}

/// Where a step comes from and what it may do.
struct Step
{
    double deviceZ = 0.0;
    double fromZ = 0.0;
    double climb = 0.0;      ///< most it may rise over ground, or sink under a roof
    double highest = 0.0;    ///< standing above this would be no nearer to the device
    bool underRoof = false;  ///< the anchor is beneath an overhang
    bool inNotch = false;    ///< the anchor has some columns beneath it and others above
};

/// Height at which the anchor would stand at `at`; false if nothing that the step can reach is free there.
bool standAt(LiveTooth& tooth, glm::dvec2 at, const Step& step, double& z) noexcept
{
    const double reach = step.fromZ + step.climb;
    if (step.inNotch) {
        const Room room = tooth.roomAt(at, step.fromZ);
        if (room.floorMm > room.roofMm || room.floorMm > reach || room.roofMm < step.fromZ - step.climb)
            return false;
        z = std::clamp(step.deviceZ, room.floorMm, room.roofMm);
        return true;
    }
    const double limit = std::min(step.underRoof ? reach : std::max(step.deviceZ, reach), step.highest);
    const double above = tooth.clearanceAt(at, limit);
    if (above <= limit) {
        z = std::max(step.deviceZ, above);
        return true;
    }
    // Ground too high. From beside or beneath, the way under it may be open; pressed down from above it is not.
    if (step.fromZ > step.deviceZ + step.climb)
        return false;
    const double lowest = step.fromZ - step.climb;
    const double beneath = tooth.undersideAt(at, lowest);
    if (beneath < lowest)
        return false;
    z = std::min(step.deviceZ, beneath);
    return true;
}

/// True if the straight way from the anchor to a free device meets nothing.
bool wayIsFree(LiveTooth& tooth, const glm::dvec3& from, const glm::dvec3& to) noexcept
{
    const glm::dvec2 flat(to.x - from.x, to.y - from.y);
    const double length = std::sqrt(glm::dot(flat, flat));
    const int samples = static_cast<int>(length / (0.5 * tooth.grid().cellMm)) + 1;
    if (samples > kMaxFreeSamples)
        return false;
    for (int k = 1; k <= samples; ++k) {
        const double share = static_cast<double>(k) / samples;
        const double z = from.z + (to.z - from.z) * share;
        if (tooth.clearanceAt({from.x + flat.x * share, from.y + flat.y * share}, z) > z)
            return false;
    }
    return true;
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
}

glm::dvec3 ContinuousContact::update(LiveTooth& tooth, const glm::dvec3& device) noexcept
{
    const glm::dvec3 moved = device - m_device;
    m_device = device;
    if (wayIsFree(tooth, m_anchor, device)) {
        m_anchor = device;
        m_mayBeInside = false;
        return m_anchor;
    }

    const double cell = tooth.grid().cellMm;
    bool underRoof = false;
    bool inNotch = false;
    const double ground = tooth.clearanceAt({m_anchor.x, m_anchor.y});
    if (ground > m_anchor.z + kRounding) {
        const double roof = tooth.undersideAt({m_anchor.x, m_anchor.y});
        underRoof = roof >= m_anchor.z - kRounding;
        if (underRoof) {
            m_anchor.z = std::min(device.z, roof);
        } else if (m_mayBeInside || ground <= m_anchor.z + kTouchedMm) {
            m_anchor.z = std::max(device.z, ground);  // undo, or another bur: out by the way that is always open
        } else {
            // It was free a tick ago and still is, column by column, or all but a rim that cutting will take.
            inNotch = true;
            const Room room = tooth.roomAt({m_anchor.x, m_anchor.y}, m_anchor.z);
            const double z = std::clamp(m_anchor.z, room.floorMm, std::max(room.floorMm, room.roofMm));
            if (room.floorMm <= room.roofMm && std::abs(z - m_anchor.z) <= kMostSettledMm)
                m_anchor.z = std::clamp(device.z, room.floorMm, room.roofMm);
        }
    } else {
        m_anchor.z = std::max(device.z, ground);
    }
    m_mayBeInside = false;

    // Begin with a step of about what the hand did, so that an anchor at rest costs only the finest levels.
    const double reach = std::sqrt(glm::dot(moved, moved)) + cell / 32.0;
    double step = cell;
    int level = 0;
    while (level < kFinestLevelOnCut - 1 && step > 2.0 * reach) {
        step *= 0.5;
        ++level;
    }
    double best = distance2(m_anchor, device);
    std::size_t heading = 0;  // the direction that helped last is tried first
    int streak = 0;
    // Cut ground is felt column by column, rough by more than the last halvings resolve.
    const int finest = tooth.isFeltByColumns({m_anchor.x, m_anchor.y}) ? kFinestLevelOnCut : kFinestLevel;
    for (int looks = 0; level <= finest && looks < kMaxLooks;) {
        bool found = false;
        const std::size_t turns = 1 + (level == finest ? kDirections.size() : kAlong);
        for (std::size_t turn = 0; turn < turns && !found; ++turn) {
            const std::size_t now = turn == 0 ? heading : turn - 1;
            if (turn > 0 && now == heading)
                continue;
            const glm::dvec2& direction = kDirections[now];
            const glm::dvec2 at(m_anchor.x + direction.x * step, m_anchor.y + direction.y * step);
            // A place whose own column is already farther than the best needs no clearance.
            const double flat = (at.x - device.x) * (at.x - device.x) + (at.y - device.y) * (at.y - device.y);
            if (flat >= best)
                continue;
            const Step to{device.z,  m_anchor.z, kMaxSlope * step, device.z + std::sqrt(best - flat),
                          underRoof, inNotch};
            double z = 0.0;
            ++looks;
            if (!standAt(tooth, at, to, z))
                continue;
            const glm::dvec3 candidate(at.x, at.y, z);
            const double far = distance2(candidate, device);
            if (far < best) {
                best = far;
                m_anchor = candidate;
                heading = now;
                found = true;
            }
        }
        if (!found) {
            step *= 0.5;
            ++level;
            streak = 0;
        } else if (++streak == 2 && level > 0) {  // a long way to go: longer steps
            step *= 2.0;
            --level;
            streak = 0;
        }
    }
    return m_anchor;
}

}  // namespace core::contact
