// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

namespace lessons {

/// Of fewer people nobody is told how the others did: one could make out who did what (docs/facts/teaching.md, section
/// 6).
inline constexpr int kFewestPeople = 5;

/// Where a result stands among those of a class.
struct ClassStanding
{
    int people = 0;
    /// Of 100 people so many have less; those who have as much do not count. Nothing for fewer than kFewestPeople.
    std::optional<double> percentBelow;
    bool operator==(const ClassStanding&) const = default;
};

/// @param bestOfEach  each person's best result by the same rubric, tenths of a point
[[nodiscard]] ClassStanding classStanding(int tenths, std::span<const int> bestOfEach);

}  // namespace lessons
