// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace app {

/// A file beside the journal of an attempt that was graded and is not in the outbox yet. If the program is killed then,
/// the next start finds that the work in the journal was graded.
struct GradedMarker
{
    std::string uid;                         ///< of the attempt
    std::uint64_t events = 0;                ///< of the recording, when it was graded
    std::optional<int> expectedTenths = {};  ///< the score that the student predicted, in tenths of a point
};

/// Writes the marker of a journal, in place of an earlier one; it stays on the disk when the program is killed. If it
/// cannot be written, there is none.
void markGraded(const std::filesystem::path& journal, const GradedMarker& mark);
/// Empty: there is no marker.
[[nodiscard]] std::optional<GradedMarker> gradedMark(const std::filesystem::path& journal);
void removeGradedMark(const std::filesystem::path& journal);
/// Removes the markers in a folder whose journals are gone.
void tidyGradedMarks(const std::filesystem::path& folder);

}  // namespace app
