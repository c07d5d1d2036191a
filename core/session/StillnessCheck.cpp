// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/StillnessCheck.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace core::session {
namespace {

/// Sum of positions, to compute their mean.
struct Sum
{
    glm::dvec3 placeMm{0.0};
    double count = 0.0;

    void add(glm::dvec3 place)
    {
        placeMm += place;
        count += 1.0;
    }
    void remove(glm::dvec3 place)
    {
        placeMm -= place;
        count -= 1.0;
    }
    [[nodiscard]] glm::dvec3 mean() const { return placeMm / count; }
};

}  // namespace

void StillnessCheck::add(double timeS, glm::dvec3 placeMm)
{
    const bool isFinite =
        std::isfinite(timeS) && std::isfinite(placeMm.x) && std::isfinite(placeMm.y) && std::isfinite(placeMm.z);
    if (!isFinite || timeS < 0.0 || isOver())
        return;
    m_timeS = std::max(m_timeS, timeS);
    if (timeS <= kDurationS && (m_places.empty() || timeS >= m_places.back().timeS + 1.0 / kMostHz))
        m_places.push_back({timeS, placeMm});
}

double StillnessCheck::progress() const
{
    return std::min(1.0, m_timeS / kDurationS);
}

std::optional<Stillness> StillnessCheck::result() const
{
    Sum first;
    Sum last;
    for (const Place& place : m_places) {
        if (place.timeS < kEdgeS)
            first.add(place.placeMm);
        if (place.timeS >= kDurationS - kEdgeS)
            last.add(place.placeMm);
    }
    const bool isEnough = static_cast<double>(m_places.size()) >= kLeastHz * kDurationS &&
                          std::min(first.count, last.count) >= 0.5 * kLeastHz * kEdgeS;
    if (!isOver() || !isEnough)
        return std::nullopt;
    Sum window;
    std::size_t from = 0;
    std::size_t to = 0;
    double squares = 0.0;
    for (const Place& place : m_places) {
        while (to < m_places.size() && m_places[to].timeS <= place.timeS + 0.5 * kMeanS)
            window.add(m_places[to++].placeMm);
        while (m_places[from].timeS < place.timeS - 0.5 * kMeanS)
            window.remove(m_places[from++].placeMm);
        const glm::dvec3 apart = place.placeMm - window.mean();
        squares += glm::dot(apart, apart);
    }
    return Stillness{glm::distance(first.mean(), last.mean()),
                     std::sqrt(squares / static_cast<double>(m_places.size()))};
}

}  // namespace core::session
