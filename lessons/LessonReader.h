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

/// A lesson, or what is wrong with its file. Both where there are warnings.
struct ReadLesson
{
    QString file;
    std::optional<Lesson> lesson;
    std::vector<ValidationIssue> faults;
    QStringList uses;  ///< the files it was read from and those it names, the lesson's first; none that we ship
};

/// Reads a lesson's file (schema/lesson.schema.json) with all that it is based on and the rubric it names, from beside
/// it or from those we ship. Never throws, holds little more than the file's size, follows at most 8 files. Any thread.
[[nodiscard]] ReadLesson readLesson(const QString& file);

/// The same from an object that is not in a file yet.
/// @param file  where it would stand: what it names is looked for beside it
[[nodiscard]] ReadLesson readDraft(const QJsonObject& draft, const QString& file);

/// The same from the text a recording holds: whole, so it names no other file (a scan's is kept but not looked for, a
/// captured ideal stands in it). @param name  what to call it in faults
[[nodiscard]] ReadLesson readLessonText(const QByteArray& json, const QString& name);

}  // namespace lessons
