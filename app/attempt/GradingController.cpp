// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/attempt/GradingController.h"

#include <utility>

#include <QDateTime>
#include <QThreadPool>
#include <QTimer>

#include "app/attempt/GradeDestination.h"
#include "app/attempt/ResumableAttempts.h"
#include "app/school/SchoolAccess.h"
#include "core/grading/Exercise.h"
#include "core/recording/OriginNotes.h"
#include "core/servo/ServoState.h"
#include "database/AttemptCheck.h"
#include "database/Passwords.h"
#include "database/Repositories.h"
#include "lessons/ScoreSheetJson.h"
#include "ui/scoring/ScorePredictionPage.h"
#include "ui/tooth/ToothView.h"

namespace app {
namespace {

using ui::text::FailedOperation;
using ui::window::MainWindow;

constexpr int kHistoryLength = 12;
constexpr int kSettleMs = 20;
constexpr int kSettledLooks = 3;  ///< so many in a row have to find the bur out of the tooth
constexpr int kMostSettleLooks = 25;
constexpr int kDiskPatienceMs = 1500;  ///< how long the score of an exam waits for the disk

}  // namespace

GradingController::GradingController(const AttemptContext& context, const Others& others)
    : m_context(context), m_attempts(others.attempts), m_resume(others.resume), m_observer(others.observer),
      m_opened(others.opened)
{
    connect(&m_context.window, &MainWindow::gradeRequested, this, &GradingController::requestGrade);
    connect(&m_context.window.predictionPage(), &ui::scoring::ScorePredictionPage::answered, this,
            [this](const ui::scoring::ScorePrediction& expected) { finish(expected); });
    connect(&m_resume, &ResumeController::gradeRequested, this, &GradingController::requestGrade);
    connect(&m_attempts, &AttemptController::aboutToLoad, this, [this] { m_analysis.forget(); });
    connect(&m_attempts, &AttemptController::cleared, this, [this] { m_graded.reset(); });
    m_analysis.showOn(m_context.window.scorePage(), [this] { return !m_opened.isShown(); });
    connect(&m_analysis, &ScoreAnalysis::failed, this, [this](const core::Error& error) {
        if (!m_opened.isShown())
            m_context.window.showError(error, FailedOperation::Marking);
    });
}

void GradingController::setUploader(AttemptUploader* uploader)
{
    m_uploader = uploader;
    if (uploader == nullptr)
        return;
    connect(uploader, &AttemptUploader::kept, this, &GradingController::handleSaved);
    connect(uploader, &AttemptUploader::refused, this, &GradingController::handleRefused);
}

std::optional<ReportController::Subject> GradingController::subject() const
{
    if (!m_graded)
        return std::nullopt;
    return ReportController::Subject{m_graded->record, QString::fromStdString(m_context.school.user.fullName()),
                                     m_context.school.user,
                                     m_graded->keeping == Keeping::Kept ? m_context.school.service : nullptr};
}

bool GradingController::isSaved() const
{
    return isAsGraded() && (m_graded->keeping == Keeping::Waiting || m_graded->keeping == Keeping::Kept);
}

void GradingController::handleDelivered(const std::string& uid)
{
    if (!m_graded || m_graded->record.uid != uid)
        return;
    m_graded->keeping = Keeping::Kept;
    updateHistory();
}

void GradingController::requestGrade()
{
    if (!m_context.attempt.settle())
        return;
    m_context.window.view().release();
    settle(0, 0);
}

/// Waits, for half a second at most, until the bur has left the tooth: cuts made during the grading would belong to no
/// attempt.
void GradingController::settle(int looks, int settled)
{
    const core::servo::ServoState& servo = m_context.channels.servo.latest();
    const bool isOut = !(servo.touching && servo.drillOn);
    settled = isOut ? settled + 1 : 0;
    if (settled >= kSettledLooks || looks >= kMostSettleLooks) {
        gradeNow();
        m_context.attempt.stopSettling();
        return;
    }
    QTimer::singleShot(kSettleMs, this, [this, looks, settled, generation = m_context.attempt.generation()] {
        if (generation != m_context.attempt.generation())
            return;
        if (!m_context.attempt.isResting())
            settle(looks + 1, settled);
        else
            m_context.attempt.stopSettling();
    });
}

void GradingController::gradeNow()
{
    const auto tooth = m_context.session.toothSoFar();
    if (!tooth || m_context.session.recordedGeneration() != m_context.attempt.generation()) {
        m_context.window.showMessage(tr("The tooth is not ready yet. Try again in a moment."));
        return;
    }
    const std::uint64_t hash = core::terrain::stateHash(*tooth);
    std::optional<core::grading::Practised> practised;
    if (const core::session::Findings now = m_context.assessment.findings();
        now.generation == m_context.attempt.generation())
        practised = now.practised;
    if (m_graded && m_graded->generation == m_context.attempt.generation() && m_graded->hash == hash &&
        m_graded->practised == practised) {
        showGrade();
        if (m_graded->keeping == Keeping::Nowhere)
            saveGrade();  // the disk may be writable now
        m_analysis.emitFound();
        return;
    }
    if (m_context.attempt.assignment().exercise && !(practised && core::grading::isBegun(*practised))) {
        m_context.window.showMessage(
            m_context.attempt.assignment().lesson &&
                    m_context.attempt.assignment().lesson->task == lessons::Task::TellLayers
                ? tr("No pad has an answer yet. Choose below the view what each pad is made of.")
                : tr("This exercise has not been started yet, so there is nothing to grade."));
        return;
    }
    if (!m_context.attempt.assignment().exercise && tooth->top == tooth->anatomy->top) {
        m_context.window.showMessage(tr("Nothing has been cut yet, so there is nothing to grade."));
        return;
    }
    // Neither the time of the prediction counts, nor work after the end of an exam.
    m_context.attempt.conclude([this] { return m_context.assessment.conclude(); }, m_context.window.isExamOver());
    // An exam was counted when it began. Further work that is graded again is one more attempt.
    const bool isAnother = m_context.attempt.isGraded();
    const bool isCounted = m_context.attempt.exam() == CurrentAttempt::Exam::Counted;
    if (!m_context.attempt.assignment().lesson)
        finish({});
    else if (m_context.attempt.seenBefore() && !isAnother)  // the student has seen the score already
        finish(m_context.attempt.seenBefore()->expectedTenths
                   ? std::optional(ui::scoring::ScorePrediction{*m_context.attempt.seenBefore()->expectedTenths, {}})
                   : std::nullopt);
    else if (m_context.attempt.isExam() && isCounted && !isAnother)
        m_context.window.askPrediction();
    else
        m_context.limit.whenAllowed(m_context.attempt.assignment().lesson->id,
                                    [this] { m_context.window.askPrediction(); });
}

/// Marks the work as it was when the grade was requested, saves the grade and shows it.
void GradingController::finish(const std::optional<ui::scoring::ScorePrediction>& expected)
{
    const auto done = m_context.attempt.grade();
    if (!done)
        return;
    const core::session::Findings& found = done->findings;
    const lessons::Conduct conduct{found.process, found.infractions, found.aids, found.practised};
    const auto marked = lessons::mark(m_context.attempt.assignment(), done->tooth, conduct);
    if (!marked) {
        m_context.window.showError(marked.error(), FailedOperation::Marking);
        return;
    }
    const lessons::ScoreSheet& sheet = marked->sheet;
    const std::uint64_t hash = core::terrain::stateHash(done->tooth);
    m_graded = {m_context.attempt.generation(),
                hash,
                sheet,
                recordOf(*done, conduct, sheet, expected),
                Keeping::Nowhere,
                {},
                {},
                expected,
                {std::make_shared<const core::terrain::Tooth>(done->tooth), m_context.attempt.assignment().shownIdeal(),
                 marked->measured, found.infractions, found.aids,
                 // The card of the trial names the preset, or in a blind comparison hides it.
                 m_attempts.isTrial() ? std::nullopt : std::optional(lessons::presetUsed(done->recording)),
                 m_context.attempt.assignment().exercise},
                done->recording,
                found.practised};
    if (m_context.attempt.isExam())
        saveExam();
    else {
        showGrade();
        saveGrade();
    }
    m_analysis.explain(m_context.attempt.assignment(), m_graded->recording, m_graded->work.tooth, conduct);
}

database::AttemptRecord GradingController::recordOf(const core::session::AttemptSnapshot& done,
                                                    const lessons::Conduct& conduct, const lessons::ScoreSheet& sheet,
                                                    const std::optional<ui::scoring::ScorePrediction>& expected) const
{
    const auto preset = lessons::presetUsed(done.recording);
    database::AttemptRecord record;
    record.uid = database::newUid();
    record.finishedUtc = QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString();
    database::setProven(record, m_context.attempt.assignment(), sheet, conduct, core::terrain::stateHash(done.tooth));
    if (expected)
        record.expectedTenths = expected->tenths;
    record.scoreSheetJson = lessons::toJson(sheet, preset).toStdString();
    record.device = m_observer.hand().toStdString();
    record.method = m_context.attempt.settings().method;
    record.viewMode = ui::render::idOf(m_observer.picture());
    record.preset = preset.name.toStdString() + (preset.version > 0 ? " v" + std::to_string(preset.version) : "") +
                    (preset.isChanged ? ", changed" : "");
    record.presetHash = preset.hash.toStdString();
    record.program = CUSP_VERSION;
    return record;
}

/// Sends the grade to the outbox, and from there to the database.
void GradingController::saveGrade()
{
    m_graded->keeping = destinationOf({.hasDatabase = m_context.school.service != nullptr,
                                       .isGuest = m_context.school.user.isGuest(),
                                       .isExam = m_context.attempt.isExam(),
                                       .isResumed = m_context.attempt.isResumed(),
                                       .isSimulated = m_context.devices.isSimulated(),
                                       .isTrial = m_attempts.isTrial(),
                                       .isOverLimit = m_graded->isOverLimit});
    updateKeeping();
    if (m_graded->keeping != Keeping::Pending)
        recordGraded();
    else
        m_uploader->send(std::make_shared<const PendingAttempt>(
            PendingAttempt{m_context.school.user, m_graded->record, m_graded->recording, m_graded->generation,
                           m_resume.fileOf(m_graded->generation)}));
}

/// Shows the score of an exam only when it is on the disk, or after a moment. A student whose program is killed before
/// has not seen the score and may continue; one who has seen it may not, whatever the disk says.
void GradingController::saveExam()
{
    saveGrade();
    m_scoreToShow = m_graded->record.uid;
    if (m_graded->keeping != Keeping::Pending)
        showExamsScore(m_scoreToShow);
    else
        QTimer::singleShot(kDiskPatienceMs, this, [this, uid = m_scoreToShow] { showExamsScore(uid); });
}

void GradingController::showExamsScore(const std::string& uid)
{
    if (m_scoreToShow != uid || !m_graded || m_graded->record.uid != uid)
        return;
    m_scoreToShow.clear();
    recordGraded();
    showGrade();
}

/// Notes in the recording, and so in the journal, that the attempt is graded: it is not offered as unfinished.
void GradingController::recordGraded()
{
    if (m_graded->generation == m_context.attempt.generation())
        m_context.window.send(core::session::AddNote{core::servo::kGradedNote});
}

void GradingController::handleSaved(const PendingAttempt& letter, bool isAgain)
{
    endJournal(letter);
    handleAnswer(letter, Keeping::Waiting);
    if (m_context.school.user != letter.who || m_uploader->hasAnyOf(m_context.school.user))
        return;
    m_context.window.hideGradeNotSaved();
    if (isAgain)
        m_context.window.showMessage(tr("The grade that could not be saved is now saved."));
}

void GradingController::handleRefused(const PendingAttempt& letter, bool isAgain, const core::Error& why)
{
    handleAnswer(letter, Keeping::Refused);
    if (m_context.school.user == letter.who && !isAgain)
        m_context.window.showGradeNotSaved(why);
}

void GradingController::handleAnswer(const PendingAttempt& letter, Keeping keeping)
{
    if (m_graded && m_graded->record.uid == letter.record.uid) {
        m_graded->keeping = keeping;
        updateKeeping();
    }
    showExamsScore(letter.record.uid);
    m_context.window.unsavedWork().setUnsavedGrades(m_uploader->count());
}

bool GradingController::isAsGraded() const
{
    const auto tooth = m_context.session.toothSoFar();
    return m_graded && m_graded->generation == m_context.attempt.generation() && tooth &&
           m_context.session.recordedGeneration() == m_context.attempt.generation() &&
           core::terrain::stateHash(*tooth) == m_graded->hash;
}

/// A saved attempt is not offered as unfinished. Work since the grade is another attempt.
void GradingController::endJournal(const PendingAttempt& letter)
{
    if (letter.generation == m_context.attempt.generation()) {
        if (isAsGraded())
            recordGraded();
        if (m_context.attempt.isResumed())
            m_resume.offerAnother();
    } else if (!letter.journal.empty()) {
        // The student has another tooth now, or has logged out.
        QThreadPool::globalInstance()->start(
            [journal = letter.journal, events = letter.recording.events()] { endKept(journal, events); });
    }
}

void GradingController::saveGuestsGrade()
{
    m_graded->keeping = Keeping::Pending;
    updateKeeping();
    // The recording of a guest does not name a person.
    m_graded->recording.append({core::servo::ServoEvent::Kind::Note, 0, glm::vec3(0.0F),
                                core::recording::personNote(m_context.school.user.uid())});
    m_context.school.service->ask(
        this,
        [who = m_context.school.user, lesson = m_graded->record.lessonId](const database::Repositories& school) {
            return school.lessons.attemptsLeft(who, lesson);
        },
        [this, who = m_context.school.user, record = m_graded->record,
         recording = m_graded->recording](const core::Result<std::optional<int>>& left) {
            const bool isOverLimit = who.role() == database::Role::Student && left && *left == 0;
            if (!m_graded || m_graded->record.uid != record.uid || m_context.school.user != who) {
                // The student works on something else by now.
                if (!isOverLimit)
                    m_uploader->send(std::make_shared<const PendingAttempt>(PendingAttempt{who, record, recording}));
                return;
            }
            m_graded->isOverLimit = isOverLimit;
            saveGrade();
            if (!m_graded->isOverLimit || m_graded->generation != m_context.attempt.generation())
                return;
            m_context.window.lessonController().setUsedUp(true);
            m_context.window.showOverLimit();
        });
}

/// Shows the grade of the current work, instead of an earlier attempt that was opened.
void GradingController::showGrade()
{
    m_opened.close();
    m_context.window.showScore(m_graded->sheet, m_graded->history, m_graded->expected, m_graded->work);
    updateKeeping();
}

/// Shows on the score page where the grade is saved, if the page shows that grade.
void GradingController::updateKeeping()
{
    if (m_opened.isShown())
        return;
    ui::scoring::ScorePage& page = m_context.window.scorePage();
    page.setHistory(m_graded->history);
    page.setKeeping(m_graded->keeping);
    if (m_graded->generation == m_context.attempt.generation() &&
        (m_graded->keeping == Keeping::Waiting || m_graded->keeping == Keeping::Kept))
        m_context.window.unsavedWork().setGradedSaved();
    if (m_graded->keeping == Keeping::Kept)
        page.setClass(m_graded->standing);
}

/// Reads the earlier grades of the same lesson, or without a lesson of the same tooth, and the rank in the class.
void GradingController::updateHistory()
{
    m_context.school.service->ask(
        this,
        [who = m_context.school.user, record = m_graded->record](const database::Repositories& school) {
            return school.lessons.contextOf(who, record, kHistoryLength);
        },
        [this, uid = m_graded->record.uid](const core::Result<database::GradeContext>& found) {
            if (!m_graded || m_graded->record.uid != uid)
                return;
            if (found) {
                m_graded->history = QList<database::AttemptRecord>(found->history.begin(), found->history.end());
                m_graded->standing = found->standing;
                m_context.window.lessonsPage().setAttemptsLeft(m_graded->record.lessonId, found->attemptsLeft);
                if (m_graded->generation == m_context.attempt.generation())
                    m_context.window.lessonController().setUsedUp(
                        m_context.school.user.role() == database::Role::Student && found->attemptsLeft == 0);
            } else {
                m_context.window.showError(found.error(), FailedOperation::KeepingGrades);
            }
            updateKeeping();
        });
}

}  // namespace app
