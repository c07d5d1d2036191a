// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/simulated/IdealHand.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/bur/Reach.h"

namespace haptics {
namespace {

using core::terrain::kEmptyTop;

constexpr double kPushN = 1.2;
constexpr float kLeftMm = 0.03F;  ///< a thinner rest is left
constexpr float kBelowToothMm = 0.1F;
constexpr std::size_t kFewShare = 10;  ///< of the columns to be cut: fewer that do not yield are left
constexpr double kReachedMm = 0.01;
constexpr double kClearMm = 0.3;     ///< height over obstacles
constexpr double kApartMm = 0.1;     ///< from a neighbour: on a steep wall the bur slides so far beside its aim
constexpr double kLeadMm = 0.6;      ///< distance of the hand ahead of the bur, into the tooth
constexpr double kSinkMm = 0.8;      ///< and at most so far below it
constexpr double kPress = 4.0;       ///< times the missing distance sideways: a bur cuts only above a threshold of
                                     ///< force
constexpr int kMostPatience = 120;   ///< decisions before a column is given up
constexpr float kDeep = 4.0F;        ///< times the head's length: a deeper cut is made in layers from the start
constexpr double kLayerShare = 0.8;  ///< of the head's length: above it the shank does not cut
constexpr int kThere = 6;            ///< a decision counts so many times if the bur is at its aim and should be cutting

}  // namespace

IdealHand::IdealHand(const core::terrain::ToothAnatomy& anatomy, std::span<const float> idealTop,
                     const core::bur::Bur& bur, const core::terrain::HeightMaps* beside)
    : m_grid(anatomy.grid), m_lowestMm(m_grid.count(), kEmptyTop), m_reachMm(anatomy.top), m_fromAt(m_grid.count()),
      m_isKeptOff(m_grid.count()), m_isGivenUp(m_grid.count()), m_layerMm(kEmptyTop),
      m_thickMm(static_cast<float>(kLayerShare * bur.headLengthMm))
{
    const std::vector<FootprintPart> head = footprint(bur, m_grid);
    // A column that has to be removed completely is cut to just below its bottom.
    std::vector<float> wantedTop(idealTop.begin(), idealTop.end());
    for (std::size_t k = 0; k < m_grid.count(); ++k)
        if (anatomy.top[k] > anatomy.bottom[k])
            wantedTop[k] = std::max(wantedTop[k], anatomy.bottom[k] - kBelowToothMm);
    findLowest(wantedTop, head);
    const auto lowestTip = static_cast<float>(core::bur::lowestTipMm(anatomy));
    for (float& lowest : m_lowestMm)
        lowest = std::max(lowest, lowestTip);
    if (beside != nullptr)
        keepOff(*beside, bur);
    findReach(head);
    float highest = kEmptyTop;
    float deepest = 0.0F;
    for (std::size_t k = 0; k < m_grid.count(); ++k)
        if (anatomy.top[k] > m_reachMm[k] + kLeftMm) {
            ++m_wanted;
            highest = std::max(highest, anatomy.top[k]);
            deepest = std::max(deepest, anatomy.top[k] - m_reachMm[k]);
        }
    if (deepest > kDeep * static_cast<float>(bur.headLengthMm))
        m_layerMm = highest - m_thickMm;
}

void IdealHand::findLowest(std::span<const float> idealTop, std::span<const FootprintPart> head)
{
    for (int j = 0; j < m_grid.side; ++j)
        for (int i = 0; i < m_grid.side; ++i) {
            float& lowest = m_lowestMm[m_grid.index(i, j)];
            for (const FootprintPart& part : head)
                if (m_grid.contains(i + part.i, j + part.j))
                    lowest = std::max(lowest, idealTop[m_grid.index(i + part.i, j + part.j)] - part.heightMm);
        }
}

/// Keeps the bur above a neighbouring tooth wherever it would touch it.
void IdealHand::keepOff(const core::terrain::HeightMaps& beside, const core::bur::Bur& bur)
{
    const core::terrain::Grid& other = beside.grid;
    const int span = static_cast<int>((bur.headRadiusMm + kApartMm) / other.cellMm) + 1;
    for (std::size_t k = 0; k < m_grid.count(); ++k) {
        const glm::dvec2 place = m_grid.nodeMm(k);
        const glm::ivec2 at(glm::floor(other.latticeOf(place) + 0.5));
        for (int j = at.y - span; j <= at.y + span; ++j)
            for (int i = at.x - span; i <= at.x + span; ++i) {
                if (!other.contains(i, j))
                    continue;
                const glm::dvec2 way = other.nodeMm(i, j) - place;
                const double radius = std::max(0.0, std::sqrt(glm::dot(way, way)) - kApartMm);
                const float top = beside.top[other.index(i, j)];
                if (radius > bur.headRadiusMm || !(top > beside.bottom[other.index(i, j)]))
                    continue;
                m_lowestMm[k] = std::max(m_lowestMm[k], top - static_cast<float>(bur.undersideMm(radius)));
                m_isKeptOff[k] = true;
            }
    }
}

void IdealHand::findReach(std::span<const FootprintPart> head)
{
    for (std::size_t k = 0; k < m_grid.count(); ++k) {
        m_fromAt[k] = k;
        m_reachMm[k] = std::min(m_reachMm[k], m_lowestMm[k]);
    }
    for (int j = 0; j < m_grid.side; ++j)
        for (int i = 0; i < m_grid.side; ++i) {
            const std::size_t from = m_grid.index(i, j);
            for (const FootprintPart& part : head) {
                if (!m_grid.contains(i + part.i, j + part.j))
                    continue;
                const std::size_t column = m_grid.index(i + part.i, j + part.j);
                if (const float reach = m_lowestMm[from] + part.heightMm; reach < m_reachMm[column]) {
                    m_reachMm[column] = reach;
                    m_fromAt[column] = from;
                }
            }
        }
}

/// Tries the columns that could not be cut again, in layers from the top. Returns false when all have been tried.
bool IdealHand::goDown(const core::terrain::Tooth& tooth)
{
    float highest = kEmptyTop;
    float lowest = std::numeric_limits<float>::max();
    std::size_t left = 0;
    for (std::size_t k = 0; k < m_grid.count(); ++k)
        if (tooth.isSolid(k) && tooth.top[k] > m_reachMm[k] + kLeftMm) {
            ++left;
            highest = std::max(highest, tooth.top[k]);
            lowest = std::min(lowest, m_lowestMm[m_fromAt[k]]);
        }
    if (m_layerMm > kEmptyTop)
        highest = m_layerMm;
    if (highest <= lowest || left * kFewShare < m_wanted)
        return false;
    m_layerMm = highest - m_thickMm;
    m_isGivenUp.assign(m_grid.count(), false);
    return true;
}

bool IdealHand::isWanting(const core::terrain::Tooth& tooth, std::size_t column) const
{
    const float aboveMm = std::max(0.0F, m_layerMm - m_lowestMm[m_fromAt[column]]);
    return !m_isGivenUp[m_fromAt[column]] && tooth.isSolid(column) &&
           tooth.top[column] > m_reachMm[column] + aboveMm + kLeftMm;
}

/// Returns the next column to cut: the deepest at first, then the nearest.
std::optional<std::size_t> IdealHand::nextColumn(const core::terrain::Tooth& tooth, glm::dvec2 burMm) const
{
    std::optional<std::size_t> best;
    double least = std::numeric_limits<double>::max();
    const bool isFirst = tooth.top == tooth.anatomy->top;
    for (std::size_t k = 0; k < m_grid.count(); ++k) {
        if (!isWanting(tooth, k))
            continue;
        const glm::dvec2 apart = m_grid.nodeMm(m_fromAt[k]) - burMm;
        const double cost = isFirst ? m_reachMm[k] - static_cast<double>(tooth.top[k]) : glm::dot(apart, apart);
        if (cost < least) {
            least = cost;
            best = k;
        }
    }
    return best;
}

double IdealHand::lowestAt(glm::dvec2 placeMm) const
{
    const glm::dvec2 at = m_grid.latticeOf(placeMm);
    const auto i = static_cast<int>(std::lround(at.x));
    const auto j = static_cast<int>(std::lround(at.y));
    return m_grid.contains(i, j) ? static_cast<double>(std::max(m_layerMm, m_lowestMm[m_grid.index(i, j)])) : kEmptyTop;
}

bool IdealHand::isKeptOff(glm::dvec2 placeMm) const
{
    const glm::ivec2 at(glm::floor(m_grid.latticeOf(placeMm) + 0.5));
    return m_grid.contains(at.x, at.y) && m_isKeptOff[m_grid.index(at.x, at.y)];
}

double IdealHand::lowestOnTheWay(glm::dvec2 fromMm, glm::dvec2 toMm) const
{
    const glm::dvec2 way = toMm - fromMm;
    const int steps = 1 + static_cast<int>(std::sqrt(glm::dot(way, way)) / m_grid.cellMm);
    double highest = kEmptyTop;
    for (int k = 0; k <= steps; ++k)
        highest = std::max(highest, lowestAt(fromMm + way * (static_cast<double>(k) / steps)));
    return highest;
}

core::servo::PointerInput IdealHand::decide(const core::servo::ServoState& state, const core::terrain::Tooth& tooth)
{
    const glm::dvec2 bur(state.anchorMm.x, state.anchorMm.y);
    if (m_column) {
        const glm::dvec2 apart = m_grid.nodeMm(m_fromAt[*m_column]) - bur;
        m_patience += glm::dot(apart, apart) < m_grid.cellMm * m_grid.cellMm ? kThere : 1;
        m_isGivenUp[m_fromAt[*m_column]] = m_patience > kMostPatience;
    }
    if (!m_column || !isWanting(tooth, *m_column)) {
        do
            m_column = nextColumn(tooth, bur);
        while (!m_column && goDown(tooth));
        m_patience = 0;
    }
    m_isDone = !m_column;
    core::servo::PointerInput want;
    want.pushForceN = kPushN;
    want.targetMm = bur;
    if (m_isDone)
        return want;

    const std::size_t aim = m_fromAt[*m_column];
    const double there = std::max(m_layerMm, m_lowestMm[aim]);
    const glm::dvec2 way = m_grid.nodeMm(aim) - bur;
    const double distance = std::sqrt(glm::dot(way, way));
    const double onTheWay = lowestOnTheWay(bur, m_grid.nodeMm(aim));
    const bool isThere = distance < 0.5 * m_grid.cellMm;
    if (isThere) {
        want.targetMm = m_grid.nodeMm(aim) + kPress * way;
        want.pushing = state.anchorMm.z > there + kReachedMm;
        want.hoverMm = there;
    } else if (onTheWay > std::max(there, lowestAt(bur)) + kClearMm && state.anchorMm.z < onTheWay) {
        want.hoverMm = onTheWay + kClearMm;  // up first
    } else {
        want.targetMm = bur + way * (std::max(distance, kLeadMm) / distance);
        want.hoverMm = std::max(onTheWay, state.anchorMm.z - kSinkMm);
    }
    // If nothing stops the bur, its lead into the tooth would take it into tissue that must be spared.
    if (isKeptOff(want.targetMm))
        want.targetMm = m_grid.nodeMm(aim);
    return want;
}

}  // namespace haptics
