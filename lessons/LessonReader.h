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
    QStringList uses;  ///< the files read and those they name, without shipped ones; the lesson's is first
};

/// Reads the file of a lesson (schema/lesson.schema.json) with its rubric and all files that it is based on: beside it,
/// or shipped ones. Never throws, uses little more memory than the size of the file, and follows at most 8 files. Any
/// thread.
[[nodiscard]] ReadLesson readLesson(const QString& file);

/// Reads a lesson from an object that is not saved yet.
/// @param file  its future path: names are relative to it
[[nodiscard]] ReadLesson readDraft(const QJsonObject& draft, const QString& file);

/// Reads a lesson from the text in a recording, which is complete and refers to no other file: it contains a captured
/// ideal, and the name of a scan is not resolved. @param name  name of the text in faults
[[nodiscard]] ReadLesson readLessonText(const QByteArray& json, const QString& name);

}  // namespace lessons
