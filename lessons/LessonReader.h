// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include <QJsonObject>
#include <QString>
#include <QStringList>

#include "lessons/Lesson.h"
#include "lessons/ValidationIssue.h"

namespace lessons {

/// A lesson, or the faults of its file. Both if there are only warnings.
struct ReadLesson
{
    QString file;
    std::optional<Lesson> lesson;
    std::vector<ValidationIssue> faults;
    QStringList uses;  ///< the files it was read from and those it names, the lesson's first; without shipped ones
};

/// Reads the file of a lesson (schema/lesson.schema.json) with all that it is based on and its rubric, from beside it
/// or from the shipped files. Never throws, uses little more memory than the file's size, follows at most 8 files. Any
/// thread.
[[nodiscard]] ReadLesson readLesson(const QString& file);

/// Reads a lesson from an object that is not saved yet.
/// @param file  its future path: names are relative to it
[[nodiscard]] ReadLesson readDraft(const QJsonObject& draft, const QString& file);

/// Reads a lesson from the text in a recording, which is complete: it names no other file (the name of a scan is kept
/// but not resolved, a captured ideal is included). @param name  its name in faults
[[nodiscard]] ReadLesson readLessonText(const QByteArray& json, const QString& name);

}  // namespace lessons
