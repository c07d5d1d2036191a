// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace app {

/// The content of a file beside the journal of an attempt that was graded but is not in the outbox yet. If the program
/// is killed before that, the next start finds in this file that the work in the journal was graded.
struct GradedMarker
{
    std::string uid;                         ///< uid of the attempt
    std::uint64_t events = 0;                ///< number of events in the recording when it was graded
    std::optional<int> expectedTenths = {};  ///< the score that the student predicted, in tenths of a point
};

/// Writes the marker of a journal, and replaces an earlier one. Does not report an error if the file cannot be written.
void markGraded(const std::filesystem::path& journal, const GradedMarker& mark);
/// Returns the marker of a journal, or nullopt if it has none.
[[nodiscard]] std::optional<GradedMarker> gradedMark(const std::filesystem::path& journal);
void removeGradedMark(const std::filesystem::path& journal);
/// Removes the markers in a folder that have no journal any more.
void tidyGradedMarks(const std::filesystem::path& folder);

}  // namespace app
