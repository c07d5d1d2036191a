// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/attempt/GradingController.h"

#include <cmath>
#include <utility>

#include <QDateTime>
#include <QThreadPool>
#include <QTimer>

#include "app/attempt/GradeDestination.h"
#include "app/attempt/ResumableAttempts.h"
#include "app/school/SchoolAccess.h"
#include "core/grading/Exercise.h"
#include "core/servo/ServoState.h"
#include "database/Passwords.h"
#include "database/Repositories.h"
#include "lessons/ScoreSheetJson.h"
#include "ui/tooth/ToothView.h"

namespace app {
namespace {

using ui::text::FailedOperation;
using ui::window::MainWindow;

constexpr int kHistoryLength = 12;
constexpr double kMnPerN = 1000.0;
constexpr double kMsPerS = 1000.0;
constexpr int kSettleMs = 20;
constexpr int kSettledLooks = 3;  ///< in a row that find the bur out of the tooth
constexpr int kMostSettleLooks = 25;
constexpr int kDiskPatienceMs = 1500;  ///< with the disk, before the score of an exam is shown

}  // namespace

GradingController::GradingController(const Parts& parts)
    : m_window(parts.window), m_channels(parts.channels), m_session(parts.session), m_assessment(parts.assessment),
      m_devices(parts.devices), m_attempt(parts.attempt), m_attempts(parts.attempts), m_resume(parts.resume),
      m_observer(parts.observer), m_limit(parts.limit), m_opened(parts.opened), m_school(parts.school)
{
    connect(&m_window, &MainWindow::gradeRequested, this, &GradingController::requestGrade);
    connect(&m_window, &MainWindow::forecastGiven, this,
            [this](const ui::scoring::ScorePrediction& expected) { finish(expected); });
    connect(&m_resume, &ResumeController::gradeRequested, this, &GradingController::requestGrade);
    connect(&m_attempts, &AttemptController::aboutToLoad, this, [this] { m_analysis.forget(); });
    connect(&m_attempts, &AttemptController::cleared, this, [this] { m_graded.reset(); });
    m_analysis.showOn(m_window.scorePage(), [this] { return !m_opened.isShown(); });
    connect(&m_analysis, &ScoreAnalysis::failed, this, [this](const core::Error& error) {
        if (!m_opened.isShown())
            m_window.showError(error, FailedOperation::Marking);
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
    return ReportController::Subject{m_graded->record, QString::fromStdString(m_school.user.fullName()), m_school.user,
                                     m_graded->keeping == Keeping::Kept ? m_school.service : nullptr};
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
    if (!m_attempt.settle())
        return;
    m_window.view().release();
    settle(0, 0);
}

/// Waits until the bur has left the tooth: what is cut while the work is graded would belong to no attempt. A hand that
/// stays in the tooth is waited for half a second.
void GradingController::settle(int looks, int settled)
{
    const core::servo::ServoState& servo = m_channels.servo.latest();
    const bool isOut = !(servo.touching && servo.drillOn);
    settled = isOut ? settled + 1 : 0;
    if (settled >= kSettledLooks || looks >= kMostSettleLooks) {
        gradeNow();
        m_attempt.stopSettling();
        return;
    }
    QTimer::singleShot(kSettleMs, this, [this, looks, settled, generation = m_attempt.generation()] {
        if (generation != m_attempt.generation())
            return;
        if (!m_attempt.isResting())
            settle(looks + 1, settled);
        else
            m_attempt.stopSettling();
    });
}

void GradingController::gradeNow()
{
    const auto tooth = m_session.toothSoFar();
    if (!tooth || m_session.recordedGeneration() != m_attempt.generation()) {
        m_window.showMessage(tr("The tooth is not ready yet. Try again in a moment."));
        return;
    }
    const std::uint64_t hash = core::terrain::stateHash(*tooth);
    std::optional<core::grading::Practised> practised;
    if (const core::session::Findings now = m_assessment.findings(); now.generation == m_attempt.generation())
        practised = now.practised;
    if (m_graded && m_graded->generation == m_attempt.generation() && m_graded->hash == hash &&
        m_graded->practised == practised) {
        showGrade();
        if (m_graded->keeping == Keeping::Nowhere)
            saveGrade();  // what failed may work now
        m_analysis.tellAgain();
        return;
    }
    if (m_attempt.assignment().exercise && !(practised && core::grading::isBegun(*practised))) {
        m_window.showMessage(m_attempt.assignment().lesson &&
                                     m_attempt.assignment().lesson->task == lessons::Task::TellLayers
                                 ? tr("No pad has an answer yet. Choose below the view what each pad is made of.")
                                 : tr("This exercise has not been started yet, so there is nothing to grade."));
        return;
    }
    if (!m_attempt.assignment().exercise && tooth->top == tooth->anatomy->top) {
        m_window.showMessage(tr("Nothing has been cut yet, so there is nothing to grade."));
        return;
    }
    // Neither the time of the prediction counts, nor work after the end of an exam.
    m_attempt.conclude([this] { return m_assessment.conclude(); }, m_window.isExamOver());
    // An exam was counted when it began. Further work that is graded again is one more attempt.
    const bool isAnother = m_attempt.isGraded();
    const bool isCounted = m_attempt.exam() == CurrentAttempt::Exam::Counted;
    if (!m_attempt.assignment().lesson)
        finish({});
    else if (m_attempt.seenBefore() && !isAnother)  // the student has seen the score already
        finish(m_attempt.seenBefore()->expectedTenths
                   ? std::optional(ui::scoring::ScorePrediction{*m_attempt.seenBefore()->expectedTenths, {}})
                   : std::nullopt);
    else if (m_attempt.isExam() && isCounted && !isAnother)
        m_window.askForecast();
    else
        m_limit.whenAllowed(m_attempt.assignment().lesson->id, [this] { m_window.askForecast(); });
}

/// Marks the work as it was when the grade was requested, saves the grade and shows it.
void GradingController::finish(const std::optional<ui::scoring::ScorePrediction>& expected)
{
    const auto done = m_attempt.grade();
    if (!done)
        return;
    const core::session::Findings& found = done->findings;
    const lessons::Conduct conduct{found.process, found.infractions, found.aids, found.practised};
    const auto marked = lessons::mark(m_attempt.assignment(), done->tooth, conduct);
    if (!marked) {
        m_window.showError(marked.error(), FailedOperation::Marking);
        return;
    }
    const lessons::ScoreSheet& sheet = marked->sheet;
    const std::uint64_t hash = core::terrain::stateHash(done->tooth);
    m_graded = {m_attempt.generation(),
                hash,
                sheet,
                recordOf(*done, sheet, expected),
                Keeping::Nowhere,
                {},
                {},
                expected,
                {std::make_shared<const core::terrain::Tooth>(done->tooth), m_attempt.assignment().shownIdeal(),
                 marked->measured, found.infractions, found.aids,
                 // The card of the trial names the preset, or in a blind comparison hides it.
                 m_attempts.isTrial() ? std::nullopt : std::optional(lessons::presetUsed(done->recording)),
                 m_attempt.assignment().exercise},
                done->recording,
                found.practised};
    if (m_attempt.isExam())
        saveExam();
    else {
        showGrade();
        saveGrade();
    }
    m_analysis.explain(m_attempt.assignment(), m_graded->recording, m_graded->work.tooth, conduct);
}

database::AttemptRecord GradingController::recordOf(const core::session::AttemptSnapshot& done,
                                                    const lessons::ScoreSheet& sheet,
                                                    const std::optional<ui::scoring::ScorePrediction>& expected) const
{
    const auto preset = lessons::presetUsed(done.recording);
    database::AttemptRecord record;
    record.uid = database::newUid();
    record.finishedUtc = QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString();
    record.tooth = m_attempt.assignment().anatomy->name;
    record.scoreTenths = sheet.totalTenths;
    record.passed = sheet.passed();
    record.passMarkTenths = sheet.passMarkTenths;
    record.rubricHash = sheet.rubricHash;
    if (expected)
        record.expectedTenths = expected->tenths;
    if (m_attempt.assignment().lesson) {
        record.lessonId = m_attempt.assignment().lesson->id;
        record.lessonHash = m_attempt.assignment().lesson->hash;
    }
    for (const lessons::Criterion& criterion : sheet.criteria)
        record.criteria.push_back({criterion.id, criterion.lostTenths, criterion.weightTenths});
    record.durationMs = std::llround(kMsPerS * done.findings.process.totalS);
    record.scoreSheetJson = lessons::toJson(sheet, preset).toStdString();
    record.stateHash =
        QStringLiteral("%1").arg(core::terrain::stateHash(done.tooth), 16, 16, QLatin1Char('0')).toStdString();
    record.device = m_observer.hand().toStdString();
    record.method = m_attempt.settings().method;
    record.grid = m_attempt.assignment().anatomy->grid.side;
    record.viewMode = ui::render::idOf(m_observer.picture());
    record.seed = std::to_string(m_attempt.assignment().anatomy->seed);
    record.preset = preset.name.toStdString() + (preset.version > 0 ? " v" + std::to_string(preset.version) : "") +
                    (preset.isChanged ? ", changed" : "");
    record.presetHash = preset.hash.toStdString();
    record.program = CUSP_VERSION;
    if (const auto& force = done.findings.process.force) {
        record.meanForceMn = static_cast<int>(std::lround(force->meanN * kMnPerN));
        record.peakForceMn = static_cast<int>(std::lround(force->largestN * kMnPerN));
    }
    return record;
}

/// Sends the grade to the outbox, and from there to the database.
void GradingController::saveGrade()
{
    m_graded->keeping = destinationOf({.hasDatabase = m_school.service != nullptr,
                                       .isGuest = m_school.user.isGuest(),
                                       .isExam = m_attempt.isExam(),
                                       .isResumed = m_attempt.isResumed(),
                                       .isSimulated = m_devices.isSimulated(),
                                       .isTrial = m_attempts.isTrial(),
                                       .isOverLimit = m_graded->isOverLimit});
    updateKeeping();
    if (m_graded->keeping != Keeping::Pending)
        recordGraded();
    else
        m_uploader->send(std::make_shared<const PendingAttempt>(
            PendingAttempt{m_school.user, m_graded->record, m_graded->recording, m_graded->generation,
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
    if (m_graded->generation == m_attempt.generation())
        static_cast<void>(m_channels.commands.tryPush(core::session::AddNote{core::servo::kGradedNote}));
}

void GradingController::handleSaved(const PendingAttempt& letter, bool isAgain)
{
    endJournal(letter);
    handleAnswer(letter, Keeping::Waiting);
    if (m_school.user != letter.who || m_uploader->hasAnyOf(m_school.user))
        return;
    m_window.forgetNotKept();
    if (isAgain)
        m_window.showMessage(tr("The grade that could not be saved is now saved."));
}

void GradingController::handleRefused(const PendingAttempt& letter, bool isAgain, const core::Error& why)
{
    handleAnswer(letter, Keeping::Refused);
    if (m_school.user == letter.who && !isAgain)
        m_window.showNotKept(why);
}

void GradingController::handleAnswer(const PendingAttempt& letter, Keeping keeping)
{
    if (m_graded && m_graded->record.uid == letter.record.uid) {
        m_graded->keeping = keeping;
        updateKeeping();
    }
    showExamsScore(letter.record.uid);
    m_window.setUnkeptGrades(m_uploader->count());
}

bool GradingController::isAsGraded() const
{
    const auto tooth = m_session.toothSoFar();
    return m_graded && m_graded->generation == m_attempt.generation() && tooth &&
           m_session.recordedGeneration() == m_attempt.generation() &&
           core::terrain::stateHash(*tooth) == m_graded->hash;
}

/// A saved attempt is not offered as unfinished. Work since the grade is another attempt.
void GradingController::endJournal(const PendingAttempt& letter)
{
    if (letter.generation == m_attempt.generation()) {
        if (isAsGraded())
            recordGraded();
        if (m_attempt.isResumed())
            m_resume.offerAnother();
    } else if (!letter.journal.empty()) {
        // The student has another tooth by now, or has logged out.
        QThreadPool::globalInstance()->start(
            [journal = letter.journal, events = letter.recording.events()] { endKept(journal, events); });
    }
}

void GradingController::saveGuestsGrade()
{
    m_graded->keeping = Keeping::Pending;
    updateKeeping();
    m_school.service->ask(
        this,
        [who = m_school.user, lesson = m_graded->record.lessonId](const database::Repositories& school) {
            return school.lessons.attemptsLeft(who, lesson);
        },
        [this, who = m_school.user, record = m_graded->record,
         recording = m_graded->recording](const core::Result<std::optional<int>>& left) {
            const bool isOverLimit = who.role() == database::Role::Student && left && *left == 0;
            if (!m_graded || m_graded->record.uid != record.uid || m_school.user != who) {
                // The student works on something else by now.
                if (!isOverLimit)
                    m_uploader->send(std::make_shared<const PendingAttempt>(PendingAttempt{who, record, recording}));
                return;
            }
            m_graded->isOverLimit = isOverLimit;
            saveGrade();
            if (!m_graded->isOverLimit || m_graded->generation != m_attempt.generation())
                return;
            m_window.setUsedUp(true);
            m_window.showOverLimit();
        });
}

/// Shows the grade of the current work, instead of an earlier attempt that was opened.
void GradingController::showGrade()
{
    m_opened.close();
    m_window.showScore(m_graded->sheet, m_graded->history, m_graded->expected, m_graded->work);
    updateKeeping();
}

/// Shows on the score page where the grade is saved, if the page shows that grade.
void GradingController::updateKeeping()
{
    if (m_opened.isShown())
        return;
    ui::scoring::ScorePage& page = m_window.scorePage();
    page.setHistory(m_graded->history);
    page.setKeeping(m_graded->keeping);
    if (m_graded->generation == m_attempt.generation() &&
        (m_graded->keeping == Keeping::Waiting || m_graded->keeping == Keeping::Kept))
        m_window.showWorkKept();
    if (m_graded->keeping == Keeping::Kept)
        page.setClass(m_graded->standing);
}

/// Reads the earlier grades of the same lesson, or without a lesson of the same tooth, and the rank in the class.
void GradingController::updateHistory()
{
    m_school.service->ask(
        this,
        [who = m_school.user, record = m_graded->record](const database::Repositories& school) {
            return school.lessons.contextOf(who, record, kHistoryLength);
        },
        [this, uid = m_graded->record.uid](const core::Result<database::GradeContext>& found) {
            if (!m_graded || m_graded->record.uid != uid)
                return;
            if (found) {
                m_graded->history = QList<database::AttemptRecord>(found->history.begin(), found->history.end());
                m_graded->standing = found->standing;
                m_window.lessonsPage().setAttemptsLeft(m_graded->record.lessonId, found->attemptsLeft);
                if (m_graded->generation == m_attempt.generation())
                    m_window.setUsedUp(m_school.user.role() == database::Role::Student && found->attemptsLeft == 0);
            } else {
                m_window.showError(found.error(), FailedOperation::KeepingGrades);
            }
            updateKeeping();
        });
}

}  // namespace app
