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
        Way,     ///< in the process (time, force, air): when the value crossed its limit
        Never    ///< by no action: the points were missing from the start and were never earned
    };
    Kind kind = Kind::Never;
    int lostTenths = 0;       ///< tenths of a point; 0 only for a critical criterion if no points were left
    std::uint64_t tick = 0;   ///< tick in which it happened first; Never: last tick of the attempt
    double seconds = 0.0;     ///< start of that tick, from the start of the attempt; Never: end of the attempt
    int stroke = 0;           ///< from 1, as numbered by core::recording::Player; 0: between two strokes
    double feedMmPerS = 0.0;  ///< Stroke: highest speed, over 0.1 s, at which the bur went down while it cut
    bool operator==(const Moment&) const = default;
};

/// A score with the moments at which its points were lost.
struct PointLossTimeline
{
    ScoreSheet sheet;
    /// For each criterion of the sheet, in order of time, Never first. Their sum is exactly what the criterion lost.
    std::vector<std::vector<Moment>> ofCriteria;
};

/// Replays an attempt. For each tenth of a point that is missing at the end, finds the moment after which it stayed
/// missing (docs/scoring.md, "When a point was lost").
///
/// The tooth is graded after each stroke, and every second within a long one. Criteria of the process are graded every
/// 10 ms. So a moment is exact to a second of cutting, or to 10 ms. If the student undid a stroke, its losses are
/// removed; if they redid it, the losses are restored. Costs the replay and some milliseconds per stroke: an attempt of
/// minutes takes seconds. Any thread.
/// @param goOn  called repeatedly with the share done, 0 to 1; returns false to cancel, and the result is then empty
[[nodiscard]] core::Result<std::optional<PointLossTimeline>> momentsOf(const Assignment& assignment,
                                                                       const core::recording::Recording& recording,
                                                                       const std::function<bool(double)>& goOn = {});

}  // namespace lessons
