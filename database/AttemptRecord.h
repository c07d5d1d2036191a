// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "database/Login.h"

namespace database {

/// What one criterion of a score took, out of how much; tenths of a point.
struct CriterionLoss
{
    std::string id;
    int lostTenths = 0;
    int weightTenths = 0;
    bool operator==(const CriterionLoss&) const = default;
};

/// One finished and graded attempt, as it is kept.
struct AttemptRecord
{
    std::int64_t id = 0;      ///< given by the database
    std::string uid;          ///< 32 hex digits, given when it was graded: the same attempt is never kept twice
    PersonId person;          ///< 0: of a guest, or made before there were people
    std::string personUid;    ///< of that person
    std::string finishedUtc;  ///< ISO 8601, "2026-11-20T10:15:00Z"
    std::string tooth;        ///< FDI number or file name
    std::string lessonId;     ///< empty: practised freely, marked as removal of decay
    std::string lessonHash;   ///< of the lesson's content, 64 hex digits; empty without a lesson
    std::string rubricHash;   ///< of the rubric's content
    int scoreTenths = 0;      ///< the machine's; tenths of a point, 0 .. 1000
    bool passed = false;      ///< by the machine: the pass mark was reached and nothing critical went wrong
    int passMarkTenths = 0;
    std::optional<int> givenTenths;     ///< what an instructor gave instead
    std::optional<int> expectedTenths;  ///< what the student had expected before seeing the score
    std::int64_t durationMs = 0;
    std::vector<CriterionLoss> criteria;
    std::string scoreSheetJson;  ///< the whole explanation, so that an old score stays readable
    std::string stateHash;       ///< 16 hex digits of the tooth's state
    std::string recordingHash;   ///< database::digestOf the recording's bytes; empty if it was not kept
    /// "mouse", "pen", "keyboard", "gamepad", "falcon", "simulated"; "pointer" before the first four were told apart.
    std::string device;
    std::string method;    ///< of contact
    int grid = 0;          ///< columns along a side of the tooth
    std::string viewMode;  ///< "flat", "anaglyph" ...
    std::string seed;      ///< of what the lesson drew by chance
    std::string preset;    ///< "natural v1"
    std::string presetHash;
    std::string program;  ///< version of Cusp
    int meanForceMn = 0;  ///< while cutting, millinewtons
    int peakForceMn = 0;
    bool operator==(const AttemptRecord&) const = default;

    /// What counts: the instructor's score, where there is one.
    [[nodiscard]] int countingTenths() const { return givenTenths.value_or(scoreTenths); }
    [[nodiscard]] bool countsAsPassed() const { return givenTenths ? *givenTenths >= passMarkTenths : passed; }
};

/// An exam that was begun: something was cut, or answered.
struct ExamStart
{
    std::string uid;  ///< 32 hex digits, given when it began
    std::string lessonId;
    std::string begunUtc;  ///< ISO 8601
    bool operator==(const ExamStart&) const = default;
};

/// That others have said something of an attempt.
struct Feedback
{
    AttemptId attempt;
    std::string lessonId;
    std::string author;   ///< full name, of who said something last
    std::string saidUtc;  ///< when
    bool isNew = false;   ///< whoever asks has not seen it yet
    bool operator==(const Feedback&) const = default;
};

/// What has been reached in a lesson so far.
struct LessonStanding
{
    std::string lessonId;
    int attempts = 0;
    int bestTenths = 0;
    bool passed = false;  ///< once at least
    std::string lastUtc;  ///< of the newest attempt
    bool operator==(const LessonStanding&) const = default;
};

/// What was done here, as it is noted (see database/sql/Audit.h).
struct AuditRow
{
    std::int64_t seq = 0;  ///< from 1, without a gap
    std::string atUtc;
    std::string actor;  ///< uid of a person; "system"; empty: somebody who was not logged in
    std::string action;
    std::string object;  ///< "person:uid", "attempt:uid", "class:3" ...
    std::string detail;  ///< JSON, keys in order; no names of people, which must be erasable
    std::string hash;
    bool operator==(const AuditRow&) const = default;
};

}  // namespace database
