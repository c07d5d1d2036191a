// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QJsonObject>
#include <QString>

#include "lessons/JsonFiles.h"
#include "lessons/Lesson.h"

namespace lessons {

/// A captured ideal may have so much, or no recording could take the lesson along.
inline constexpr qint64 kLargestIdealBytes = qint64{700} * 1024;

/// The lesson that a whole object says, its rubric in it. It can be given unless there are grave faults.
/// @param file        where it stands: what it names is looked for beside it
/// @param rubricFile  where its rubric stands, for the faults: the same file, or another
/// @param files       finds what it names; null for a text that stands on its own
[[nodiscard]] Lesson lessonFrom(const QJsonObject& whole, const QString& file, const QString& rubricFile,
                                JsonFiles* files, std::vector<ValidationIssue>& faults);

}  // namespace lessons
