// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "database/AttemptRecord.h"
#include "database/sql/DatabaseContext.h"

namespace database::sql {

/// Stores that a person has begun an exam, as the outbox of this station reports. The same uid is stored once.
[[nodiscard]] core::Status deliverExam(const DatabaseContext& school, const std::string& personUid,
                                       const ExamStart& start);

/// Returns the exams that a person has begun and that have no score, newest first. They include an exam in progress.
[[nodiscard]] core::Result<std::vector<ExamStart>> examsWithoutScore(const DatabaseContext& school,
                                                                     const Login& session, PersonId person);

/// Returns all exams at a lesson that a person has begun, with a score or without.
[[nodiscard]] core::Result<std::vector<ExamStart>> examStarts(const DatabaseContext& school, const Login& session,
                                                              PersonId person, const std::string& lessonId);
/// Returns the number of such exams of a person, by lesson. Does not check permissions.
[[nodiscard]] core::Result<std::map<std::string, int>> countWithoutScore(const DatabaseContext& school,
                                                                         PersonId person);
/// The exams without a score of one person at one lesson, for forEachWithoutScore().
struct WithoutScore
{
    PersonId person;
    std::string lessonId;
    int count = 0;
    std::string newestUtc;  ///< begin of the newest of them
};
[[nodiscard]] core::Status forEachWithoutScore(const DatabaseContext& school, ClassId ofClass,
                                               const std::function<void(const WithoutScore&)>& take);

}  // namespace database::sql
