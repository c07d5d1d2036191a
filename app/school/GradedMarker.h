// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace app {

/// Beside a journal: as which attempt its work was graded, before that is kept. Whoever finds the journal of a program
/// that was killed then can tell whether it is work that nobody has.
struct GradedMarker
{
    std::string uid;                         ///< of the attempt
    std::uint64_t events = 0;                ///< of the recording, when it was graded
    std::optional<int> expectedTenths = {};  ///< of a point: the forecast, made before the score was seen
};

/// In place of an earlier one. No end of the program undoes it; where it cannot be written there is none.
void markGraded(const std::filesystem::path& journal, const GradedMarker& mark);
[[nodiscard]] std::optional<GradedMarker> gradedMark(const std::filesystem::path& journal);
void removeGradedMark(const std::filesystem::path& journal);
/// Those of a folder whose journals have gone.
void tidyGradedMarks(const std::filesystem::path& folder);

}  // namespace app
