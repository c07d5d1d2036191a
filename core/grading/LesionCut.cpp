// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grading/LesionCut.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "core/grading/AreaExcess.h"
#include "core/grading/Columns.h"
#include "core/grading/CutForm.h"
#include "core/grading/IdealCavity.h"
#include "core/grading/Outline.h"
#include "core/teeth/ToothBuilder.h"
#include "core/teeth/ToothTable.h"
#include "core/terrain/DecayZones.h"

namespace core::grading {
namespace {

using terrain::Grid;
using terrain::Tooth;
using terrain::ToothAnatomy;

/// The columns of the smallest cavity, and their lower ends.
class Cavity
{
public:
    Cavity(const ToothAnatomy& anatomy, IdealTop top) : m_anatomy(anatomy), m_top(std::move(top))
    {
        const Grid& grid = anatomy.grid;
        for (int j = 0; j < grid.side; ++j)
            for (int i = 0; i < grid.side; ++i)
                if (has(i, j) && !(has(i - 1, j) && has(i + 1, j) && has(i, j - 1) && has(i, j + 1)))
                    m_edge.push_back(grid.nodeMm(i, j));
    }
    [[nodiscard]] bool isEmpty() const { return m_edge.empty(); }
    [[nodiscard]] bool has(int i, int j) const
    {
        if (!m_anatomy.grid.contains(i, j))
            return false;
        const std::size_t k = m_anatomy.grid.index(i, j);
        return wasSolid(m_anatomy, k) && (*m_top)[k] < m_anatomy.top[k];
    }
    [[nodiscard]] double floorMm(std::size_t k) const
    {
        return static_cast<double>(std::max((*m_top)[k], m_anatomy.bottom[k]));
    }
    /// Returns the distance, seen from above, from a position outside the cavity to the nearest column.
    [[nodiscard]] double distanceMm(glm::dvec2 placeMm) const
    {
        double least = std::numeric_limits<double>::infinity();
        for (const glm::dvec2 edge : m_edge)
            least = std::min(least, glm::dot(edge - placeMm, edge - placeMm));
        return std::sqrt(least);
    }
    /// Returns the lowest floor within kLesionReachMm of a node; empty if no cavity is that near.
    [[nodiscard]] std::optional<double> lowestFloorMm(int i, int j) const
    {
        const Grid& grid = m_anatomy.grid;
        const int reach = static_cast<int>(std::floor(kLesionReachMm / grid.cellMm + 1.0e-6));
        std::optional<double> lowest;
        for (int dj = -reach; dj <= reach; ++dj)
            for (int di = -reach; di <= reach; ++di)
                if (di * di + dj * dj <= reach * reach && has(i + di, j + dj)) {
                    const double floor = floorMm(grid.index(i + di, j + dj));
                    lowest = std::min(lowest.value_or(floor), floor);
                }
        return lowest;
    }

private:
    const ToothAnatomy& m_anatomy;
    IdealTop m_top;
    std::vector<glm::dvec2> m_edge;
};

/// Adds the remaining decay of a column to one of the two areas, and updates the largest value of that area.
void addDecayLeft(const Tooth& tooth, std::size_t k, LesionCut& result, double& mostAtJunction, double& mostOnFloor)
{
    const Decay left = decayIn(tooth, k);
    if (!left.any())
        return;
    const ToothAnatomy& anatomy = *tooth.anatomy;
    const auto area = static_cast<double>(anatomy.areaMm2[k]);
    const auto junction = static_cast<double>(anatomy.layers[k].dej);
    const double height = static_cast<double>(left.roof) - static_cast<double>(left.floor);
    const bool isAtJunction = static_cast<double>(left.roof) > junction - kAtJunctionMm;
    Placed& here = isAtJunction ? result.junctionMm2 : result.floorMm2;
    double& most = isAtJunction ? mostAtJunction : mostOnFloor;
    here.value += area;
    if (height > most) {
        most = height;
        here.node = k;
    }
}

/// Sums of the remaining decay of the zones, column by column.
class ZoneSums
{
public:
    explicit ZoneSums(const Tooth& tooth) : m_tooth(tooth) {}
    void add(std::size_t k)
    {
        const ToothAnatomy& anatomy = *m_tooth.anatomy;
        const terrain::ColumnLayers& column = anatomy.layers[k];
        if (!wasSolid(anatomy, k) || !(column.cariesRoof > column.cariesFloor))
            return;
        const terrain::DecayZones zones = terrain::decayZonesOf(anatomy, k);
        const auto area = static_cast<double>(anatomy.areaMm2[k]);
        const auto above = [](float roof, float from) {
            return std::max(0.0, static_cast<double>(roof) - static_cast<double>(from));
        };
        const float softFloor = std::max(zones.leatheryRoof, anatomy.bottom[k]);
        m_softMm3 += above(std::min(column.cariesRoof, anatomy.top[k]), softFloor) * area;
        const Decay left = decayIn(m_tooth, k);
        if (!left.any())
            return;
        const double soft = above(left.roof, softFloor);
        m_softLeftMm3 += soft * area;
        note(m_left.softPercent, m_mostSoft, soft, k);
        const double leathery = isOverPulp(anatomy, k) ? 0.0 : above(left.roof, zones.firmRoof);
        m_left.leatheryMm2.value += leathery > 0.0 ? area : 0.0;
        note(m_left.leatheryMm2, m_mostLeathery, leathery, k);
    }
    [[nodiscard]] DecayZonesLeft left() const
    {
        DecayZonesLeft left = m_left;
        left.softPercent.value = m_softMm3 > 0.0 ? 100.0 * (m_softLeftMm3 / m_softMm3) : 0.0;
        return left;
    }

private:
    static void note(Placed& place, double& most, double heightMm, std::size_t k)
    {
        if (heightMm > most) {
            most = heightMm;
            place.node = k;
        }
    }

    const Tooth& m_tooth;
    DecayZonesLeft m_left;
    double m_softMm3 = 0.0;
    double m_softLeftMm3 = 0.0;
    double m_mostSoft = 0.0;
    double m_mostLeathery = 0.0;
};

struct Ridges
{
    std::optional<Placed> mesialMm;
    std::optional<Placed> distalMm;
};

/// @param end  heights at which the columns end, [side * side]
Ridges ridgesOf(const ToothAnatomy& anatomy, const std::vector<float>& end)
{
    const Outline outline(anatomy, end);
    const CutSurface surface{anatomy, end, outline};
    return {ridgeOf(surface, -1), ridgeOf(surface, 1)};
}

void findRidges(const Tooth& tooth, const std::vector<float>& smallest, LesionCut& result)
{
    const ToothAnatomy& anatomy = *tooth.anatomy;
    if (!teeth::standsInTheArch(anatomy) || anatomy.fdi % 10 <= 3)  // front teeth have no marginal ridges
        return;
    std::vector<float> end = anatomy.top;
    std::vector<float> least = anatomy.top;
    for (std::size_t k = 0; k < end.size(); ++k)
        if (wasSolid(anatomy, k)) {
            end[k] = std::min(end[k], endOf(tooth, k));
            least[k] = std::max(smallest[k], anatomy.bottom[k]);
        }
    const Ridges now = ridgesOf(anatomy, end);
    const Ridges before = ridgesOf(anatomy, least);
    result.ridgeMesialMm = now.mesialMm;
    result.ridgeDistalMm = now.distalMm;
    const auto look = [&](const std::optional<Placed>& left, const std::optional<Placed>& usual) {
        if (left && usual && usual->value - left->value > result.ridgeLostMm.value)
            result.ridgeLostMm = {usual->value - left->value, left->node};
    };
    look(now.mesialMm, before.mesialMm);
    look(now.distalMm, before.distalMm);
}

}  // namespace

std::optional<LesionCut> measureLesionCut(const Tooth& tooth)
{
    const ToothAnatomy& anatomy = *tooth.anatomy;
    const IdealTop top = idealCavity(anatomy);
    if (top == nullptr)
        return {};
    const Cavity cavity(anatomy, top);
    if (cavity.isEmpty())
        return {};
    const Grid& grid = anatomy.grid;
    LesionCut result;
    AreaExcess beyond;
    AreaExcess below;
    ZoneSums zones(tooth);
    double mostAtJunction = 0.0;
    double mostOnFloor = 0.0;
    for (int j = 0; j < grid.side; ++j) {
        for (int i = 0; i < grid.side; ++i) {
            const std::size_t k = grid.index(i, j);
            addDecayLeft(tooth, k, result, mostAtJunction, mostOnFloor);
            if (anatomy.hasDecayZones)
                zones.add(k);
            if (!isCut(tooth, k))
                continue;
            const auto end = static_cast<double>(endOf(tooth, k));
            const auto area = static_cast<double>(anatomy.areaMm2[k]);
            if (!cavity.has(i, j) && static_cast<double>(anatomy.top[k]) - end >= kStrayDepthMm)
                beyond.add(cavity.distanceMm(grid.nodeMm(i, j)), area, k);
            if (const auto floor = cavity.lowestFloorMm(i, j))
                below.add(*floor - end, area, k);
        }
    }
    result.beyondMm = beyond.over(kStrayMm2);
    result.belowMm = below.over(kLocalMm2);
    if (anatomy.hasDecayZones)
        result.zones = zones.left();
    findRidges(tooth, *top, result);
    return result;
}

}  // namespace core::grading
