// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/Exercises.h"

#include <QFile>
#include <QTemporaryDir>

#include "core/base/Bytes.h"
#include "database/Outbox.h"
#include "database/Passwords.h"

namespace fuzz {
namespace {

void promiseText(const std::string& text)
{
    promise(core::isUtf8(text) && text.find('\0') == std::string::npos);
}

/// Reads a file as an attempt and as the start of an exam.
void readLetter(const database::Outbox& outbox, const QString& path, const std::string& bytes)
{
    QFile file(path);
    promise(file.open(QIODevice::WriteOnly | QIODevice::Truncate) &&
            file.write(bytes.data(), static_cast<qint64>(bytes.size())) == static_cast<qint64>(bytes.size()));
    file.close();
    if (const auto letter = outbox.read(path)) {
        const database::AttemptRecord& attempt = letter->attempt;
        promise(attempt.uid.size() == database::kUidLength);
        for (const std::string* text : {&attempt.uid, &attempt.personUid, &attempt.finishedUtc, &attempt.lessonId,
                                        &attempt.scoreSheetJson, &attempt.device, &attempt.preset})
            promiseText(*text);
        for (const database::CriterionLoss& criterion : attempt.criteria)
            promiseText(criterion.id);
    } else {
        promise(!letter.error().detail.empty());
    }
    if (const auto letter = outbox.readExam(path)) {
        promise(letter->start.uid.size() == database::kUidLength);
        for (const std::string* text : {&letter->personUid, &letter->start.lessonId, &letter->start.begunUtc})
            promiseText(*text);
    } else {
        promise(!letter.error().detail.empty());
    }
}

}  // namespace

void exerciseLetter(std::string_view bytes)
{
    static const QTemporaryDir folder;
    static const database::StationKey key = database::StationKey::make();
    const database::Outbox outbox(folder.path(), key);
    const QString path = folder.filePath("fuzzed.attempt");
    readLetter(outbox, path, std::string(bytes));
    // The same bytes as the content of a file with a valid signature.
    const std::string content(bytes);
    readLetter(outbox, path, "CUSPOUT2" + key.publicHex() + key.sign(database::digestOf(content)) + content);
}

}  // namespace fuzz
