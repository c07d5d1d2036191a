// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <QJsonObject>
#include <QString>

#include "core/base/Result.h"
#include "lessons/Lesson.h"
#include "lessons/LessonReader.h"

namespace lessons {

/// The initial values of a new lesson. Missing ones get defaults, or come from the lesson it is based on.
struct NewLesson
{
    QString id;
    std::optional<Task> task;
    std::optional<int> fdi;
    std::optional<qint64> seed;
    QString block;     ///< "cross"; empty: a tooth
    QString scan;      ///< a mesh file beside it; empty: a generated tooth or a block
    QString unit;      ///< of the scan, as in its lesson; empty: guessed
    QString up;        ///< likewise
    QString from;      ///< id of a shipped lesson, or a file beside it; empty: based on no lesson
    QString title;     ///< empty: generated
    QString captured;  ///< a captured ideal beside it; empty: by rule
};

/// Returns a new lesson as the object of its file. With `from` it contains only the differences. Error if values are
/// inconsistent, or if there is no ideal for the tooth. Call readDraft() and assign() to check whether it is usable.
/// @param folder  where it will be saved
[[nodiscard]] core::Result<QJsonObject> newLesson(const NewLesson& wishes, const QString& folder);

/// Returns a version of a lesson for a teacher to edit: based on it if it is shipped, otherwise a copy of its file.
[[nodiscard]] QJsonObject ownVersion(const ReadLesson& lesson);

/// Returns the whole rubric of a lesson as an object. If Cusp ships a rubric with the same id, the id is changed.
[[nodiscard]] QJsonObject ownRubric(const Lesson& lesson);

}  // namespace lessons
