// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/Exercises.h"

#include "core/recording/Format.h"
#include "lessons/JsonFiles.h"
#include "lessons/LessonPack.h"
#include "lessons/LessonReader.h"

namespace fuzz {
void exerciseLesson(std::string_view bytes)
{
    const QString name = QStringLiteral("fuzzed.lesson.json");
    const lessons::ReadLesson read =
        lessons::readLessonText(QByteArray(bytes.data(), static_cast<qsizetype>(bytes.size())), name);
    for (const lessons::ValidationIssue& fault : read.faults)
        promise(!fault.english().isEmpty() && !fault.sentence().isEmpty());
    if (!read.lesson) {
        promise(!read.faults.empty());
        return;
    }
    promise(lessons::check(read.lesson->rubric).has_value());
    // The text that a recording stores must be the same lesson.
    const lessons::ReadLesson again = lessons::readLessonText(QByteArray::fromStdString(read.lesson->json), name);
    promise(again.lesson && *again.lesson == *read.lesson);
}

namespace {

void readPack(std::string_view bytes)
{
    const auto files = lessons::unpackLessons(QByteArray(bytes.data(), static_cast<qsizetype>(bytes.size())));
    if (!files) {
        promise(files.error().detail.ends_with('.'));
        return;
    }
    promise(!files->empty() && files->size() <= static_cast<std::size_t>(lessons::kMostPackedFiles));
    qint64 sum = 0;
    for (const lessons::PackedFile& file : *files) {
        promise(lessons::isNameBeside(file.name));
        sum += file.content.size();
        if (file.name.endsWith(QStringLiteral(".lesson.json")))
            exerciseLesson({file.content.constData(), static_cast<std::size_t>(file.content.size())});
    }
    promise(sum <= lessons::kLargestPackBytes);
}

}  // namespace

void exercisePack(std::string_view bytes)
{
    readPack(bytes);
    readPack(core::recording::pack(bytes));
}

}  // namespace fuzz
