// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include <QString>

#include "core/base/Result.h"
#include "lessons/Lesson.h"

namespace lessons {

/// Something wrong with a lesson's file.
struct Fault
{
    QString file;
    QString key;        ///< "rubric.criteria[2].weight"; empty: the whole file
    QString what;       ///< one English sentence: what is wrong and what to do
    bool grave = true;  ///< the lesson cannot be given; else it only deserves a look
    [[nodiscard]] QString sentence() const;
};

/// A lesson, or what is wrong with its file. Both where there are warnings.
struct ReadLesson
{
    QString file;
    std::optional<Lesson> lesson;
    std::vector<Fault> faults;
};

inline constexpr qint64 kLargestLessonBytes = qint64{1} << 20;
inline constexpr int kLessonFormat = 1;

/// Reads a lesson's file (schema/lesson.schema.json) with all that it is based on and the rubric it names, from beside
/// it or from those we ship. Never throws, holds little more than the file's size, follows at most 8 files. Any thread.
[[nodiscard]] ReadLesson readLesson(const QString& file);

/// The same from the text a recording holds: whole, so it names no other file (a scan's or a captured ideal's is kept
/// but not looked for). @param name  what to call it in faults
[[nodiscard]] ReadLesson readLessonText(const QByteArray& json, const QString& name);

/// Reads a rubric's file, or one of those we ship by its id.
[[nodiscard]] core::Result<Rubric> readRubric(const QString& fileOrId);

}  // namespace lessons
