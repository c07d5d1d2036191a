// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/falcon/AnswerCheck.h"

#include <algorithm>
#include <cmath>

namespace haptics::falcon {
namespace {

constexpr double kMsPerNs = 1.0e-6;
constexpr double kLeastMs = 0.1;           ///< shortest interval between two answers
constexpr double kForgottenMs = 50.0;      ///< after this time the last counts are of no use
constexpr double kConfirmedMs = 3.0;       ///< after this time a second answer has to agree
constexpr double kMostCountsPerMs = 60.0;  ///< about 2 m/s
constexpr int kConfirmed = 3;
constexpr double kRoundingCounts = 1.5;
/// Greatest acceleration of an arm by a hand, counts/ms^2: about 40 m/s^2, as much as the motors reach.
constexpr double kCountsPerMs2 = 1.0;
constexpr double kPaceLagMs = 1.0;  ///< age of the speed

/// Returns the largest permitted difference between a count and the expected one after a time.
constexpr double allowance(double ms)
{
    return kRoundingCounts + kCountsPerMs2 * (0.5 * ms * ms + kPaceLagMs * ms);
}
static_assert(allowance(1.0) == AnswerCheck::kBelievedCounts);

bool isWithin(const glm::dvec3& difference, double most)
{
    return std::abs(difference.x) <= most && std::abs(difference.y) <= most && std::abs(difference.z) <= most;
}

}  // namespace

std::optional<glm::dvec3> AnswerCheck::take(const Answer& answer, std::chrono::nanoseconds taken) noexcept
{
    if (!answer.allHomed())
        return std::nullopt;
    for (const std::int16_t count : answer.counts)
        if (count < kLeastCount || count > kMostCount)
            return std::nullopt;
    const glm::dvec3 counts(answer.counts[0], answer.counts[1], answer.counts[2]);
    const double ms = std::max(kLeastMs, static_cast<double>((taken - m_taken).count()) * kMsPerNs);
    if (ms > kForgottenMs)
        m_known = 0;
    const glm::dvec3 moved = counts - m_counts;
    const bool agrees = m_known >= 2 ? isWithin(moved - m_countsPerMs * ms, allowance(ms))
                                     : m_known == 1 && isWithin(moved, kMostCountsPerMs * ms);
    if (m_known == kConfirmed && !agrees)
        return std::nullopt;
    if (!agrees)
        m_countsPerMs = glm::dvec3(0.0);
    else
        m_countsPerMs += (moved / ms - m_countsPerMs) * (m_known == 1 ? 1.0 : ms / (ms + kPaceLagMs));
    m_known = agrees ? std::min(m_known + 1, kConfirmed) : 1;
    // After a pause the tolerance is so wide that a corrupted count may be within it. So the next count has to agree.
    if (m_known == kConfirmed && ms > kConfirmedMs)
        m_known = kConfirmed - 1;
    m_counts = counts;
    m_taken = taken;
    return m_known == kConfirmed ? std::optional(counts) : std::nullopt;
}

}  // namespace haptics::falcon
