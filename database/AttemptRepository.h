// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/Result.h"
#include "database/records.h"

namespace database {

/// The history of graded attempts. Thread: the one that opened the store. Every failure is a sentence that names the
/// store and says what to do.
class AttemptRepository
{
public:
    virtual ~AttemptRepository() = default;

    /// Keeps an attempt; the record's own id is ignored, the new one is returned. It is on the disk when this returns.
    [[nodiscard]] virtual core::Result<std::int64_t> add(const AttemptRecord& attempt) = 0;
    /// The last attempts at one tooth, newest first, at most `limit`.
    [[nodiscard]] virtual core::Result<std::vector<AttemptRecord>> byTooth(const std::string& tooth, int limit) = 0;
    /// The last attempts at one lesson, newest first, at most `limit`.
    [[nodiscard]] virtual core::Result<std::vector<AttemptRecord>> byLesson(const std::string& lessonId, int limit) = 0;
    /// Every lesson that was ever attempted, by its id.
    [[nodiscard]] virtual core::Result<std::vector<LessonStanding>> standings() = 0;
    /// The last attempts at any tooth, newest first, at most `limit`.
    [[nodiscard]] virtual core::Result<std::vector<AttemptRecord>> recent(int limit) = 0;
    /// The attempt with the highest score at a tooth, the first to reach it; nothing if the tooth was never graded.
    [[nodiscard]] virtual core::Result<std::optional<AttemptRecord>> best(const std::string& tooth) = 0;
};

}  // namespace database
