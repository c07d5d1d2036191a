// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "core/recording/Recording.h"
#include "lessons/Assignment.h"

namespace lessons {

/// A moment at which points of a criterion were lost.
struct Moment
{
    enum class Kind : std::uint8_t {
        Stroke,  ///< by cutting
        Way,     ///< by the process (time, force, air): when the value crossed the limit
        Never    ///< by no action: the points were missing from the start and never earned
    };
    Kind kind = Kind::Never;
    int lostTenths = 0;       ///< tenths of a point; 0 only for a critical criterion when no points were left
    std::uint64_t tick = 0;   ///< the first in which it happened; Never: the last of the attempt
    double seconds = 0.0;     ///< start of that tick, from the start of the attempt; Never: end of the attempt
    int stroke = 0;           ///< from 1, as numbered by core::recording::Player; 0: between two
    double feedMmPerS = 0.0;  ///< Stroke: highest speed at which the bur went down while it cut, over 0.1 s
    bool operator==(const Moment&) const = default;
};

/// A score with the moments at which its points were lost.
struct PointLossTimeline
{
    ScoreSheet sheet;
    /// For each criterion of the sheet, in order of time, Never first. Their sum is exactly what the criterion lost.
    std::vector<std::vector<Moment>> ofCriteria;
};

/// Replays an attempt and finds for each tenth of a point that is missing at the end the moment from which on it stayed
/// missing (docs/scoring.md, "When a point was lost").
///
/// The tooth is graded after each stroke, within a long one every second, and criteria of the process alone every 10
/// ms; so a moment is exact to a second of cutting, or to 10 ms. Undone strokes lose their moments, and repeating them
/// brings them back. Costs the replay and some milliseconds per stroke: minutes of work take seconds. Any thread.
/// @param goOn  called now and then with the share done, 0 to 1; false cancels, and the result is empty
[[nodiscard]] core::Result<std::optional<PointLossTimeline>> momentsOf(const Assignment& assignment,
                                                                       const core::recording::Recording& recording,
                                                                       const std::function<bool(double)>& goOn = {});

}  // namespace lessons
