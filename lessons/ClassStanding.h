// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

namespace lessons {

/// Least number of people for which results of others are shown. With fewer, a student could infer whose results they
/// are (docs/facts/teaching.md, section 6).
inline constexpr int kFewestPeople = 5;

/// The rank of a result within a class.
struct ClassStanding
{
    int people = 0;
    /// Share of people with a lower result, per cent; people with an equal result do not count. Empty for fewer than
    /// kFewestPeople.
    std::optional<double> percentBelow;
    bool operator==(const ClassStanding&) const = default;
};

/// Computes the rank of a result, in tenths of a point.
/// @param bestOfEach  each person's best result by the same rubric, tenths of a point
[[nodiscard]] ClassStanding classStanding(int tenths, std::span<const int> bestOfEach);

}  // namespace lessons
