// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include <QString>

#include "core/base/Result.h"
#include "lessons/LessonReader.h"

namespace lessons {

/// An entry of the catalog: a lesson, or a file with faults.
struct CatalogEntry
{
    ReadLesson read;
    bool isShipped = false;
    QString pack;  ///< path of the pack that contains it; empty: a file of its own
    [[nodiscard]] bool isFaulty() const { return !read.lesson; }
};

/// Returns all lessons: the shipped ones and those in a teacher's folder. The latter are in separate files
/// (*.lesson.json) or in packs (*.cusplessons, LessonPack.h). A faulty file becomes an entry with its faults and does
/// not affect the others. An id may occur once: of two lessons the shipped one is used, otherwise the first by file
/// name. A lesson that was extracted from a pack replaces the one in the pack.
///
/// @param folder  the teacher's folder; may be missing or empty
/// Shipped lessons come first; each group is sorted by file name. Any thread.
[[nodiscard]] std::vector<CatalogEntry> readCatalog(const QString& folder);

/// Replaces the lessons of the catalog that are assigned in another version by that version from the cache
/// (LessonVersion.h). A version that cannot be read becomes an entry with a fault. Returns the hashes of those that are
/// not in the cache yet.
/// @param assigned  hash of the assigned version, by lesson id
[[nodiscard]] std::vector<std::string> useVersions(std::vector<CatalogEntry>& entries,
                                                   const std::map<std::string, std::string>& assigned);

/// Returns the file of a lesson. A name that ends in .json, or of an existing file, is the file itself; any other is an
/// id in the teacher's folder or of a shipped lesson. UnknownName if there is none.
[[nodiscard]] core::Result<QString> lessonFile(const QString& fileOrId);
/// Reads a lesson by its file or id (lessonFile()). The error lists its faults.
[[nodiscard]] core::Result<Lesson> lessonNamed(const QString& fileOrId);

/// Returns the default folder for a teacher's lessons: "lessons" in the user's data folder of Cusp.
[[nodiscard]] QString teachersFolder();

}  // namespace lessons
