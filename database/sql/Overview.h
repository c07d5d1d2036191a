// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "database/ClassOverview.h"
#include "database/sql/DatabaseContext.h"

namespace database::sql {

/// Students of a class by lessons. Its teachers and admins.
[[nodiscard]] core::Result<ClassOverview> classOverview(const DatabaseContext& school, const Login& session,
                                                        ClassId ofClass);

/// What a class has done at one lesson. Its teachers and admins.
[[nodiscard]] core::Result<LessonResults> lessonResults(const DatabaseContext& school, const Login& session,
                                                        ClassId ofClass, const std::string& lessonId);

/// How the classmates of a person, himself among them, do at a lesson, attempt by attempt; empty for fewer than
/// lessons::kFewestPeople. Attempts with another device than the person's last one are not compared. Of a class with
/// fewer students nobody is among them; who teaches is told of those of his own classes only.
[[nodiscard]] core::Result<std::vector<BandPoint>> classBand(const DatabaseContext& school, const Login& session,
                                                             PersonId person, const std::string& lessonId);

/// Of the same people; nothing for fewer than lessons::kFewestPeople.
[[nodiscard]] core::Result<std::optional<LessonMedians>>
classMedians(const DatabaseContext& school, const Login& session, PersonId person, const std::string& lessonId);

/// What people have said of an attempt.
[[nodiscard]] core::Result<AttemptTalk> readTalk(const DatabaseContext& school, const Login& session, AttemptId id);

}  // namespace database::sql
