// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace database {

/// One finished and graded attempt, as it is kept.
struct AttemptRecord
{
    std::int64_t id = 0;      ///< given by the database
    std::string finishedUtc;  ///< ISO 8601, "2026-11-20T10:15:00Z"
    std::string tooth;        ///< FDI number or file name
    std::string lessonId;     ///< empty: practised freely, marked as removal of decay
    std::string lessonHash;   ///< of the lesson's content, 64 hex digits; empty without a lesson
    std::string rubricHash;   ///< of the rubric's content
    int scoreTenths = 0;      ///< tenths of a point, 0 .. 1000
    bool passed = false;
    std::optional<int> expectedTenths;  ///< what the student had expected before seeing the score
    std::int64_t durationMs = 0;
    std::string scoreSheetJson;  ///< the whole explanation, so that an old score stays readable
    std::string stateHash;       ///< 16 hex digits of the tooth's state
    std::string recordingFile;   ///< where the recording lies, empty if it was not saved
    bool operator==(const AttemptRecord&) const = default;
};

/// What has been reached in a lesson so far.
struct LessonStanding
{
    std::string lessonId;
    int attempts = 0;
    int bestTenths = 0;
    bool passed = false;  ///< once at least
    bool operator==(const LessonStanding&) const = default;
};

}  // namespace database
