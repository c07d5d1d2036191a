// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "core/recording/Recording.h"
#include "lessons/Assignment.h"

namespace lessons {

/// When some of the points of a criterion were lost.
struct Moment
{
    enum class Kind : std::uint8_t {
        Stroke,  ///< by cutting
        Way,     ///< by how it was done (time, force, air): when the value crossed
        Never    ///< by nothing that was done: they were missing from the beginning, and were never earned
    };
    Kind kind = Kind::Never;
    int lostTenths = 0;      ///< tenths of a point; 0 only for a critical criterion that found none left to take
    std::uint64_t tick = 0;  ///< the first in which it happened; Never: the last of the attempt
    double seconds = 0.0;  ///< when that tick began, since the beginning of the attempt; Never: when the attempt ended
    int stroke = 0;        ///< from 1, as core::recording::Player counts them; 0: between two
    double feedMmPerS = 0.0;  ///< Stroke: highest speed at which the bur went down while it cut, over 0.1 s
    bool operator==(const Moment&) const = default;
};

/// How a score came about.
struct PointLossTimeline
{
    ScoreSheet sheet;
    /// For each criterion of the sheet, in the order of time, Never first. They make up what it lost, exactly.
    std::vector<std::vector<Moment>> ofCriteria;
};

/// Replays an attempt and finds for each tenth of a point that is missing at the end since when it has been missing for
/// good (docs/scoring.md, "When a point was lost").
///
/// The tooth is marked after each stroke, in a long one every second, and what depends on the way alone every 10 ms; so
/// a moment is known to a second of cutting, or to 10 ms. What is taken back takes its moments along, and done again
/// has them again. Costs the replay and some milliseconds a stroke: minutes of work take seconds. Any thread.
/// @param goOn  asked now and then with the share that is done, 0 .. 1; false: leave off, and answer nothing
[[nodiscard]] core::Result<std::optional<PointLossTimeline>> momentsOf(const Assignment& assignment,
                                                                       const core::recording::Recording& recording,
                                                                       const std::function<bool(double)>& goOn = {});

}  // namespace lessons
