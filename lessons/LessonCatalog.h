// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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

/// Returns all lessons: the shipped ones and those in a teacher's folder, each from its own file (*.lesson.json) or
/// from a pack (*.cusplessons, LessonPack.h). A faulty file is an entry with its faults; the others work. An id may
/// occur once: of two, the shipped one is used, otherwise the first by name. A lesson that was extracted from a pack
/// replaces the one in the pack.
///
/// @param folder  the teacher's folder; may be missing or empty
/// Shipped lessons come first, each group sorted by file name. Any thread.
[[nodiscard]] std::vector<CatalogEntry> readCatalog(const QString& folder);

/// Returns the file of a lesson: the name itself if it ends in .json or is an existing file; otherwise it is an id in
/// the teacher's folder or of a shipped lesson. UnknownName if there is none.
[[nodiscard]] core::Result<QString> lessonFile(const QString& fileOrId);
/// Reads a lesson by its file or id (lessonFile()). The error says what is wrong.
[[nodiscard]] core::Result<Lesson> lessonNamed(const QString& fileOrId);

/// Returns the default folder for a teacher's lessons: "lessons" in the user's data folder of Cusp.
[[nodiscard]] QString teachersFolder();

}  // namespace lessons
