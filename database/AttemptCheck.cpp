// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/AttemptCheck.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <string_view>
#include <variant>

#include <QDateTime>

#include "core/recording/OriginNotes.h"
#include "core/recording/Recording.h"
#include "lessons/ScoreSheetJson.h"

namespace database {
namespace {

constexpr double kMnPerN = 1000.0;
constexpr double kMsPerS = 1000.0;
constexpr double kClockSlackS = 120.0;  ///< by which the clock of a computer may be set during an exam

/// Returns whether a recording begins with the tooth of its lesson, uncut and unchanged. Its text of the lesson does
/// not contain the scan, so the tooth of a scan is compared only with the lesson that the school stores.
bool isOfItsTooth(const core::recording::Recording& recording, const lessons::Lesson& lesson,
                  const std::optional<lessons::Lesson>& assigned)
{
    if (assigned && assigned->hash == lesson.hash)
        return lessons::isToothOf(*assigned, *recording.anatomy());
    return std::holds_alternative<lessons::Scan>(lesson.tooth) || lessons::isToothOf(lesson, *recording.anatomy());
}

std::vector<CriterionLoss> lossesOf(const lessons::ScoreSheet& sheet)
{
    std::vector<CriterionLoss> losses;
    for (const lessons::Criterion& criterion : sheet.criteria)
        losses.push_back({criterion.id, criterion.lostTenths, criterion.weightTenths});
    return losses;
}

/// Returns whether the score sheet of an attempt, which is shown and printed, says the same as its record. Measured
/// values are not compared: their last digits depend on the processor.
bool hasItsSheet(const AttemptRecord& attempt)
{
    const auto sheet = lessons::sheetIn(attempt.scoreSheetJson);
    return sheet && sheet->totalTenths == attempt.scoreTenths && sheet->passMarkTenths == attempt.passMarkTenths &&
           sheet->rubricHash == attempt.rubricHash && lossesOf(*sheet) == attempt.criteria;
}

/// Returns the notes of a recording that a condition holds for.
std::set<std::uint64_t> notesIn(const core::recording::Recording& recording, bool (*isWanted)(std::uint64_t))
{
    std::set<std::uint64_t> notes;
    recording.forEach([&](const core::servo::ServoEvent& event) {
        if (event.kind == core::servo::ServoEvent::Kind::Note && isWanted(event.value))
            notes.insert(event.value);
    });
    return notes;
}

/// Returns whether a recording names its person, and nobody else. That of a guest or of the simulated hand names none.
bool isOfItsPerson(const core::recording::Recording& recording, const std::string& personUid)
{
    return personUid.empty() ||
           notesIn(recording, core::recording::isPersonNote) == std::set{core::recording::personNote(personUid)};
}

/// Returns whether the recording of an exam names a start of the person since which the work can have been done.
bool isBegun(const AttemptRecord& attempt, const core::recording::Recording& recording, const lessons::Conduct& conduct,
             const std::vector<ExamStart>& starts)
{
    const std::set<std::uint64_t> named = notesIn(recording, core::recording::isExamNote);
    const QDateTime finished = QDateTime::fromString(QString::fromStdString(attempt.finishedUtc), Qt::ISODate);
    const auto& process = conduct.process;
    const double workedS = process.firstCutS ? process.totalS - *process.firstCutS : 0.0;
    return std::any_of(starts.begin(), starts.end(), [&](const ExamStart& start) {
        const QDateTime begun = QDateTime::fromString(QString::fromStdString(start.begunUtc), Qt::ISODate);
        return named.contains(core::recording::examNote(start.uid)) &&
               static_cast<double>(begun.secsTo(finished)) + kClockSlackS >= workedS;
    });
}

}  // namespace

void setProven(AttemptRecord& attempt, const lessons::Assignment& assignment, const lessons::ScoreSheet& sheet,
               const lessons::Conduct& conduct, std::uint64_t stateHash)
{
    const auto& process = conduct.process;
    attempt.tooth = assignment.anatomy->name;
    attempt.grid = assignment.anatomy->grid.side;
    attempt.seed = std::to_string(assignment.anatomy->seed);
    attempt.lessonId = assignment.lesson ? assignment.lesson->id : std::string();
    attempt.lessonHash = assignment.lesson ? assignment.lesson->hash : std::string();
    attempt.rubricHash = sheet.rubricHash;
    attempt.scoreTenths = sheet.totalTenths;
    attempt.passed = sheet.passed();
    attempt.passMarkTenths = sheet.passMarkTenths;
    attempt.criteria = lossesOf(sheet);
    attempt.durationMs = std::llround(kMsPerS * process.totalS);
    attempt.stateHash = QStringLiteral("%1").arg(stateHash, 16, 16, QLatin1Char('0')).toStdString();
    attempt.meanForceMn = process.force ? static_cast<int>(std::lround(process.force->meanN * kMnPerN)) : 0;
    attempt.peakForceMn = process.force ? static_cast<int>(std::lround(process.force->largestN * kMnPerN)) : 0;
}

Doubt checkAttempt(const AttemptRecord& attempt, const QByteArray& recording,
                   const std::optional<lessons::Lesson>& assigned, const std::optional<std::vector<ExamStart>>& starts)
{
    const auto read = core::recording::Recording::fromBytes(
        std::string_view(recording.constData(), static_cast<std::size_t>(recording.size())));
    const auto assignment = read ? lessons::assignmentOf(read->anatomy(), read->lesson())
                                 : core::Result<lessons::Assignment>(tl::unexpected(read.error()));
    if (!assignment || !isOfItsPerson(*read, attempt.personUid))
        return Doubt::Recording;
    if (const std::optional<lessons::Lesson>& lesson = assignment->lesson) {
        if (lesson->hash != attempt.lessonHash || !isOfItsTooth(*read, *lesson, assigned))
            return Doubt::Recording;
    } else if (!attempt.lessonId.empty()) {
        return Doubt::Recording;
    } else if (assignment->rubric.hash != attempt.rubricHash) {
        return Doubt::None;
    }
    const auto marked = lessons::markAgain(*read);
    if (!marked)
        return Doubt::Recording;
    AttemptRecord again = attempt;
    setProven(again, *assignment, marked->mark.sheet, marked->conduct, marked->outcome.stateHash);
    if (again != attempt || !hasItsSheet(attempt))
        return Doubt::Score;
    const bool isExam = assignment->lesson && assignment->lesson->exam;
    return !isExam || !starts || isBegun(attempt, *read, marked->conduct, *starts) ? Doubt::None : Doubt::Start;
}

}  // namespace database
