// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

namespace lessons {

/// One attempt at a lesson: what it came to.
struct AttemptOutcome
{
    int tenths = 0;  ///< of a point, the score that counts
    bool passed = false;
    bool operator==(const AttemptOutcome&) const = default;
};

/// So many attempts tell that somebody is stuck; of fewer nothing is said.
inline constexpr std::size_t kNeedsHelpAfter = 3;
/// To have got better means by so much; less is within what one hand does from day to day.
inline constexpr int kBetterTenths = 50;

/// Whether a student is stuck at a lesson: none of the last three attempts was passed, and neither of the later two is
/// better by five points than what went before it among the three.
///
/// Those before the last three do not count: who was good once and fails now needs help all the same.
/// @param newestFirst  attempts at one lesson
[[nodiscard]] bool needsHelp(std::span<const AttemptOutcome> newestFirst);

}  // namespace lessons
