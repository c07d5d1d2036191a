// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/PatternSearch.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/contact/Lengths.h"

namespace core::contact {
namespace {

constexpr int kFinestLevel = 5;  ///< smallest step: cell / 2^5
constexpr double kWideCells = 2.0;
constexpr int kNodesAround = 2;
constexpr int kMaxLooks = 48;  ///< positions tried in a tick; the next tick continues from there

constexpr double kDiagonal = 0.7071067811865476;
/// The first four directions are along the lattice. The others are tried only with the finest step, or if one of them
/// succeeded last.
constexpr std::size_t kAlong = 4;
constexpr std::array<glm::dvec2, 8> kDirections{{{1.0, 0.0},
                                                 {0.0, 1.0},
                                                 {-1.0, 0.0},
                                                 {0.0, -1.0},
                                                 {kDiagonal, kDiagonal},
                                                 {-kDiagonal, kDiagonal},
                                                 {-kDiagonal, -kDiagonal},
                                                 {kDiagonal, -kDiagonal}}};

/// The start of a step and its limits.
struct Step
{
    double deviceZ = 0.0;
    double fromZ = 0.0;
    double climb = 0.0;    ///< largest rise over ground, or descent under a roof
    double highest = 0.0;  ///< a higher position would be no nearer to the device
    bool inNotch = false;  ///< the anchor has some columns below it and others above
};

/// Sets the height of the anchor at `at`. Returns false if no height within reach of the step is free there.
bool standAt(LiveTooth& tooth, glm::dvec2 at, const Step& step, double& z) noexcept
{
    const double reach = step.fromZ + step.climb;
    if (step.inNotch) {
        const Room least{reach, step.fromZ - step.climb};
        const Room room = tooth.roomAt(at, step.fromZ, least);
        if (room.floorMm > room.roofMm || room.floorMm > least.floorMm || room.roofMm < least.roofMm)
            return false;
        z = std::clamp(step.deviceZ, room.floorMm, room.roofMm);
        return true;
    }
    const double limit = std::min(reach, step.highest);
    const double above = tooth.clearanceAt(at, limit);
    if (above <= limit) {
        z = std::max(step.deviceZ, above);
        return true;
    }
    const double lowest = step.fromZ - step.climb;
    const double beneath = tooth.undersideAt(at, lowest);
    if (beneath < lowest)
        return false;
    z = std::min(step.deviceZ, beneath);
    return true;
}

}  // namespace

void searchAround(LiveTooth& tooth, const glm::dvec3& device, double movedMm, const SearchLimits& limits,
                  glm::dvec3& anchor) noexcept
{
    const double cell = tooth.grid().cellMm;
    // The first step is about as long as the motion of the hand, so that an anchor at rest costs only the finest
    // levels. An anchor stuck behind a column needs steps wider than a column, but no wider than half the bur.
    const double reach = movedMm + cell / 32.0;
    const bool isStuck = limits.isStuck;
    double step = isStuck ? std::min(kWideCells * cell, 0.5 * static_cast<double>(tooth.mask().radiusMm)) : cell;
    int level = 0;
    while (!isStuck && level < kFinestLevel - 1 && step > 2.0 * reach) {
        step *= 0.5;
        ++level;
    }
    double best = distance2(anchor, device);
    int looks = 0;
    // Moves to a place if it is free and nearer than the best.
    const auto goTo = [&](glm::dvec2 at, double fromZ, double climb) {
        // A position whose column alone is farther than the best needs no computation of the clearance.
        const double flat = (at.x - device.x) * (at.x - device.x) + (at.y - device.y) * (at.y - device.y);
        if (flat >= best)
            return false;
        ++looks;
        const Step to{device.z, fromZ, climb, device.z + std::sqrt(best - flat), limits.inNotch};
        double z = 0.0;
        if (!standAt(tooth, at, to, z) || distance2({at, z}, device) >= best)
            return false;
        anchor = {at, z};
        best = distance2(anchor, device);
        return true;
    };
    if (isStuck) {
        // Nodes are tried first: with its axis over a node, a bur passes between columns that stop it between nodes.
        const terrain::Grid& grid = tooth.grid();
        const glm::dvec2 lattice = grid.latticeOf(glm::dvec2(anchor));
        const double fromZ = anchor.z;
        const glm::dvec2 from(anchor);
        const double farthest = 0.5 * static_cast<double>(tooth.mask().radiusMm);  // farther, it might jump through a
                                                                                   // wall
        for (int dj = -kNodesAround; dj <= kNodesAround; ++dj) {
            for (int di = -kNodesAround; di <= kNodesAround; ++di) {
                const glm::dvec2 node = grid.nodeMm(static_cast<int>(std::floor(lattice.x + 0.5)) + di,
                                                    static_cast<int>(std::floor(lattice.y + 0.5)) + dj);
                if (glm::dot(node - from, node - from) <= farthest * farthest)
                    static_cast<void>(goTo(node, fromZ, limits.steepest * cell));
            }
        }
        looks = 0;
    }
    std::size_t heading = 0;  // the last successful direction is tried first
    int streak = 0;
    while (level <= kFinestLevel && looks < kMaxLooks) {
        bool found = false;
        const std::size_t turns = 1 + (isStuck || level == kFinestLevel ? kDirections.size() : kAlong);
        for (std::size_t turn = 0; turn < turns && !found; ++turn) {
            const std::size_t now = turn == 0 ? heading : turn - 1;
            if (turn > 0 && now == heading)
                continue;
            const glm::dvec2& direction = kDirections[now];
            const glm::dvec2 at(anchor.x + direction.x * step, anchor.y + direction.y * step);
            found = goTo(at, anchor.z, limits.steepest * step);
            if (found)
                heading = now;
        }
        if (!found) {
            step *= 0.5;
            ++level;
            streak = 0;
        } else if (++streak == 2 && level > 0) {  // still a long way to go: take longer steps
            step *= 2.0;
            --level;
            streak = 0;
        }
    }
}

}  // namespace core::contact
