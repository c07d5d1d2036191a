// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

namespace lessons {

/// The result of one attempt at a lesson.
struct AttemptOutcome
{
    int tenths = 0;  ///< of a point, the score that counts
    bool passed = false;
    bool operator==(const AttemptOutcome&) const = default;
};

/// Number of attempts that are considered; with fewer attempts, needsHelp() returns false.
inline constexpr std::size_t kNeedsHelpAfter = 3;
/// Least improvement that counts. A smaller one is within day-to-day variation.
inline constexpr int kBetterTenths = 50;

/// Returns whether a student needs help with a lesson: none of the last three attempts was passed, and neither the
/// second nor the third is better by five points than the attempts before it.
///
/// Earlier attempts do not count: a student who was good once and fails now needs help, too.
/// @param newestFirst  attempts at one lesson
[[nodiscard]] bool needsHelp(std::span<const AttemptOutcome> newestFirst);

}  // namespace lessons
