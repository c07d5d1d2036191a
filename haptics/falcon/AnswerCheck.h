// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <chrono>
#include <optional>

#include <glm/vec3.hpp>

#include "haptics/falcon/Packets.h"

namespace haptics::falcon {

/// Decides which answers are accepted. The protocol has no checksum, so a corrupted byte may decode to another
/// position. A count is accepted if the arm can have reached it: it is compared with the count extrapolated from the
/// last ones, and may differ by as much as a hand can accelerate. So a corrupted count is either refused, or differs
/// from the real one by at most about kBelievedCounts, a seventh of a millimetre. After missing answers the tolerance
/// is larger, and the first answer is accepted only when the next one agrees.
///
/// Device thread. Never allocates.
class AnswerCheck
{
public:
    /// Range of the counts: no arm can leave -25 to 90 degrees.
    static constexpr int kLeastCount = -1650;
    static constexpr int kMostCount = 1510;
    /// Largest difference from the expected count one millisecond after the last accepted answer.
    static constexpr double kBelievedCounts = 3.0;

    /// Forgets the last counts. Three answers that agree are then needed before one is accepted.
    void restart() noexcept { m_known = 0; }

    /// Checks an answer.
    /// @param taken  when the device took the counts
    /// @returns the counts if they are accepted; empty if not, or if an arm is not homed
    [[nodiscard]] std::optional<glm::dvec3> take(const Answer& answer, std::chrono::nanoseconds taken) noexcept;

private:
    int m_known = 0;  ///< number of answers that agree, at most 3
    glm::dvec3 m_counts{0.0};
    glm::dvec3 m_countsPerMs{0.0};
    std::chrono::nanoseconds m_taken{0};
};

}  // namespace haptics::falcon
