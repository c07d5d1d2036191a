// SPDX-License-Identifier: GPL-3.0-or-later
#include "lessons/LessonReader.h"

#include <utility>

#include "lessons/JsonFiles.h"
#include "lessons/LessonMaker.h"
#include "lessons/RubricReader.h"

namespace lessons {
namespace {

const QString kRubric = QStringLiteral("rubric");

/// Sets the file of each fault to the one that contains its key, which may be a file that the lesson is based on.
void nameFiles(std::vector<ValidationIssue>& faults, const Gathered& gathered)
{
    for (ValidationIssue& fault : faults)
        if (fault.file == gathered.parts.front().first)
            fault.file = gathered.fileThatSays(fault.key);
}

void complete(const std::optional<Gathered>& gathered, const QString& file, JsonFiles& files, ReadLesson& result)
{
    if (gathered) {
        QJsonObject whole = gathered->whole;
        const auto rubric = gatherRubric(whole.value(kRubric), file, files);
        // Without a rubric the lesson is unusable, but all other faults are reported as well.
        whole.insert(kRubric, rubric ? rubric->whole : QJsonObject());
        const QString rubricFile = rubric ? rubric->parts.front().first : QString();
        Lesson lesson = lessonFrom(whole, file, rubricFile, &files, result.faults);
        if (!rubric)
            std::erase_if(result.faults, [](const ValidationIssue& fault) { return fault.file.isEmpty(); });
        else if (!anyGrave(result.faults))
            result.lesson = std::move(lesson);
        nameFiles(result.faults, *gathered);
        if (rubric && rubricFile != file)
            nameFiles(result.faults, *rubric);
    }
    result.uses = files.uses();
}

}  // namespace

ReadLesson readLesson(const QString& file)
{
    ReadLesson result;
    result.file = file;
    JsonFiles files(result.faults);
    complete(files.gather(file), file, files, result);
    return result;
}

ReadLesson readDraft(const QJsonObject& draft, const QString& file)
{
    ReadLesson result;
    result.file = file;
    JsonFiles files(result.faults);
    complete(files.underlaid(draft, file), file, files, result);
    return result;
}

ReadLesson readLessonText(const QByteArray& json, const QString& name)
{
    ReadLesson result;
    result.file = name;
    const auto whole = parseObject(json, name, result.faults);
    if (!whole)
        return result;
    Lesson lesson = lessonFrom(*whole, name, name, nullptr, result.faults);
    if (!anyGrave(result.faults))
        result.lesson = std::move(lesson);
    return result;
}

}  // namespace lessons
