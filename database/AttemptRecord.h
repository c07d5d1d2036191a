// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "database/Doubt.h"
#include "database/Login.h"

namespace database {

/// The loss of one criterion of a score and its weight; tenths of a point.
struct CriterionLoss
{
    std::string id;
    int lostTenths = 0;
    int weightTenths = 0;
    bool operator==(const CriterionLoss&) const = default;
};

/// A finished and graded attempt, as stored in the database.
struct AttemptRecord
{
    std::int64_t id = 0;      ///< assigned by the database
    std::string uid;          ///< 32 hex digits, assigned when it was graded, so that no attempt is stored twice
    PersonId person;          ///< 0: a guest, or an attempt from before Cusp had accounts
    std::string personUid;    ///< of that person
    std::string finishedUtc;  ///< ISO 8601, "2026-11-20T10:15:00Z"
    std::string tooth;        ///< FDI number or file name
    std::string lessonId;     ///< empty: free practice, graded as removal of decay
    std::string lessonHash;   ///< of the lesson's content, 64 hex digits; empty without a lesson
    std::string rubricHash;   ///< of the rubric's content
    int scoreTenths = 0;      ///< the computed score; tenths of a point, 0 to 1000
    bool passed = false;      ///< by the computed score: it reached the pass mark, without a critical error
    int passMarkTenths = 0;
    std::optional<int> givenTenths;     ///< the instructor's score, which overrides the computed one
    std::optional<int> expectedTenths;  ///< the score that the student expected before seeing it
    std::int64_t durationMs = 0;
    std::vector<CriterionLoss> criteria;
    std::string scoreSheetJson;  ///< the complete sheet, so that an old score stays readable
    std::string stateHash;       ///< 16 hex digits of the tooth's state
    std::string recordingHash;   ///< database::digestOf() the recording's bytes; empty if it was not stored
    /// "mouse", "pen", "keyboard", "gamepad", "falcon", "simulated"; "pointer" in old attempts instead of the first
    /// four.
    std::string device;
    std::string method;    ///< contact method
    int grid = 0;          ///< columns along a side of the tooth
    std::string viewMode;  ///< "flat", "anaglyph" ...
    std::string seed;      ///< seed of the random parts of the lesson
    std::string preset;    ///< "natural v1"
    std::string presetHash;
    std::string program;  ///< version of Cusp
    int meanForceMn = 0;  ///< while cutting, millinewtons
    int peakForceMn = 0;
    Doubt doubt = Doubt::None;
    bool operator==(const AttemptRecord&) const = default;

    /// Returns whether the attempt counts: it is not in doubt, or a teacher has given it a score.
    [[nodiscard]] bool counts() const { return doubt == Doubt::None || givenTenths; }

    /// Returns the score that counts: the instructor's if there is one, otherwise the computed score.
    [[nodiscard]] int countingTenths() const { return givenTenths.value_or(scoreTenths); }
    [[nodiscard]] bool countsAsPassed() const
    {
        return givenTenths ? *givenTenths >= passMarkTenths : passed && doubt == Doubt::None;
    }
};

/// Selects attempts of a person.
struct HistoryQuery
{
    std::string lessonId;  ///< empty: of any lesson
    std::string tooth;     ///< not empty: practice without a lesson, at this tooth
    int limit = 0;         ///< largest number of attempts; 0: all
};

/// An exam that was begun: the student has cut or answered something.
struct ExamStart
{
    std::string uid;  ///< 32 hex digits, assigned when it began
    std::string lessonId;
    std::string begunUtc;  ///< ISO 8601
    bool operator==(const ExamStart&) const = default;
};

/// Feedback of other people on an attempt.
struct Feedback
{
    AttemptId attempt;
    std::string lessonId;
    std::string author;   ///< full name of the author of the newest feedback
    std::string saidUtc;  ///< time of the newest feedback
    bool isNew = false;   ///< the user has not seen it yet
    bool operator==(const Feedback&) const = default;
};

/// A stored score sheet.
struct KeptSheet
{
    std::string finishedUtc;
    std::string json;
};

/// A person's results in a lesson so far.
struct LessonStanding
{
    std::string lessonId;
    int attempts = 0;
    int bestTenths = 0;
    bool passed = false;  ///< at least once
    std::string lastUtc;  ///< of the newest attempt
    bool operator==(const LessonStanding&) const = default;
};

/// A row of the audit log (see database/sql/Audit.h).
struct AuditRow
{
    std::int64_t seq = 0;  ///< from 1, without gaps
    std::string atUtc;
    std::string actor;  ///< uid of a person; "system"; empty: a person who was not logged in
    std::string action;
    std::string object;  ///< "person:uid", "attempt:uid", "class:3" ...
    std::string detail;  ///< JSON, keys in order; without names of people, which must be erasable
    std::string hash;
    bool operator==(const AuditRow&) const = default;
};

}  // namespace database
