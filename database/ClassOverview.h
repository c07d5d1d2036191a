// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "database/Login.h"

/// Data of a class for its teacher, and of an attempt for all users who may see it. Plain values, which
/// database/sql/Overview.h returns.
namespace database {

/// One point of the band of a class's scores at a lesson: the scores of the nth attempts. The band is shown behind a
/// student's own curve and as learning curve of the class. It is empty for fewer than lessons::kFewestPeople people.
struct BandPoint
{
    int attempt = 0;  ///< first, second ...
    int people = 0;   ///< number of people with that many attempts; never fewer than lessons::kFewestPeople
    int lowerQuartileTenths = 0;
    int medianTenths = 0;
    int upperQuartileTenths = 0;
    bool operator==(const BandPoint&) const = default;
};

/// Medians of score and time over a class's attempts at a lesson.
struct LessonMedians
{
    int people = 0;
    int tenths = 0;
    std::int64_t durationMs = 0;
    bool operator==(const LessonMedians&) const = default;
};

/// The results of one student at one lesson. Scores are those that count.
struct MatrixCell
{
    int attempts = 0;  ///< 0: not tried
    int bestTenths = 0;
    bool passed = false;
    std::string lastUtc;
    int withoutScore = 0;                    ///< exams that were begun, which also count as attempts
    std::optional<int> limitElsewhere = {};  ///< highest limit in the student's other classes; 0: no limit
    std::string begunUtc = {};               ///< begin of the newest exam without a score, which may still run
    int inDoubt = 0;                         ///< attempts that do not match their recordings and have no given score
    bool operator==(const MatrixCell&) const = default;

    /// Returns whether the student has not passed and has no attempt left, as sql::attemptsLeft() reports.
    /// @param limit  limit of this class; 0: none
    [[nodiscard]] bool isUsedUp(int limit) const
    {
        const bool isLimited = limit > 0 && limitElsewhere.value_or(limit) > 0;
        return isLimited && !passed && attempts + withoutScore >= std::max(limit, limitElsewhere.value_or(0));
    }
};

struct MatrixStudent
{
    PersonId id;
    std::string username;
    std::string fullName;
    std::string lastLoginUtc;        ///< empty: never
    std::string lastAttemptUtc;      ///< empty: none
    std::vector<int> recentTenths;   ///< of the last attempts at the lesson tried last, newest first, at most five
    std::vector<bool> recentPassed;  ///< of the same attempts
    std::string recentLesson;        ///< id of that lesson
    bool isDisabled = false;         ///< the account is disabled: the student needs no help and does not count
    bool operator==(const MatrixStudent&) const = default;
};

/// The results of the students of a class, by lesson.
struct ClassOverview
{
    ClassId id;
    std::string name;
    std::vector<MatrixStudent> students;         ///< by family name
    std::vector<std::string> lessons;            ///< ids: assigned lessons first, then other lessons tried, by id
    std::vector<std::vector<MatrixCell>> cells;  ///< [student][lesson]
    bool operator==(const ClassOverview&) const = default;
};

/// The difficulty of a lesson for a class.
struct LessonDifficulty
{
    std::string lessonId;
    int people = 0;               ///< number who tried it
    int passed = 0;               ///< number who passed
    double meanTenths = 0.0;      ///< of the first attempts
    double attemptsToPass = 0.0;  ///< mean over those who passed
    /// The average share of its weight that each criterion cost, 0 to 1, hardest first.
    struct Item
    {
        std::string criterion;
        double share = 0.0;
        bool operator==(const Item&) const = default;
    };
    std::vector<Item> items;
    bool operator==(const LessonDifficulty&) const = default;
};

/// The results of a class at one lesson, for its charts. Without names.
struct LessonResults
{
    std::string lessonId;
    std::vector<int> bestTenths;  ///< of each student, ascending
    std::vector<BandPoint> curve;
    LessonDifficulty difficulty;
    bool operator==(const LessonResults&) const = default;
};

/// Largest number of characters of a comment, and of the reason for another score (0004_attempts_of_people.sql).
inline constexpr int kLongestComment = 4000;

struct AttemptComment
{
    std::int64_t id = 0;
    std::string author;  ///< full name
    std::string writtenUtc;
    std::string words;
    std::optional<std::array<double, 3>> placeMm;  ///< tooth frame
    std::optional<std::int64_t> momentMs;          ///< from the start of the attempt
    bool isMine = false;                           ///< the user wrote it and may withdraw it
    bool operator==(const AttemptComment&) const = default;
};

/// A new comment, to be added to an attempt.
struct NewComment
{
    std::string words;
    std::optional<std::array<double, 3>> placeMm;  ///< in the tooth's frame
    std::optional<std::int64_t> momentMs;          ///< since the attempt began
};

struct AttemptOverride
{
    std::string author;
    std::string givenUtc;
    std::optional<int> givenTenths;  ///< empty: the computed score counts again
    std::string reason;
    bool operator==(const AttemptOverride&) const = default;
};

/// The comments on an attempt and its overrides, oldest first.
struct AttemptTalk
{
    std::vector<AttemptComment> comments;
    std::vector<AttemptOverride> overrides;
    bool operator==(const AttemptTalk&) const = default;
};

}  // namespace database
