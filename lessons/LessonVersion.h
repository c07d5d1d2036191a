// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include <QByteArray>

#include "core/base/Result.h"
#include "lessons/Lesson.h"

/// One version of a lesson as the database of a school stores it: a pack (LessonPack.h) with the complete text of the
/// lesson, which contains its rubric, and the scan, captured ideal and expert's recording that the text names. The hash
/// of the lesson names the version, so a changed pack is recognised.
namespace lessons {

/// Identifies a version of a lesson.
struct LessonVersion
{
    std::string id;
    int version = 0;
    std::string hash;  ///< Lesson::hash
    bool operator==(const LessonVersion&) const = default;
};

/// Returns the pack of a lesson that was read from its file. Error: a file that it names is missing, has changed since,
/// or is too large for a pack. Takes up to a second; any thread.
[[nodiscard]] core::Result<QByteArray> packVersion(const Lesson& lesson);

/// Returns which version a pack contains. BadStructure: it is no pack of one lesson, or the hash of a file differs from
/// the one in the text of the lesson.
[[nodiscard]] core::Result<LessonVersion> versionIn(const QByteArray& pack);

/// Stores a pack in the user's cache. OutOfRange: it is of another version.
/// @param hash  of the lesson
[[nodiscard]] core::Status cacheVersion(const std::string& hash, const QByteArray& pack);
[[nodiscard]] bool isVersionCached(const std::string& hash);
/// Reads a version from the user's cache. FileMissing: it is not there. BadStructure: it was changed, and is removed.
[[nodiscard]] core::Result<Lesson> cachedVersion(const std::string& hash);

}  // namespace lessons
