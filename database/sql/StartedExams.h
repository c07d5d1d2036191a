// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "database/AttemptRecord.h"
#include "database/sql/DatabaseContext.h"

namespace database::sql {

/// Notes that a person has begun an exam, as this station's outbox says. The same uid is noted once.
[[nodiscard]] core::Status deliverExam(const DatabaseContext& school, const std::string& personUid,
                                       const ExamStart& start);

/// The exams of a person that were begun and have no score, newest first: one that goes on now is among them.
[[nodiscard]] core::Result<std::vector<ExamStart>> examsWithoutScore(const DatabaseContext& school,
                                                                     const Login& session, PersonId person);

/// The number of such exams of a person, by lesson; checks no permission.
[[nodiscard]] core::Result<std::map<std::string, int>> countWithoutScore(const DatabaseContext& school,
                                                                         PersonId person);
/// The same of everybody in a class, lesson by lesson, where there are any.
struct WithoutScore
{
    PersonId person;
    std::string lessonId;
    int count = 0;
    std::string newestUtc;  ///< when that was begun
};
[[nodiscard]] core::Status forEachWithoutScore(const DatabaseContext& school, ClassId ofClass,
                                               const std::function<void(const WithoutScore&)>& take);

}  // namespace database::sql
