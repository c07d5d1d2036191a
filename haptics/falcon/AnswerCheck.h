// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <chrono>
#include <optional>

#include <glm/vec3.hpp>

#include "haptics/falcon/Packets.h"

namespace haptics::falcon {

/// Decides which answers are believed. The protocol has no checksum, so a byte that was spoilt on its way may decode to
/// another position. A count is believed if the arm can have come there: it is compared with the one that the last
/// counts lead to, and may differ by what a hand can accelerate. So a spoilt count is either refused or within
/// about kBelievedCounts of the real one, a seventh of a millimetre. After answers that are missing the allowance is
/// larger, and the first one is believed when the next one agrees.
///
/// Device thread. Never allocates.
class AnswerCheck
{
public:
    /// No arm reaches these angles: from -25 to 90 degrees.
    static constexpr int kLeastCount = -1650;
    static constexpr int kMostCount = 1510;
    /// Greatest difference from the expected count one millisecond after the last answer that was believed.
    static constexpr double kBelievedCounts = 3.0;

    /// Forgets the last counts: three answers that agree are needed then before one is believed.
    void restart() noexcept { m_known = 0; }

    /// @param taken  when the device took the counts
    /// @returns the counts if they are believed; empty if not, or if an arm is not homed
    [[nodiscard]] std::optional<glm::dvec3> take(const Answer& answer, std::chrono::nanoseconds taken) noexcept;

private:
    int m_known = 0;  ///< number of answers that agreed, at most 3
    glm::dvec3 m_counts{0.0};
    glm::dvec3 m_countsPerMs{0.0};
    std::chrono::nanoseconds m_taken{0};
};

}  // namespace haptics::falcon
