// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "database/ClassOverview.h"
#include "database/sql/DatabaseContext.h"

namespace database::sql {

/// Returns the results of the students of a class by lesson. Its teachers and admins.
[[nodiscard]] core::Result<ClassOverview> classOverview(const DatabaseContext& school, const Login& session,
                                                        ClassId ofClass);

/// Returns the results of a class at one lesson. Its teachers and admins.
[[nodiscard]] core::Result<LessonResults> lessonResults(const DatabaseContext& school, const Login& session,
                                                        ClassId ofClass, const std::string& lessonId);

/// Returns the scores of a person's classmates, including that person, at a lesson by attempt; empty for fewer than
/// lessons::kFewestPeople. Attempts with another device than the person's last one are not compared. Classes with fewer
/// students do not count; a teacher gets those of their own classes only.
[[nodiscard]] core::Result<std::vector<BandPoint>> classBand(const DatabaseContext& school, const Login& session,
                                                             PersonId person, const std::string& lessonId);

/// Returns the medians of the same people; empty for fewer than lessons::kFewestPeople.
[[nodiscard]] core::Result<std::optional<LessonMedians>>
classMedians(const DatabaseContext& school, const Login& session, PersonId person, const std::string& lessonId);

/// Returns the comments on an attempt and the scores given.
[[nodiscard]] core::Result<AttemptTalk> readTalk(const DatabaseContext& school, const Login& session, AttemptId id);

}  // namespace database::sql
