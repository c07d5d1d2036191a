// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/attempt/ResumableAttempts.h"

#include <utility>

#include <QDir>
#include <QFile>
#include <QThread>

#include "core/recording/Replay.h"
#include "core/servo/ServoState.h"
#include "lessons/LessonReader.h"

namespace app {
namespace {

// A program that was just killed may lock its journal for a moment longer.
constexpr int kLooksForJournal = 6;
constexpr unsigned long kJournalRestMs = 500;

bool isGradedNote(const core::servo::ServoEvent& event)
{
    return event.kind == core::servo::ServoEvent::Kind::Note && event.value == core::servo::kGradedNote;
}

/// Returns whether anything was cut after the last grade and after the first `events` events. Takes as long as a
/// replay.
bool isCutOn(const core::recording::Recording& recording, std::uint64_t events = 0)
{
    auto servo = core::recording::Replayer::make(recording);
    bool isCut = !servo;  // a recording that cannot be replayed must not be discarded
    std::uint64_t played = 0;
    if (servo)
        recording.forEach([&](const core::servo::ServoEvent& event) {
            const bool cuts = servo->play(event) && !servo->changed().isEmpty();
            isCut = ++played > events && !isGradedNote(event) && (isCut || cuts);
        });
    return isCut;
}

/// Returns whether an attempt was graded and nothing was cut afterwards: resumed, it would count twice. A bur that only
/// turned after the grade does not matter. An exam is done once it has a grade.
bool isDone(const core::recording::Recording& recording)
{
    using Kind = core::servo::ServoEvent::Kind;
    bool isGraded = false;
    bool drillOn = false;
    bool mayBeCut = false;
    recording.forEach([&](const core::servo::ServoEvent& event) {
        isGraded = isGraded || isGradedNote(event);
        if (event.kind == Kind::Drill || event.kind == Kind::Resume)
            drillOn = event.kind == Kind::Drill && event.value != 0;
        mayBeCut = !isGradedNote(event) && (mayBeCut || (event.kind == Kind::Tick && drillOn));
    });
    if (!isGraded || !mayBeCut)
        return isGraded;
    const auto read = lessons::readLessonText(QByteArray::fromStdString(recording.lesson()), QStringLiteral("lesson"));
    return (read.lesson && read.lesson->exam) || !isCutOn(recording);
}

/// Returns whether an attempt is saved, in the outbox or in the database. Returns nullopt if the database has not
/// answered.
std::optional<bool> isThere(const std::string& uid, const QString& outbox,
                            const std::optional<std::set<std::string>>& kept)
{
    const QString letter = QString::fromStdString(uid) + QStringLiteral(".attempt");
    for (const QString& folder : {outbox, outbox + QStringLiteral("/arrived")})
        if (QFile::exists(QDir(folder).filePath(letter)))
            return true;
    return kept ? std::optional(kept->contains(uid)) : std::nullopt;
}

/// Reads one journal for findUnfinished() and stores the result in `taken`. Returns false if another program has the
/// journal open.
bool look(const std::filesystem::path& journal, const QString& outbox, const database::KnownAttempts& known,
          FoundUnfinished& taken)
{
    auto found = core::recording::findAttempt(journal);
    if (!found) {
        taken.failure = found.error();
        if (found.error().code != core::ErrorCode::NewerVersion)  // a newer program can still resume the attempt
            core::recording::discardJournal(journal);
        return true;
    }
    if (!*found)
        return false;
    const core::recording::Recording& recording = (*found)->recording;
    const auto mark = gradedMark(journal);
    const auto isKept = mark ? isThere(mark->uid, outbox, known.kept) : std::nullopt;
    if (mark && !isKept) {  // if the attempt is already saved, resuming would count it twice
        taken.isUndecided = true;
        return true;
    }
    const bool isOver = isDone(recording);
    if (mark ? *isKept && (isOver || !isCutOn(recording, mark->events)) : isOver) {
        core::recording::discardJournal(journal);
        removeGradedMark(journal);
    } else if (!known.usedUp.contains(limitedLessonOf(recording))) {
        if (isOver)
            taken.seen = mark;
        taken.attempt = std::move(*found);
    }
    return true;
}

}  // namespace

FoundUnfinished findUnfinished(const std::filesystem::path& folder, const QString& outbox,
                               const database::KnownAttempts& known, const std::set<std::filesystem::path>& toBeKept)
{
    FoundUnfinished found;
    core::recording::tidyJournals(folder);
    tidyGradedMarks(folder);
    bool isInUse = true;
    for (int k = 0; k < kLooksForJournal && isInUse && !found.attempt; ++k) {
        QThread::msleep(k > 0 ? kJournalRestMs : 0);
        isInUse = false;
        for (const std::filesystem::path& journal : core::recording::journalsIn(folder)) {
            if (toBeKept.contains(journal))
                continue;
            isInUse = !look(journal, outbox, known, found) || isInUse;
            if (found.attempt)
                break;
        }
    }
    return found;
}

std::string limitedLessonOf(const core::recording::Recording& recording)
{
    const auto read = lessons::readLessonText(QByteArray::fromStdString(recording.lesson()), QStringLiteral("lesson"));
    return read.lesson && !read.lesson->exam ? read.lesson->id : std::string();
}

void endKept(const std::filesystem::path& journal, std::uint64_t events)
{
    const auto found = core::recording::findAttempt(journal);
    if (found && *found && !isCutOn((*found)->recording, events))
        core::recording::discardJournal(journal);
}

}  // namespace app
