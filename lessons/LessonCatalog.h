// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QString>

#include "lessons/LessonReader.h"

namespace lessons {

/// A lesson of the catalog, or a file that ought to be one.
struct CatalogEntry
{
    ReadLesson read;
    bool isShipped = false;
    [[nodiscard]] bool isFaulty() const { return !read.lesson; }
};

/// All lessons there are: those we ship and those in a teacher's folder, each by its own file (*.lesson.json) or in a
/// pack (*.cusplessons, LessonPack.h). A faulty file is an entry with its faults; the others work. An id may be there
/// once: of two, the shipped one stays, then the first by name.
///
/// @param folder  the teacher's; may be missing or empty
/// Shipped ones come first, each kind by file name. Any thread.
[[nodiscard]] std::vector<CatalogEntry> readCatalog(const QString& folder);

/// Where a teacher's lessons lie unless another folder is named: "lessons" in the user's data folder of Cusp.
[[nodiscard]] QString teachersFolder();

}  // namespace lessons
