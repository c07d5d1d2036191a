// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <string>

#include <QString>

#include "app/school/GradedMarker.h"
#include "core/recording/JournalFile.h"
#include "core/recording/Recording.h"
#include "database/Person.h"
#include "database/Repositories.h"

namespace app {

/// The number of a user's newest attempts that are read to find out whether an unfinished attempt is already saved.
inline constexpr int kNewestKept = 200;

/// The result of findUnfinished().
struct FoundUnfinished
{
    std::optional<core::recording::FoundAttempt> attempt = {};
    std::optional<GradedMarker> seen = {};  ///< set if the student saw the score but it was not saved
    std::optional<core::Error> failure = {};
    bool isUndecided = false;  ///< the database must first answer whether it has a graded attempt
};
/// Returns the newest unfinished attempt in a folder of journals. Discards journals that cannot be read, unless a newer
/// version of the program wrote them, and journals whose attempt is finished or already saved. Skips an attempt at a
/// lesson at which the student has no attempt left. May take seconds; any thread.
/// @param outbox    outbox folder of this computer, with the attempts that are not in the database yet
/// @param toBeKept  journals to skip, because their graded attempts are on the way to the outbox and would count twice
[[nodiscard]] FoundUnfinished findUnfinished(const std::filesystem::path& folder, const QString& outbox,
                                             const database::KnownAttempts& known,
                                             const std::set<std::filesystem::path>& toBeKept);

/// Returns the id of the lesson at which a recording would count as another attempt; empty if there is none. Returns an
/// empty string for an exam, which counted as an attempt when it began.
[[nodiscard]] std::string limitedLessonOf(const core::recording::Recording& recording);

/// Discards the journal of an attempt that has been saved, so that the attempt is not offered to be resumed. If the
/// student cut on after that, this is another attempt, and the journal stays. Takes as long as a replay; any thread.
/// @param events  number of events in the recording that was saved
void endKept(const std::filesystem::path& journal, std::uint64_t events);

}  // namespace app
