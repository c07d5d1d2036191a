// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QString>

#include "core/base/Result.h"
#include "lessons/LessonReader.h"

namespace lessons {

/// A lesson of the catalog, or a file that ought to be one.
struct CatalogEntry
{
    ReadLesson read;
    bool isShipped = false;
    QString pack;  ///< that it lies in, its path; empty: a file of its own
    [[nodiscard]] bool isFaulty() const { return !read.lesson; }
};

/// All lessons there are: those we ship and those in a teacher's folder, each by its own file (*.lesson.json) or in a
/// pack (*.cusplessons, LessonPack.h). A faulty file is an entry with its faults; the others work. An id may be there
/// once: of two, the shipped one stays, then the first by name. What was taken out of a pack stands for what is in it.
///
/// @param folder  the teacher's; may be missing or empty
/// Shipped ones come first, each kind by file name. Any thread.
[[nodiscard]] std::vector<CatalogEntry> readCatalog(const QString& folder);

/// The file of a lesson: the name itself where it ends in .json or a file is called so, else it is an id in the
/// teacher's folder or among those we ship. UnknownName if nothing is called so.
[[nodiscard]] core::Result<QString> lessonFile(const QString& fileOrId);
/// A lesson by its file or id (lessonFile). The error names what is wrong.
[[nodiscard]] core::Result<Lesson> lessonNamed(const QString& fileOrId);

/// Where a teacher's lessons lie unless another folder is named: "lessons" in the user's data folder of Cusp.
[[nodiscard]] QString teachersFolder();

}  // namespace lessons
