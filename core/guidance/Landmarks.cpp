// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/guidance/Landmarks.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

#include "core/grading/Columns.h"

namespace core::guidance {
namespace {

// Distances from the middle of the tooth, in mesiodistal widths.
constexpr double kMiddleEnds = 0.15;
constexpr double kPitsEnd = 0.4;
constexpr double kRidgesBegin = 0.3;
constexpr double kPitMm = 0.4;  ///< a pit is the lowest point within this distance

/// Premolars with two cusps have no central pit, only a mesial and a distal one.
bool hasCentralPit(int fdi)
{
    return fdi % 10 > 5 || fdi == 35 || fdi == 45;
}

/// The crown of a tooth seen from above, with mesial towards -x. A share is a distance, in mesiodistal widths of the
/// crown, that is positive distal of the middle.
class Crown
{
public:
    Crown(const terrain::ToothAnatomy& anatomy, const std::vector<float>& ideal) : m_anatomy(anatomy), m_ideal(ideal)
    {
        double mesialMm = std::numeric_limits<double>::max();
        double distalMm = -mesialMm;
        for (std::size_t k = 0; k < anatomy.grid.count(); ++k)
            if (grading::wasSolid(anatomy, k)) {
                mesialMm = std::min(mesialMm, anatomy.grid.nodeMm(k).x);
                distalMm = std::max(distalMm, anatomy.grid.nodeMm(k).x);
            }
        m_middleMm = 0.5 * (mesialMm + distalMm);
        m_widthMm = distalMm - mesialMm;
    }

    /// Returns whether the ideal cuts a column.
    [[nodiscard]] bool isRemoved(std::size_t k) const
    {
        return grading::wasSolid(m_anatomy, k) && m_ideal[k] < m_anatomy.top[k];
    }

    /// Returns the lowest node that the ideal removes between two shares.
    [[nodiscard]] std::optional<std::size_t> pit(double from, double to) const
    {
        std::optional<std::size_t> lowest;
        forEachNode([&](std::size_t k, double share, double) {
            if (share >= from && share <= to && isRemoved(k) && (!lowest || m_anatomy.top[k] < m_anatomy.top[*lowest]))
                lowest = k;
        });
        return lowest && isLowestAround(*lowest) ? lowest : std::nullopt;
    }

    /// Returns the highest node on the line that the preparation follows towards the edge of the crown.
    /// @param sign  -1 mesial, 1 distal
    [[nodiscard]] std::optional<std::size_t> ridge(double sign) const
    {
        const std::optional<double> line = lineMm([&](double share) { return sign * share > kMiddleEnds; });
        const std::optional<double> y = line ? line : lineMm([](double) { return true; });
        if (!y)
            return std::nullopt;
        std::optional<std::size_t> highest;
        forEachNode([&](std::size_t k, double share, double nodeY) {
            const bool isOnLine = std::abs(nodeY - *y) <= 0.5 * m_anatomy.grid.cellMm;
            if (isOnLine && sign * share > kRidgesBegin && grading::wasSolid(m_anatomy, k) &&
                (!highest || m_anatomy.top[k] > m_anatomy.top[*highest]))
                highest = k;
        });
        return highest;
    }

private:
    /// Returns the mean y of what the ideal removes where isWanted(share).
    template <class IsWanted>
    [[nodiscard]] std::optional<double> lineMm(const IsWanted& isWanted) const
    {
        double sumMm = 0.0;
        int count = 0;
        forEachNode([&](std::size_t k, double share, double y) {
            if (isWanted(share) && isRemoved(k)) {
                sumMm += y;
                ++count;
            }
        });
        return count > 0 ? std::optional(sumMm / count) : std::nullopt;
    }

    /// Returns whether the ideal removes no lower node near this one. A slope has its lowest node at the end of a
    /// stretch, which is no pit.
    [[nodiscard]] bool isLowestAround(std::size_t node) const
    {
        const terrain::Grid& grid = m_anatomy.grid;
        const int reach = static_cast<int>(kPitMm / grid.cellMm);
        const int middleI = static_cast<int>(node) % grid.side;
        const int middleJ = static_cast<int>(node) / grid.side;
        for (int j = middleJ - reach; j <= middleJ + reach; ++j)
            for (int i = middleI - reach; i <= middleI + reach; ++i)
                if (grid.contains(i, j) && isRemoved(grid.index(i, j)) &&
                    m_anatomy.top[grid.index(i, j)] < m_anatomy.top[node])
                    return false;
        return true;
    }

    /// Calls visit(index, share, y in mm).
    template <class Visit>
    void forEachNode(const Visit& visit) const
    {
        for (std::size_t k = 0; k < m_anatomy.grid.count(); ++k) {
            const glm::dvec2 at = m_anatomy.grid.nodeMm(k);
            visit(k, (at.x - m_middleMm) / m_widthMm, at.y);
        }
    }

    const terrain::ToothAnatomy& m_anatomy;
    const std::vector<float>& m_ideal;
    double m_middleMm = 0.0;
    double m_widthMm = 0.0;
};

}  // namespace

std::vector<PlacedLandmark> findLandmark(Landmark landmark, const terrain::ToothAnatomy& anatomy,
                                         const std::vector<float>& ideal)
{
    const bool isPosterior = anatomy.fdi % 10 > 3 && anatomy.lying.isUpright();
    if (!isPosterior)
        return {};
    const Crown crown(anatomy, ideal);
    std::vector<PlacedLandmark> found;
    const auto add = [&](Landmark which, std::optional<std::size_t> node) {
        if (node)
            found.push_back({which, anatomy.grid.nodeMm(*node)});
    };
    // Without a central pit, the ranges of the other two pits extend to the middle.
    const double middleEnds = hasCentralPit(anatomy.fdi) ? kMiddleEnds : 0.0;
    const auto mesial = [&] { return crown.ridge(-1.0); };
    const auto distal = [&] { return crown.ridge(1.0); };
    switch (landmark) {
    case Landmark::CentralPit:
        if (hasCentralPit(anatomy.fdi))
            add(landmark, crown.pit(-kMiddleEnds, kMiddleEnds));
        break;
    case Landmark::MesialPit:
        add(landmark, crown.pit(-kPitsEnd, -middleEnds));
        break;
    case Landmark::DistalPit:
        add(landmark, crown.pit(middleEnds, kPitsEnd));
        break;
    case Landmark::MesialRidge:
        add(landmark, mesial());
        break;
    case Landmark::DistalRidge:
        add(landmark, distal());
        break;
    case Landmark::RidgesToKeep:
    case Landmark::RidgesToCut:
        for (const auto& [which, node] :
             {std::pair(Landmark::MesialRidge, mesial()), {Landmark::DistalRidge, distal()}})
            if (node && crown.isRemoved(*node) == (landmark == Landmark::RidgesToCut))
                add(which, node);
        break;
    }
    return found;
}

}  // namespace core::guidance
