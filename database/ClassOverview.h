// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "database/Login.h"

/// What a teacher sees of a class, and everybody of an attempt. Plain values, filled by database/sql/Overview.
namespace database {

/// How a class does at one lesson, attempt by attempt: the band behind a student's own curve, and the learning curve.
/// Empty for fewer than lessons::kFewestPeople people.
struct BandPoint
{
    int attempt = 0;  ///< first, second ...
    int people = 0;   ///< who made so many; never fewer than lessons::kFewestPeople
    int lowerQuartileTenths = 0;
    int medianTenths = 0;
    int upperQuartileTenths = 0;
    bool operator==(const BandPoint&) const = default;
};

/// Half of a class's attempts at a lesson are better than this, and half quicker. Nothing for too few people.
struct LessonMedians
{
    int people = 0;
    int tenths = 0;
    std::int64_t durationMs = 0;
    bool operator==(const LessonMedians&) const = default;
};

/// Of one student at one lesson. Scores are those that count.
struct MatrixCell
{
    int attempts = 0;  ///< 0: never tried
    int bestTenths = 0;
    bool passed = false;
    std::string lastUtc;
    int withoutScore = 0;                    ///< exams that were begun, which count as attempts as well
    std::optional<int> limitElsewhere = {};  ///< that his other classes were given; the most generous, 0: none at all
    std::string begunUtc = {};               ///< the newest of the exams without a score, which may go on still
    bool operator==(const MatrixCell&) const = default;

    /// He has not passed, and may not try again: sql::attemptsLeft() tells him so.
    /// @param limit  that this class was given; 0: none
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
    std::vector<int> recentTenths;   ///< of his last attempts at the lesson he tried last, newest first, at most five
    std::vector<bool> recentPassed;  ///< the same
    std::string recentLesson;        ///< its id
    bool isDisabled = false;         ///< he comes no more, needs nobody, and counts nowhere
    bool operator==(const MatrixStudent&) const = default;
};

/// Students by lessons.
struct ClassOverview
{
    ClassId id;
    std::string name;
    std::vector<MatrixStudent> students;         ///< by family name
    std::vector<std::string> lessons;            ///< ids: those that were assigned, then those tried, by id
    std::vector<std::vector<MatrixCell>> cells;  ///< [student][lesson]
    bool operator==(const ClassOverview&) const = default;
};

/// How hard a lesson is for a class.
struct LessonDifficulty
{
    std::string lessonId;
    int people = 0;               ///< who tried it
    int passed = 0;               ///< of them
    double meanTenths = 0.0;      ///< of everybody's first attempt
    double attemptsToPass = 0.0;  ///< mean of those who passed
    /// What each criterion takes of its weight on average, 0 .. 1, hardest first.
    struct Item
    {
        std::string criterion;
        double share = 0.0;
        bool operator==(const Item&) const = default;
    };
    std::vector<Item> items;
    bool operator==(const LessonDifficulty&) const = default;
};

/// Everything a class has done at one lesson, for its charts. No names.
struct LessonResults
{
    std::string lessonId;
    std::vector<int> bestTenths;  ///< of each student, ascending
    std::vector<BandPoint> curve;
    LessonDifficulty difficulty;
    bool operator==(const LessonResults&) const = default;
};

/// Characters of a comment, and of the reason for another score (0004_attempts_of_people.sql).
inline constexpr int kLongestComment = 4000;

struct AttemptComment
{
    std::int64_t id = 0;
    std::string author;  ///< full name
    std::string writtenUtc;
    std::string words;
    std::optional<std::array<double, 3>> placeMm;  ///< in the tooth's frame
    std::optional<std::int64_t> momentMs;          ///< since the attempt began
    bool isMine = false;                           ///< written by who reads it, and so his to take back
    bool operator==(const AttemptComment&) const = default;
};

struct AttemptOverride
{
    std::string author;
    std::string givenUtc;
    std::optional<int> givenTenths;  ///< nothing: the machine's score counts again
    std::string reason;
    bool operator==(const AttemptOverride&) const = default;
};

/// What people have said of an attempt, oldest first.
struct AttemptTalk
{
    std::vector<AttemptComment> comments;
    std::vector<AttemptOverride> overrides;
    bool operator==(const AttemptTalk&) const = default;
};

}  // namespace database
