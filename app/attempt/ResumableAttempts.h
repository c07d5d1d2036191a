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

/// So many of a user's newest attempts are looked at, to find out whether an unfinished one is saved already.
inline constexpr int kNewestKept = 200;

struct FoundUnfinished
{
    std::optional<core::recording::FoundAttempt> attempt = {};
    std::optional<GradedMarker> seen = {};  ///< of an exam whose score was seen, and is nowhere
    std::optional<core::Error> failure = {};
    bool isUndecided = false;  ///< of one that was graded the school has to say first whether it is kept
};
/// The newest attempt in a folder of journals that was not finished. What cannot be read is put aside, unless a later
/// program wrote it, what is kept already is discarded, and one that could not be gone on with waits until it can be.
/// It may take seconds; any thread.
/// @param outbox  of this computer, where attempts wait that the school does not have yet
/// @param toBeKept  journals of what is graded and on its way there: of these it would make two attempts
[[nodiscard]] FoundUnfinished findUnfinished(const std::filesystem::path& folder, const QString& outbox,
                                             const database::KnownAttempts& known,
                                             const std::set<std::filesystem::path>& toBeKept);

/// The lesson whose attempts an attempt would count among; empty: none. That an exam was begun has been counted: to end
/// it takes no other attempt.
[[nodiscard]] std::string limitedLessonOf(const core::recording::Recording& recording);

/// The attempt in this journal was kept as it was after so many events: it is not offered to be gone on with. What was
/// cut on since is another attempt, and stays. It takes as long as a replay; any thread.
void endKept(const std::filesystem::path& journal, std::uint64_t events);

}  // namespace app
