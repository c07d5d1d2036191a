// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <QJsonObject>
#include <QString>

#include "core/base/Result.h"
#include "lessons/Lesson.h"
#include "lessons/LessonReader.h"

namespace lessons {

/// What a lesson begins with. What is not said is filled in, or comes from the lesson it is based on.
struct NewLesson
{
    QString id;
    std::optional<Task> task;
    std::optional<int> fdi;
    std::optional<qint64> seed;
    QString block;     ///< "cross"; empty: a tooth
    QString scan;      ///< a mesh file, beside; empty: a tooth of ours or a block
    QString unit;      ///< of the scan, as its lesson says it; empty: guessed
    QString up;        ///< the same
    QString from;      ///< a shipped lesson's id, or a file beside; empty: from nothing
    QString title;     ///< empty: made up
    QString captured;  ///< a captured ideal, beside; empty: by rule
};

/// A lesson to begin with, as its file says it. With `from` it holds only what differs. An error says which wishes do
/// not go together, or that no ideal is made for the tooth. That it can be given is for readDraft() and assign() to
/// say.
/// @param folder  where it will stand
[[nodiscard]] core::Result<QJsonObject> newLesson(const NewLesson& wishes, const QString& folder);

/// The same for a teacher's own version of a lesson there is: based on it if it is shipped, else a copy of its file.
[[nodiscard]] QJsonObject ownVersion(const ReadLesson& lesson);

/// The whole rubric of a lesson as an object to change: under an id of its own if the program ships one of that id.
[[nodiscard]] QJsonObject ownRubric(const Lesson& lesson);

}  // namespace lessons
