// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QJsonObject>
#include <QString>

#include "lessons/JsonFiles.h"
#include "lessons/Lesson.h"

namespace lessons {

/// Largest captured ideal: with a larger one no recording could store the lesson.
inline constexpr qint64 kLargestIdealBytes = qint64{700} * 1024;

/// Builds the lesson of a merged object with its rubric. It is usable unless there are grave faults.
/// @param file        the lesson's file: names are relative to it
/// @param rubricFile  the file of its rubric, for the faults: the same or another
/// @param files       resolves names; null for a text that does not refer to other files
[[nodiscard]] Lesson lessonFrom(const QJsonObject& whole, const QString& file, const QString& rubricFile,
                                JsonFiles* files, std::vector<ValidationIssue>& faults);

}  // namespace lessons
