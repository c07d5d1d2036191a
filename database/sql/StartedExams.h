// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "database/AttemptRecord.h"
#include "database/sql/DatabaseContext.h"

namespace database::sql {

/// Stores that a person has begun an exam, from this station's outbox. The same uid is stored once.
[[nodiscard]] core::Status deliverExam(const DatabaseContext& school, const std::string& personUid,
                                       const ExamStart& start);

/// Returns the exams of a person that were begun and have no score, newest first, including a running one.
[[nodiscard]] core::Result<std::vector<ExamStart>> examsWithoutScore(const DatabaseContext& school,
                                                                     const Login& session, PersonId person);

/// Returns the number of such exams in one lesson; without a permission check.
[[nodiscard]] core::Result<int> countWithoutScore(const DatabaseContext& school, PersonId person,
                                                  const std::string& lessonId);
/// The number of such exams of one person in one lesson.
struct WithoutScore
{
    PersonId person;
    std::string lessonId;
    int count = 0;
    std::string newestUtc;  ///< when the newest was begun
};
/// Calls `take` for each person of a class and each lesson with such exams.
[[nodiscard]] core::Status forEachWithoutScore(const DatabaseContext& school, ClassId ofClass,
                                               const std::function<void(const WithoutScore&)>& take);

}  // namespace database::sql
