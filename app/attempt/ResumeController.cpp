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

/// Returns the folder of a user's unfinished attempts. Each has one of their own: nobody resumes another's attempt.
std::filesystem::path journalFolder(const QString& stationFolder, const database::Login& user)
{
    const QString name =
        user.isGuest() ? QStringLiteral("unfinished") : "unfinished/" + QString::fromStdString(user.uid());
    return std::filesystem::path(QDir(stationFolder).filePath(name).toStdU16String());
}

}  // namespace

ResumeController::ResumeController(const Parts& parts, std::chrono::milliseconds retry)
    : m_window(parts.window), m_session(parts.session), m_devices(parts.devices), m_presets(parts.presets),
      m_attempt(parts.attempt), m_attempts(parts.attempts), m_loads(parts.loads), m_limit(parts.limit),
      m_lessons(parts.lessons), m_school(parts.school)
{
    connect(&m_window, &MainWindow::resumeRequested, this, &ResumeController::requestResume);
    connect(&m_window, &MainWindow::discardRequested, this, &ResumeController::discard);
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
    if (m_devices.isSimulated())
        return;
    stopJournal(m_journal != nullptr && !m_school.user.isGuest());
    m_journal = std::make_unique<core::session::JournalLoop>(m_session, journalFolder(m_stationFolder, m_school.user));
    if (m_attempts.isTrial())
        m_journal->leaveOut(m_attempt.generation());
    m_journalThread =
        std::make_unique<LoopThread>(*m_journal, core::session::JournalLoop::kPeriod, LoopThread::Urgency::Normal);
    m_syncThread = std::make_unique<LoopThread>(m_journal->syncing(), core::session::JournalLoop::kSyncRest,
                                                LoopThread::Urgency::Normal);
    m_journalThread->start();
    m_syncThread->start();
    m_watch.start();
    offerUnfinished();
}

void ResumeController::stopJournal(bool putAway)
{
    m_watch.stop();
    m_lookAgain.stop();
    m_syncThread.reset();
    m_journalThread.reset();
    if (m_journal && putAway)
        m_journal->putAway();
    m_journal.reset();
    m_window.forgetAttemptNotKept();
    m_unfinished.reset();
}

void ResumeController::watchJournal()
{
    if (const auto failure = m_journal->failure())
        m_window.showError(*failure,
                           m_window.isExamRunning() ? FailedOperation::KeepingExam : FailedOperation::KeepingAttempt);
    else if (m_journal->isWell())
        m_window.forgetAttemptNotKept();
}

/// Lessons without an attempt left, and attempts that the school has already, are left out. A server that does not
/// answer is not waited for: what only its answer decides is looked for again.
void ResumeController::offerUnfinished()
{
    if (!m_school.isLoggedIn()) {
        searchUnfinished({{}, std::set<std::string>()});
        return;
    }
    const auto isDecided = std::make_shared<bool>(false);
    m_school.service->ask(
        this,
        [who = m_school.user](const database::Repositories& school) { return school.lessons.known(who, kNewestKept); },
        [this, isDecided, who = m_school.user](const core::Result<database::KnownAttempts>& known) {
            if (!std::exchange(*isDecided, true) && m_school.user == who)
                searchUnfinished(known.value_or(database::KnownAttempts()));
        });
    QTimer::singleShot(AttemptLimit::kPatienceMs, this, [this, isDecided, who = m_school.user] {
        if (!std::exchange(*isDecided, true) && m_school.user == who)
            searchUnfinished({});
    });
}

void ResumeController::searchUnfinished(const database::KnownAttempts& known)
{
    inBackground(
        this,
        [folder = journalFolder(m_stationFolder, m_school.user), outbox = QDir(m_stationFolder).filePath("outbox"),
         known, toBeKept = m_uploader ? m_uploader->journals() : std::set<std::filesystem::path>()] {
            return findUnfinished(folder, outbox, known, toBeKept);
        },
        [this, who = m_school.user](FoundUnfinished& found) {
            if (m_school.user != who)  // the search was for somebody who has left
                return;
            if (found.failure)
                m_window.showError(*found.failure, FailedOperation::ResumingAttempt);
            if (!found.attempt && m_unfinished)  // another search found it, and holds it
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
        m_window.forgetUnfinished();
        return;
    }
    const lessons::ReadLesson read =
        lessons::readLessonText(QByteArray::fromStdString(recording.lesson()), QStringLiteral("lesson"));
    m_window.offerUnfinished(
        [read, anatomy = recording.anatomy()] {
            return read.lesson ? ui::text::said(read.lesson->title) : ui::text::toothTitle(*anatomy);
        },
        QDateTime::fromMSecsSinceEpoch(m_unfinished->begunUtcMs), read.lesson && read.lesson->exam);
}

void ResumeController::requestResume()
{
    if (!m_unfinished)
        return;
    const int load = m_loads.begin();
    m_window.showBusy(tr("Resuming the attempt …"));
    if (const std::string lesson = limitedLessonOf(m_unfinished->recording); !lesson.empty())
        m_limit.whenAllowed(
            lesson, [this, load] { rebuild(load); },
            [this] {
                // The list of lessons may be read after this, and would offer the attempt again.
                m_unfinished.reset();
                m_window.forgetUnfinished();
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
            if (!m_loads.isLatest(load) || !m_unfinished || m_unfinished->path != path)  // another is offered by now
                return;
            if (attempt)
                resume(std::move(*attempt));
            else
                m_window.showError(attempt.error(), FailedOperation::ResumingAttempt);
        });
}

void ResumeController::resume(std::unique_ptr<core::session::ResumableAttempt> attempt)
{
    const auto assignment = lessons::assignmentOf(attempt->recording.anatomy(), attempt->recording.lesson());
    if (!assignment) {
        m_window.showError(assignment.error(), FailedOperation::ResumingAttempt);
        return;
    }
    if (!m_attempts.canLoad())
        return;  // it is still offered
    m_attempts.load(*assignment, attempt->recording.settings(), {}, false);
    m_attempts.endTrial();
    const core::settings::FeelPreset felt =
        core::settings::feltAs(m_presets.inUse(), m_attempt.settings().hardness, m_attempt.settings().force,
                               assignment->lesson ? assignment->lesson->kind : core::settings::ToothKind{});
    m_window.showFeel(felt, felt);
    m_attempt.resume(attempt->recording.ticks(), std::exchange(m_seenOfUnfinished, {}));
    const double recordedS = std::chrono::duration<double>(attempt->recording.duration()).count();
    double workedS = recordedS - attempt->restedS;
    // An exam's time goes on while its student is away, for whatever reason: otherwise they could think as long as they
    // like.
    if (assignment->lesson && assignment->lesson->exam)
        workedS = std::max(workedS,
                           1e-3 * static_cast<double>(QDateTime::currentMSecsSinceEpoch() - m_unfinished->begunUtcMs));
    m_window.resumeClock(recordedS, workedS);
    m_journal->takeUp(m_attempt.generation(), std::move(*m_unfinished));
    m_unfinished.reset();
    m_window.forgetUnfinished();  // it is offered again where the list of lessons was read meanwhile
    const auto [bur, handpiece] = std::pair(attempt->bur, attempt->handpiece);
    m_window.send(core::session::ResumeAttempt{std::move(attempt), m_attempt.generation()});
    m_window.takeInHand(bur, handpiece);
    if (m_attempt.seenBefore()) {
        m_window.endExam();
        gradeResumed(0);
        return;
    }
    const bool hasLimit = m_attempt.settings().force.workAreaMm > 0.0;
    m_window.showMessage(m_devices.isForceChosen() && !hasLimit
                             ? tr("Your attempt continues where you stopped. It was begun with the mouse: the device "
                                  "has no soft limit at the end of its reach in this attempt.")
                             : tr("Your attempt continues where you stopped."));
}

/// Grades an exam whose score was seen and was saved nowhere, once the session has its tooth.
void ResumeController::gradeResumed(int looks)
{
    if (m_session.recordedGeneration() == m_attempt.generation() && m_session.toothSoFar()) {
        emit gradeRequested();
        return;
    }
    if (looks < kMostLooks)
        QTimer::singleShot(kLookMs, this, [this, looks, generation = m_attempt.generation()] {
            if (generation == m_attempt.generation())
                gradeResumed(looks + 1);
        });
}

/// The attempt can be brought back for a week.
void ResumeController::discard()
{
    if (m_unfinished)
        if (const auto kept = core::recording::discardJournal(m_unfinished->path))
            m_window.offerToBringBack([this, kept = *kept] {
                if (core::recording::bringBackJournal(kept))
                    offerUnfinished();
                else
                    m_window.showMessage(tr("The attempt is no longer there."));
            });
    m_unfinished.reset();
    offerUnfinished();
}

}  // namespace app
