// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/settings/PedalLearner.h"

#include <cmath>
#include <cstddef>

namespace core::settings {
namespace {

constexpr double kBackShare = 0.25;    ///< of the travel: a pedal this near to its first reading is released
constexpr double kSteadyShare = 0.02;  ///< of the travel: largest movement of a resting pedal between two readings

double readingOf(float raw, double before)
{
    return std::isfinite(raw) ? static_cast<double>(raw) : before;
}

}  // namespace

int PedalLearner::movedAxis() const
{
    int moved = -1;
    double most = kLeastTravel;
    for (std::size_t k = 0; k < m_axes.size(); ++k) {
        const double travel = std::abs(m_axes[k].farthest - m_axes[k].first);
        if (travel >= most) {
            most = travel;
            moved = static_cast<int>(k);
        }
    }
    return moved;
}

std::optional<PedalLearner::Learnt> PedalLearner::update(std::span<const float> axes, double seconds)
{
    if (axes.size() != m_axes.size()) {
        m_axes.clear();
        m_settledS = 0.0;
        for (const float raw : axes) {
            const double reading = readingOf(raw, 0.0);
            m_axes.push_back({reading, reading, reading});
        }
        return std::nullopt;
    }
    const int moved = movedAxis();
    bool isSettled = false;
    for (std::size_t k = 0; k < axes.size(); ++k) {
        Axis& axis = m_axes[k];
        const double reading = readingOf(axes[k], axis.before);
        if (static_cast<int>(k) == moved) {
            const double travel = std::abs(axis.farthest - axis.first);
            isSettled = std::abs(reading - axis.first) < kBackShare * travel &&
                        std::abs(reading - axis.before) < kSteadyShare * travel;
        }
        if (std::abs(reading - axis.first) > std::abs(axis.farthest - axis.first))
            axis.farthest = reading;
        axis.before = reading;
    }
    m_settledS = isSettled ? m_settledS + seconds : 0.0;
    if (moved < 0 || m_settledS < kSettlesAfterS)
        return std::nullopt;
    const Axis& axis = m_axes[static_cast<std::size_t>(moved)];
    return Learnt{moved, axis.before, axis.farthest};
}

}  // namespace core::settings
