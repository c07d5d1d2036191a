// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/school/AttemptToCheck.h"

#include <algorithm>
#include <string>
#include <utility>

#include "database/AttemptCheck.h"
#include "lessons/LessonVersion.h"

namespace app {
namespace {

using database::AttemptId;

/// Number of ids that are read at once, besides the postponed ones.
constexpr int kSearched = 10;

std::optional<lessons::Lesson> assignedVersion(const std::string& hash)
{
    auto version = lessons::cachedVersion(hash);
    return version ? std::optional(std::move(*version)) : std::nullopt;
}

}  // namespace

core::Result<std::optional<AttemptToCheck>>
nextToCheck(const database::Repositories& school, const database::Login& who, const std::set<std::int64_t>& postponed)
{
    const auto ids = school.attempts.toCheck(who, kSearched + static_cast<int>(postponed.size()));
    if (!ids)
        return tl::unexpected(ids.error());
    const auto next =
        std::find_if(ids->begin(), ids->end(), [&](AttemptId id) { return !postponed.contains(id.value); });
    if (next == ids->end())
        return std::optional<AttemptToCheck>();
    auto attempt = school.attempts.open(who, *next);
    if (!attempt)
        return tl::unexpected(attempt.error());
    AttemptToCheck toCheck{std::move(*attempt), QByteArray(), {}, {}};
    if (!toCheck.attempt.recordingHash.empty()) {
        auto recording = school.attempts.recording(who, *next);
        if (recording)
            toCheck.recording = std::move(*recording);
        else if (recording.error().code != core::ErrorCode::BadStructure)  // what is damaged proves nothing
            toCheck.recording.reset();
    }
    if (!lessons::isVersionCached(toCheck.attempt.lessonHash))
        toCheck.pack = school.lessons.version(who, toCheck.attempt.lessonHash).value_or(QByteArray());
    auto starts = school.attempts.examStarts(who, toCheck.attempt.person, toCheck.attempt.lessonId);
    if (!starts)
        return tl::unexpected(starts.error());
    toCheck.starts = std::move(*starts);
    return std::optional(std::move(toCheck));
}

database::Doubt check(const AttemptToCheck& toCheck)
{
    const std::string& hash = toCheck.attempt.lessonHash;
    if (!toCheck.pack.isEmpty())
        static_cast<void>(lessons::cacheVersion(hash, toCheck.pack));
    return database::checkAttempt(toCheck.attempt, toCheck.recording.value_or(QByteArray()), assignedVersion(hash),
                                  toCheck.starts);
}

database::Doubt checkArriving(const database::AttemptRecord& attempt, const QByteArray& recording)
{
    return database::checkAttempt(attempt, recording, assignedVersion(attempt.lessonHash));
}

}  // namespace app
