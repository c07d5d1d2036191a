// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <QString>

#include "database/sql/School.h"
#include "lessons/Lesson.h"

namespace support {

/// A school that was made up, to see and to measure what a large one is like.
struct SampleSize
{
    int students = 200;
    std::int64_t attempts = 10'000;
    int classSize = 35;
    std::uint64_t seed = 1;
};

/// Fills a school that has its first admin and nothing else: students "s0001" ... in classes with a teacher each
/// ("teacher1" ...), and attempts at these lessons in which students get better, faster and more sure, each in their
/// own measure. The same seed gives the same school but for uids.
/// @param lessons  by whose rubrics the points are lost
[[nodiscard]] core::Status makeSample(const database::sql::School& school, const database::Session& admin,
                                      const SampleSize& size, const std::vector<lessons::Lesson>& lessons,
                                      const std::function<void(std::int64_t attempts)>& progress = {});

/// The same in a new file or an empty database, with the shipped lessons. Returns the password of "admin".
[[nodiscard]] core::Result<std::string> makeSchool(const QString& where, const SampleSize& size);

}  // namespace support
