// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/Spoiling.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace bench {
namespace {

using core::terrain::Grid;
using core::terrain::ToothAnatomy;

constexpr double kHoleRadiusMm = 0.6;   ///< hole of a bur of 0.8 mm with a tremor
constexpr double kGougeRadiusMm = 0.5;  ///< hole of a bur with a steady hand
constexpr double kAwayMm = 1.2;         ///< least distance of a hole from the cavity
constexpr double kRippleMm = 1.6;       ///< length of a wave
constexpr double kRidgeHalfMm = 0.6;    ///< half the width of a cut through a ridge
constexpr double kBehindWallMm = 1.0;
constexpr double kNearPulpRadiusMm = 0.9;  // the shank of the bur goes down there too
constexpr double kSafeMm = 1.0;

bool isTooth(const ToothAnatomy& anatomy, std::size_t k)
{
    return anatomy.top[k] > anatomy.bottom[k];
}

}  // namespace

Spoiling::Spoiling(const ToothAnatomy& anatomy, std::vector<float> wanted)
    : m_anatomy(anatomy), m_wanted(std::move(wanted)), m_isCavity(m_wanted.size(), false)
{
    std::size_t count = 0;
    for (std::size_t k = 0; k < m_wanted.size(); ++k) {
        m_isCavity[k] = isTooth(anatomy, k) && m_wanted[k] < anatomy.top[k] - 0.1F;
        if (!m_isCavity[k])
            continue;
        m_middleMm += anatomy.grid.nodeMm(k);
        ++count;
    }
    m_middleMm /= static_cast<double>(std::max<std::size_t>(1, count));
}

void Spoiling::set(std::size_t k, double mm)
{
    if (!isTooth(m_anatomy, k))
        return;
    // Only nearPulp() comes nearer to the pulp than this, or than the cavity itself.
    const double least =
        core::terrain::hasPulp(m_anatomy, k)
            ? std::min(static_cast<double>(m_wanted[k]), static_cast<double>(m_anatomy.layers[k].pulpRoof) + kSafeMm)
            : -std::numeric_limits<double>::infinity();
    m_wanted[k] = std::min(m_anatomy.top[k], static_cast<float>(std::max(mm, least)));
}

template <class Change>
void Spoiling::eachOfCavity(const Change& change)
{
    for (std::size_t k = 0; k < m_wanted.size(); ++k)
        if (isCavity(k))
            set(k, change(k, static_cast<double>(m_wanted[k])));
}

void Spoiling::lower(double mm)
{
    eachOfCavity([&](std::size_t, double now) { return now - mm; });
}

void Spoiling::widen(double mm)
{
    const Grid& grid = m_anatomy.grid;
    const std::vector<float> before = m_wanted;
    const int reach = static_cast<int>(std::ceil(mm / grid.cellMm));
    for (int j = 0; j < grid.side; ++j)
        for (int i = 0; i < grid.side; ++i)
            for (int dj = -reach; dj <= reach; ++dj)
                for (int di = -reach; di <= reach; ++di) {
                    const bool isNear = std::hypot(di, dj) * grid.cellMm <= mm && grid.contains(i + di, j + dj);
                    if (isNear && isCavity(grid.index(i + di, j + dj)))
                        set(grid.index(i, j), static_cast<double>(std::min(m_wanted[grid.index(i, j)],
                                                                           before[grid.index(i + di, j + dj)])));
                }
}

void Spoiling::lean(double degrees)
{
    const Grid& grid = m_anatomy.grid;
    const std::vector<float> before = m_wanted;
    const double rise = 1.0 / std::tan(glm::radians(degrees));
    constexpr double kFarMm = 1.2;
    const int reach = static_cast<int>(std::ceil(kFarMm / grid.cellMm));
    for (int j = 0; j < grid.side; ++j)
        for (int i = 0; i < grid.side; ++i) {
            const std::size_t k = grid.index(i, j);
            if (isCavity(k))
                continue;
            double lowest = static_cast<double>(m_wanted[k]);
            for (int dj = -reach; dj <= reach; ++dj)
                for (int di = -reach; di <= reach; ++di)
                    if (grid.contains(i + di, j + dj) && isCavity(grid.index(i + di, j + dj)))
                        lowest = std::min(lowest, static_cast<double>(before[grid.index(i + di, j + dj)]) +
                                                      rise * std::hypot(di, dj) * grid.cellMm);
            set(k, lowest);
        }
}

void Spoiling::tilt(double degrees)
{
    const double slope = std::tan(glm::radians(degrees));
    eachOfCavity([&](std::size_t k, double now) { return now + slope * (m_anatomy.grid.nodeMm(k).x - m_middleMm.x); });
}

void Spoiling::ripple(double mm)
{
    const double perMm = 2.0 * std::numbers::pi / kRippleMm;
    eachOfCavity([&](std::size_t k, double now) {
        const glm::dvec2 at = m_anatomy.grid.nodeMm(k);
        return now + mm * std::sin(perMm * (at.x + 0.5 * at.y));
    });
}

void Spoiling::step(double mm)
{
    eachOfCavity([&](std::size_t k, double now) { return m_anatomy.grid.nodeMm(k).x > m_middleMm.x ? now - mm : now; });
}

void Spoiling::dig(glm::dvec2 placeMm, double radiusMm, const std::function<double(std::size_t)>& bottomMm)
{
    for (std::size_t k = 0; k < m_wanted.size(); ++k)
        if (glm::distance(m_anatomy.grid.nodeMm(k), placeMm) <= radiusMm)
            set(k, std::min(static_cast<double>(m_wanted[k]), bottomMm(k)));
}

void Spoiling::gouge(double mm)
{
    const Grid& grid = m_anatomy.grid;
    const auto isInside = [&](std::size_t k) {
        for (std::size_t other = 0; other < m_wanted.size(); ++other)
            if (!isCavity(other) && glm::distance(grid.nodeMm(other), grid.nodeMm(k)) < kGougeRadiusMm)
                return false;
        return true;
    };
    std::vector<std::size_t> middleFirst;
    for (std::size_t k = 0; k < m_wanted.size(); ++k)
        if (isCavity(k))
            middleFirst.push_back(k);
    if (middleFirst.empty())
        return;
    std::sort(middleFirst.begin(), middleFirst.end(), [&](std::size_t a, std::size_t b) {
        return glm::distance(grid.nodeMm(a), m_middleMm) < glm::distance(grid.nodeMm(b), m_middleMm);
    });
    const auto found = std::find_if(middleFirst.begin(), middleFirst.end(), isInside);
    const std::size_t place = found != middleFirst.end() ? *found : middleFirst.front();
    const auto floor = static_cast<double>(m_wanted[place]);
    dig(grid.nodeMm(place), kGougeRadiusMm, [&](std::size_t) { return floor - mm; });
}

void Spoiling::hole(double mm)
{
    const Grid& grid = m_anatomy.grid;
    const auto isAway = [&](std::size_t k) {
        for (std::size_t other = 0; other < m_wanted.size(); ++other)
            if (isCavity(other) && glm::distance(grid.nodeMm(other), grid.nodeMm(k)) < kAwayMm)
                return false;
        return true;
    };
    std::vector<std::size_t> highestFirst;
    for (std::size_t k = 0; k < m_wanted.size(); ++k)
        if (isTooth(m_anatomy, k))
            highestFirst.push_back(k);
    std::sort(highestFirst.begin(), highestFirst.end(),
              [&](std::size_t a, std::size_t b) { return m_anatomy.top[a] > m_anatomy.top[b]; });
    const auto place = std::find_if(highestFirst.begin(), highestFirst.end(), isAway);
    if (place == highestFirst.end())
        return;
    const auto top = static_cast<double>(m_anatomy.top[*place]);
    dig(grid.nodeMm(*place), kHoleRadiusMm, [&](std::size_t) { return top - mm; });
}

void Spoiling::scribble(double mm)
{
    constexpr double kRimMm = 1.0;  // the sides of the crown get no scribbles
    float highest = -std::numeric_limits<float>::infinity();
    for (std::size_t k = 0; k < m_wanted.size(); ++k)
        if (isTooth(m_anatomy, k))
            highest = std::max(highest, m_anatomy.top[k]);
    for (std::size_t k = 0; k < m_wanted.size(); ++k)
        if (isTooth(m_anatomy, k) && m_anatomy.top[k] > highest - 3.0F &&
            m_anatomy.grid.nodeMm(k).y > m_middleMm.y - kRimMm)
            set(k, std::min(static_cast<double>(m_wanted[k]), static_cast<double>(m_anatomy.top[k]) - mm));
}

void Spoiling::cutRidge(double leftMm)
{
    const Grid& grid = m_anatomy.grid;
    const std::vector<float> before = m_wanted;
    for (int j = 0; j < grid.side; ++j) {
        if (std::abs(grid.nodeMm(0, j).y - m_middleMm.y) > kRidgeHalfMm)
            continue;
        int rim = 0;
        while (rim < grid.side && !isTooth(m_anatomy, grid.index(rim, j)))
            ++rim;
        int edge = rim;
        while (edge < grid.side && !isCavity(grid.index(edge, j)))
            ++edge;
        if (edge == grid.side)
            continue;
        // The wall there may lean: the cut continues on the floor behind it.
        float floor = before[grid.index(edge, j)];
        for (int i = edge; i < grid.side && (i - edge) * grid.cellMm < kBehindWallMm; ++i)
            floor = std::min(floor, before[grid.index(i, j)]);
        for (int i = rim; i < edge; ++i)
            if ((i - rim + 0.5) * grid.cellMm >= leftMm)
                set(grid.index(i, j), static_cast<double>(floor));
    }
}

void Spoiling::leave(double share)
{
    std::vector<double> places;
    for (std::size_t k = 0; k < m_wanted.size(); ++k)
        if (isCavity(k))
            places.push_back(m_anatomy.grid.nodeMm(k).x);
    if (places.empty())
        return;
    std::sort(places.begin(), places.end());
    const auto kept = static_cast<std::size_t>((1.0 - share) * static_cast<double>(places.size() - 1));
    eachOfCavity([&](std::size_t k, double now) {
        return m_anatomy.grid.nodeMm(k).x > places[kept] ? static_cast<double>(m_anatomy.top[k]) : now;
    });
}

void Spoiling::nearPulp(double leftMm)
{
    std::optional<std::size_t> highest;
    for (std::size_t k = 0; k < m_wanted.size(); ++k)
        if (isCavity(k) && core::terrain::hasPulp(m_anatomy, k) &&
            (!highest || m_anatomy.layers[k].pulpRoof > m_anatomy.layers[*highest].pulpRoof))
            highest = k;
    if (!highest)
        return;
    const auto roof = static_cast<double>(m_anatomy.layers[*highest].pulpRoof);
    const glm::dvec2 place = m_anatomy.grid.nodeMm(*highest);
    for (std::size_t k = 0; k < m_wanted.size(); ++k)
        if (isTooth(m_anatomy, k) && glm::distance(m_anatomy.grid.nodeMm(k), place) <= kNearPulpRadiusMm)
            m_wanted[k] = std::min(m_wanted[k], static_cast<float>(roof + leftMm));
}

double Spoiling::decayAbove(std::size_t k, float top) const
{
    const core::terrain::ColumnLayers& column = m_anatomy.layers[k];
    const float floor = std::max(column.cariesFloor, m_anatomy.bottom[k]);
    return isTooth(m_anatomy, k) ? std::max(0.0F, std::min(top, column.cariesRoof) - floor) : 0.0F;
}

double Spoiling::decayLeftMm3(const std::vector<float>& top) const
{
    double left = 0.0;
    for (std::size_t k = 0; k < top.size(); ++k)
        left += decayAbove(k, top[k]) * static_cast<double>(m_anatomy.areaMm2[k]);
    return left;
}

void Spoiling::leaveDecay(double share, bool atJunction)
{
    const double whole = decayLeftMm3(m_anatomy.top);
    if (atJunction) {
        // The outermost columns on one side stay as they are.
        std::vector<std::size_t> outermostFirst;
        for (std::size_t k = 0; k < m_wanted.size(); ++k)
            if (decayAbove(k, m_anatomy.top[k]) > 0.0)
                outermostFirst.push_back(k);
        std::sort(outermostFirst.begin(), outermostFirst.end(), [&](std::size_t a, std::size_t b) {
            return m_anatomy.grid.nodeMm(a).x > m_anatomy.grid.nodeMm(b).x;
        });
        for (const std::size_t k : outermostFirst) {
            if (decayLeftMm3(m_wanted) >= share * whole)
                return;
            const double x = m_anatomy.grid.nodeMm(k).x;
            for (std::size_t other = 0; other < m_wanted.size(); ++other)
                if (isCavity(other) && m_anatomy.grid.nodeMm(other).x >= x)
                    set(other, static_cast<double>(m_anatomy.top[other]));
        }
        return;
    }
    double low = -20.0;
    double high = 20.0;
    const std::vector<float> before = m_wanted;
    constexpr int kHalvings = 40;
    for (int n = 0; n < kHalvings; ++n) {
        const double floor = 0.5 * (low + high);
        m_wanted = before;
        eachOfCavity([&](std::size_t, double now) { return std::max(now, floor); });
        (decayLeftMm3(m_wanted) > share * whole ? high : low) = floor;
    }
}

}  // namespace bench
