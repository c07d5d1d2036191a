// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/attempt/ResumeController.h"

#include <algorithm>
#include <chrono>
#include <set>
#include <utility>

#include <QDateTime>
#include <QDir>

#include "app/school/SchoolAccess.h"
#include "app/threads/Background.h"
#include "core/session/ResumableAttempt.h"
#include "core/settings/FeelPreset.h"
#include "lessons/LessonReader.h"
#include "ui/text/LessonTexts.h"

namespace app {
namespace {

using ui::text::FailedOperation;
using ui::window::MainWindow;

constexpr int kJournalPeriodMs = 500;
constexpr int kLookMs = 20;  ///< between two looks whether the session has a resumed attempt
constexpr int kMostLooks = 250;

/// Returns the folder of a user's unfinished attempts.
std::filesystem::path journalFolder(const QString& stationFolder, const database::Login& user)
{
    const QString name =
        user.isGuest() ? QStringLiteral("unfinished") : "unfinished/" + QString::fromStdString(user.uid());
    return std::filesystem::path(QDir(stationFolder).filePath(name).toStdU16String());
}

}  // namespace

ResumeController::ResumeController(const AttemptContext& context, AttemptController& attempts,
                                   LessonsController& lessons, std::chrono::milliseconds retry)
    : m_context(context), m_attempts(attempts), m_lessons(lessons)
{
    connect(&m_context.window.resumeOffer(), &ui::window::ResumeOffer::resumeRequested, this,
            &ResumeController::requestResume);
    connect(&m_context.window.resumeOffer(), &ui::window::ResumeOffer::discardRequested, this,
            &ResumeController::discard);
    connect(&m_lessons, &LessonsController::shown, this, &ResumeController::showOffer);
    connect(&m_attempts, &AttemptController::nobodysBegun, this, &ResumeController::leaveOut);
    connect(&m_attempts, &AttemptController::becameNobodys, this, [this] { stopJournal(true); });
    connect(&m_attempts, &AttemptController::becameSomebodys, this, [this](std::uint64_t nobodys) {
        startJournal();
        leaveOut(nobodys);
    });
    m_watch.setInterval(kJournalPeriodMs);
    connect(&m_watch, &QTimer::timeout, this, &ResumeController::watchJournal);
    m_lookAgain.setInterval(retry);
    m_lookAgain.setSingleShot(true);
    connect(&m_lookAgain, &QTimer::timeout, this, &ResumeController::offerAnother);
}

ResumeController::~ResumeController() = default;

std::filesystem::path ResumeController::fileOf(std::uint64_t generation) const
{
    return m_journal ? m_journal->fileOf(generation) : std::filesystem::path();
}

void ResumeController::leaveOut(std::uint64_t generation)
{
    if (m_journal)
        m_journal->leaveOut(generation);
}

void ResumeController::offerAnother()
{
    if (!m_unfinished)
        offerUnfinished();
}

void ResumeController::startJournal()
{
    if (m_context.devices.isSimulated())
        return;
    stopJournal(m_journal != nullptr && !m_context.school.user.isGuest());
    m_journal = std::make_unique<core::session::JournalLoop>(m_context.session,
                                                             journalFolder(m_stationFolder, m_context.school.user));
    if (m_attempts.isTrial())
        m_journal->leaveOut(m_context.attempt.generation());
    m_journalThread =
        std::make_unique<LoopThread>(*m_journal, core::session::JournalLoop::kPeriod, LoopThread::Urgency::Normal);
    m_syncThread = std::make_unique<LoopThread>(m_journal->syncing(), core::session::JournalLoop::kSyncRest,
                                                LoopThread::Urgency::Normal);
    m_journalThread->start();
    m_syncThread->start();
    m_watch.start();
    offerUnfinished();
}

void ResumeController::stopJournal(bool isDiscarded)
{
    m_watch.stop();
    m_lookAgain.stop();
    m_syncThread.reset();
    m_journalThread.reset();
    if (m_journal && isDiscarded)
        m_journal->putAway();
    m_journal.reset();
    m_context.window.hideJournalError();
    m_unfinished.reset();
}

void ResumeController::watchJournal()
{
    if (const auto failure = m_journal->failure())
        m_context.window.showJournalError(*failure, m_context.window.isExamRunning() ? FailedOperation::KeepingExam
                                                                                     : FailedOperation::KeepingAttempt);
    else if (m_journal->isWell())
        m_context.window.hideJournalError();
}

/// Searches for an unfinished attempt. Leaves out lessons without an attempt left, and attempts that the database has
/// already. If the database does not answer in time, an attempt that depends on its answer is searched for again later.
void ResumeController::offerUnfinished()
{
    if (!m_context.school.isLoggedIn()) {
        searchUnfinished({{}, std::set<std::string>()});
        return;
    }
    const auto isDecided = std::make_shared<bool>(false);
    m_context.school.service->ask(
        this,
        [who = m_context.school.user](const database::Repositories& school) {
            return school.lessons.known(who, kNewestKept);
        },
        [this, isDecided, who = m_context.school.user](const core::Result<database::KnownAttempts>& known) {
            if (!std::exchange(*isDecided, true) && m_context.school.user == who)
                searchUnfinished(known.value_or(database::KnownAttempts()));
        });
    QTimer::singleShot(AttemptLimit::kPatienceMs, this, [this, isDecided, who = m_context.school.user] {
        if (!std::exchange(*isDecided, true) && m_context.school.user == who)
            searchUnfinished({});
    });
}

void ResumeController::searchUnfinished(const database::KnownAttempts& known)
{
    inBackground(
        this,
        [folder = journalFolder(m_stationFolder, m_context.school.user),
         outbox = QDir(m_stationFolder).filePath("outbox"), known,
         toBeKept = m_uploader ? m_uploader->journals() : std::set<std::filesystem::path>()] {
            return findUnfinished(folder, outbox, known, toBeKept);
        },
        [this, who = m_context.school.user](FoundUnfinished& found) {
            if (m_context.school.user != who)  // the user has logged out meanwhile
                return;
            if (found.failure)
                m_context.window.showError(*found.failure, FailedOperation::ResumingAttempt);
            if (!found.attempt && m_unfinished)  // an earlier search holds the attempt's file
                return;
            m_unfinished = std::move(found.attempt);
            if (found.isUndecided && !m_unfinished)
                m_lookAgain.start();
            m_seenOfUnfinished = found.seen;
            showOffer();
        });
}

void ResumeController::showOffer()
{
    if (!m_unfinished)
        return;
    const core::recording::Recording& recording = m_unfinished->recording;
    if (m_lessons.isUsedUp(limitedLessonOf(recording))) {
        m_context.window.resumeOffer().forget();
        return;
    }
    const lessons::ReadLesson read =
        lessons::readLessonText(QByteArray::fromStdString(recording.lesson()), QStringLiteral("lesson"));
    m_context.window.resumeOffer().offer(
        [read, anatomy = recording.anatomy()] {
            return read.lesson ? ui::text::said(read.lesson->title) : ui::text::toothTitle(*anatomy);
        },
        QDateTime::fromMSecsSinceEpoch(m_unfinished->begunUtcMs), read.lesson && read.lesson->exam);
}

void ResumeController::requestResume()
{
    if (!m_unfinished)
        return;
    const int load = m_context.loads.begin();
    m_context.window.showBusy(tr("Resuming the attempt …"));
    if (const std::string lesson = limitedLessonOf(m_unfinished->recording); !lesson.empty())
        m_context.limit.whenAllowed(
            lesson, [this, load] { rebuild(load); },
            [this] {
                // The list of lessons may be read after this, and would offer the attempt again.
                m_unfinished.reset();
                m_context.window.resumeOffer().forget();
            });
    else
        rebuild(load);
}

void ResumeController::rebuild(int load)
{
    if (!m_unfinished)
        return;
    inBackground(
        this,
        [recording = m_unfinished->recording, workOut = m_attempts.surfaceWorker()] {
            workOut(recording.anatomy());
            return core::session::rebuild(recording);
        },
        [this, load,
         path = m_unfinished->path](core::Result<std::unique_ptr<core::session::ResumableAttempt>>& attempt) {
            if (!m_context.loads.isLatest(load) || !m_unfinished ||
                m_unfinished->path != path)  // another attempt is offered now
                return;
            if (attempt)
                resume(std::move(*attempt));
            else
                m_context.window.showError(attempt.error(), FailedOperation::ResumingAttempt);
        });
}

void ResumeController::resume(std::unique_ptr<core::session::ResumableAttempt> attempt)
{
    const auto assignment = lessons::assignmentOf(attempt->recording.anatomy(), attempt->recording.lesson());
    if (!assignment) {
        m_context.window.showError(assignment.error(), FailedOperation::ResumingAttempt);
        return;
    }
    if (!m_attempts.canLoad())
        return;  // it is still offered
    m_attempts.load(*assignment, attempt->recording.settings(), {}, false);
    m_attempts.endTrial();
    const core::settings::FeelPreset felt = core::settings::feltAs(
        m_context.presets.inUse(), m_context.attempt.settings().hardness, m_context.attempt.settings().force,
        assignment->lesson ? assignment->lesson->kind : core::settings::ToothKind{});
    m_context.window.hardness().setFeel(felt, felt);
    m_context.attempt.resume(attempt->recording.ticks(), std::exchange(m_seenOfUnfinished, {}));
    const double recordedS = std::chrono::duration<double>(attempt->recording.duration()).count();
    double workedS = recordedS - attempt->restedS;
    // The time of an exam goes on while the program is closed. Otherwise a student could think as long as they like.
    if (assignment->lesson && assignment->lesson->exam)
        workedS = std::max(workedS,
                           1e-3 * static_cast<double>(QDateTime::currentMSecsSinceEpoch() - m_unfinished->begunUtcMs));
    m_context.window.lessonController().resumeClock(recordedS, workedS);
    m_journal->takeUp(m_context.attempt.generation(), std::move(*m_unfinished));
    m_unfinished.reset();
    m_context.window.resumeOffer().forget();  // the list of lessons may have offered it again meanwhile
    const auto [bur, handpiece] = std::pair(attempt->bur, attempt->handpiece);
    m_context.window.send(core::session::ResumeAttempt{std::move(attempt), m_context.attempt.generation()});
    m_context.window.burControl().resume(bur, handpiece);
    if (m_context.attempt.seenBefore()) {
        m_context.window.lessonController().endExam();
        gradeResumed(0);
        return;
    }
    const bool hasLimit = m_context.attempt.settings().force.workAreaMm > 0.0;
    m_context.window.showMessage(
        m_context.devices.isForceChosen() && !hasLimit
            ? tr("Your attempt continues where you stopped. It was begun with the mouse: the device "
                 "has no soft limit at the end of its reach in this attempt.")
            : tr("Your attempt continues where you stopped."));
}

/// Grades an exam whose score was seen and was saved nowhere, once the session has its tooth.
void ResumeController::gradeResumed(int looks)
{
    if (m_context.session.recordedGeneration() == m_context.attempt.generation() && m_context.session.toothSoFar()) {
        emit gradeRequested();
        return;
    }
    if (looks < kMostLooks)
        QTimer::singleShot(kLookMs, this, [this, looks, generation = m_context.attempt.generation()] {
            if (generation == m_context.attempt.generation())
                gradeResumed(looks + 1);
        });
}

/// Discards the attempt that is offered. It can be restored for a week.
void ResumeController::discard()
{
    if (m_unfinished)
        if (const auto kept = core::recording::discardJournal(m_unfinished->path))
            m_context.window.resumeOffer().offerToRestore([this, kept = *kept] {
                if (core::recording::bringBackJournal(kept))
                    offerUnfinished();
                else
                    m_context.window.showMessage(tr("The attempt is no longer there."));
            });
    m_unfinished.reset();
    offerUnfinished();
}

}  // namespace app
