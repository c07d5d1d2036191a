// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/replay/PlaybackController.h"

#include <chrono>
#include <filesystem>
#include <thread>
#include <utility>

#include <QFileInfo>

#include "app/attempt/Demonstration.h"
#include "app/threads/Background.h"
#include "lessons/LessonCatalog.h"
#include "lessons/LessonReader.h"
#include "ui/scoring/ScorePage.h"
#include "ui/tooth/ToothView.h"

namespace app {
namespace {

using ui::text::FailedOperation;
using ui::window::MainWindow;

/// Returns what a recording was made for. The expert's attempt is that of the lesson as it is today.
core::Result<lessons::Assignment> playedFor(const std::shared_ptr<const core::terrain::ToothAnatomy>& anatomy,
                                            const std::string& lessonJson)
{
    auto assignment = lessons::assignmentOf(anatomy, lessonJson);
    if (assignment && assignment->lesson && assignment->lesson->expert)
        for (const lessons::CatalogEntry& entry : lessons::readCatalog(lessons::teachersFolder()))
            if (!entry.isFaulty() && entry.read.lesson->id == assignment->lesson->id && entry.read.lesson->expert)
                assignment->lesson->expert = entry.read.lesson->expert;
    return assignment;
}

}  // namespace

PlaybackController::PlaybackController(const AttemptContext& context, const Others& others, bool isForPicture)
    : m_context(context), m_servo(others.servo), m_sound(others.sound), m_bur(others.bur), m_attempts(others.attempts),
      m_opened(others.opened), m_grading(others.grading), m_isForPicture(isForPicture)
{
    connect(&m_context.window, &MainWindow::recordingOpenRequested, this, &PlaybackController::openRecording);
    connect(&m_context.window.replayView(), &ui::window::ReplayView::besideRequested, this,
            &PlaybackController::openBeside);
    connect(&m_context.window.replayView(), &ui::window::ReplayView::expertRequested, this,
            &PlaybackController::openExpert);
    connect(&m_context.window, &MainWindow::replayStopRequested, this, &PlaybackController::stopReplay);
    connect(&m_context.window.scorePage(), &ui::scoring::ScorePage::momentRequested, this,
            &PlaybackController::showMoment);
    connect(&m_context.window.scorePage(), &ui::scoring::ScorePage::replayRequested, this, [this] {
        if (m_opened.recording() != nullptr)
            playOpened({});
    });
    connect(&m_attempts, &AttemptController::aboutToLoad, this, &PlaybackController::leaveToAnotherTooth);
}

void PlaybackController::setHistory(AttemptHistoryController* history)
{
    m_history = history;
    if (history == nullptr)
        return;
    connect(history, &AttemptHistoryController::replayRequested, this, &PlaybackController::playKept);
    connect(
        history, &AttemptHistoryController::besideRequested, this,
        [this](const core::recording::Recording& recording, const QString& name) { compareWith(recording, name, {}); });
}

void PlaybackController::playKept(const core::recording::Recording& recording, const database::AttemptRecord& attempt,
                                  const QString& whose)
{
    if (m_opened.isRefusedInExam())
        return;
    const int load = m_context.loads.begin();
    inBackground(
        this,
        [anatomy = recording.anatomy(), workOut = m_attempts.surfaceWorker()] {
            workOut(anatomy);
            return anatomy;
        },
        [this, load, recording, attempt, whose](const auto&) {
            if (!m_context.loads.isLatest(load) || !play(recording, {}, whose))
                return;
            m_playedFrom = PlayedFrom::Attempts;
            m_history->followReplay(attempt);
        });
}

void PlaybackController::leaveToAnotherTooth()
{
    if (!m_replay)
        return;
    endReplay();
    m_context.window.setReplaying(false);
    showOwn();
}

std::optional<glm::dvec3> PlaybackController::leadMm()
{
    if (!m_replay || !m_replay->isLeading())
        return std::nullopt;
    return m_shown.servo.latest().anchorMm;
}

/// Lets the servo rest, and returns when it has finished its tick: nobody else uses the device then.
void PlaybackController::rest()
{
    m_servo.setResting(true);
    while (!m_servo.isResting())
        std::this_thread::sleep_for(std::chrono::microseconds(100));
    m_sound.play(m_shown.sound);
}

void PlaybackController::showOwn()
{
    m_context.window.showChannels(m_context.channels);
    m_sound.play(m_context.channels.sound);
    m_servo.setResting(false);
}

void PlaybackController::openRecording(const QString& path)
{
    readRecording(path, [this](const core::recording::Recording& recording) { play(recording); });
}

void PlaybackController::openBeside(const QString& path)
{
    readRecording(path, [this, path](const core::recording::Recording& recording) {
        compareWith(recording, QFileInfo(path).completeBaseName(), path);
    });
}

void PlaybackController::compareWith(const core::recording::Recording& recording, const QString& name,
                                     const QString& path)
{
    if (!m_replay)
        return;
    if (const auto put = m_replay->putBeside(recording, name); !put)
        m_attempts.refuse(put.error(), FailedOperation::OpeningRecording, path);
}

/// Opens the expert's attempt at the lesson of the attempt that is played, or of the current one.
void PlaybackController::openExpert()
{
    if (!m_replay) {
        if (m_context.attempt.assignment().lesson)
            openExpertAt(m_context.attempt.assignment());
        return;
    }
    if (!m_replay->attempt().lesson())
        return;
    const int load = m_context.loads.begin();
    m_context.window.showBusy(tr("Preparing the lesson …"));
    inBackground(
        this,
        [anatomy = m_replayed, lesson = m_replay->attempt().lesson()->json] { return playedFor(anatomy, lesson); },
        [this, load](const core::Result<lessons::Assignment>& assignment) {
            if (!m_context.loads.isLatest(load))
                return;
            if (!assignment)
                m_attempts.refuse(assignment.error(), FailedOperation::OpeningLesson, {});
            else if (m_replay)
                openExpertAt(*assignment);
            else
                m_context.window.stopBusy();
        });
}

/// Opens the recording that the lesson names. If it names none, a simulated hand does the lesson.
void PlaybackController::openExpertAt(const lessons::Assignment& assignment)
{
    if (!assignment.lesson->expert) {
        openDemonstration(assignment);
        return;
    }
    const QString path = QString::fromStdString(assignment.lesson->expert->file);
    readRecording(
        path,
        [this, path](const core::recording::Recording& recording) { showExpert(recording, tr("The expert"), path); },
        [assignment] { return lessons::readExpert(assignment); });
}

void PlaybackController::openDemonstration(const lessons::Assignment& assignment)
{
    const int load = m_context.loads.begin();
    m_context.window.showBusy(tr("A simulated hand does the lesson …"));
    inBackground(
        this,
        [assignment, workOut = m_attempts.surfaceWorker()]() -> std::optional<core::recording::Recording> {
            const auto outcome = demonstrate(assignment, false);
            workOut(assignment.anatomy);
            const auto marked = outcome ? lessons::markAgain(*outcome->recording)
                                        : core::Result<lessons::Remarked>(tl::unexpected(outcome.error()));
            return marked && marked->mark.sheet.passed() ? outcome->recording : std::nullopt;
        },
        [this, load](const std::optional<core::recording::Recording>& recording) {
            if (!m_context.loads.isLatest(load))
                return;
            if (recording)
                showExpert(*recording, tr("The simulated hand"), {});
            else
                m_context.window.stopBusy();
            m_context.window.showMessage(
                recording ? tr("No teacher has recorded this lesson, so a simulated hand shows it.")
                          : tr("No teacher has recorded this lesson, and the simulated hand cannot do it."));
        });
}

/// Plays a recording beside the attempt that is played, or by itself if none is.
void PlaybackController::showExpert(const core::recording::Recording& recording, const QString& name,
                                    const QString& path)
{
    if (m_replay)
        compareWith(recording, name, path);
    else
        play(recording);
}

void PlaybackController::readRecording(const QString& path, const UseRecording& use)
{
    readRecording(path, use,
                  [path] { return core::recording::readRecording(std::filesystem::path(path.toStdU16String())); });
}

void PlaybackController::readRecording(const QString& path, const UseRecording& use, const ReadRecording& read)
{
    const int load = m_context.loads.begin();
    m_context.window.showBusy(tr("Reading %1 …").arg(QFileInfo(path).fileName()));
    inBackground(
        this,
        [read, workOut = m_attempts.surfaceWorker()] {
            auto recording = read();
            if (recording)
                workOut(recording->anatomy());
            return recording;
        },
        [this, load, path, use](const core::Result<core::recording::Recording>& recording) {
            if (!m_context.loads.isLatest(load))
                return;
            if (recording)
                use(*recording);
            else
                m_attempts.refuse(recording.error(), FailedOperation::OpeningRecording, path);
        });
}

/// The student's own attempt stays in the session and the servo, which rests meanwhile.
bool PlaybackController::play(const core::recording::Recording& recording, std::optional<double> momentS,
                              const QString& whose)
{
    // The button for the guidance is there while the hand in use has a force.
    const std::uint64_t generation = m_attempts.nextGeneration();
    auto replay = ReplayController::make(recording, m_shown, m_context.window, generation, &m_bur);
    if (!replay) {
        m_attempts.refuse(replay.error(), FailedOperation::OpeningRecording, {});
        return false;
    }
    if (m_replay) {
        endReplay();
    } else {
        rest();
        m_context.window.view().storeCamera();
    }
    m_replay = std::move(*replay);
    m_replayed = recording.anatomy();
    m_context.attempt.setResting(true);
    m_context.window.showChannels(m_shown);
    m_context.window.setReplaying(true, m_replay->attempt().lengthS(), m_replay->attempt().ideal(),
                                  m_replay->attempt().lesson(), whose);
    m_context.window.setHandpieces(recording.settings().handpieces);
    m_context.window.showTooth(m_replayed, generation, {});
    if (m_isForPicture)
        m_replay->goToEnd();
    if (momentS)
        m_replay->playTo(*momentS);
    m_replay->start();
    return true;
}

void PlaybackController::showMoment(double seconds)
{
    if (m_opened.recording() != nullptr)
        playOpened(seconds);
    else if (m_grading.recording() != nullptr && !m_replay && !m_opened.isShown()) {
        if (!play(*m_grading.recording(), seconds))
            return;
        m_playedFrom = PlayedFrom::ScoreCard;
        if (m_history)
            m_history->followReplay(*m_grading.record());
    }
}

/// Plays the attempt whose score is open, and returns there afterwards.
void PlaybackController::playOpened(std::optional<double> momentS)
{
    if (!play(*m_opened.recording(), momentS, m_history->whoseIsTalkedAbout()))
        return;
    m_playedFrom = PlayedFrom::ScoreCard;
    m_history->followReplay(m_history->talkedAbout());
}

void PlaybackController::endReplay()
{
    m_playedFrom = PlayedFrom::Elsewhere;
    if (m_history)
        m_history->followReplay({});
    m_replay.reset();
    m_context.attempt.setResting(false);
}

/// Returns to the student's own work as it was left. A student without one gets the whole tooth of the recording.
void PlaybackController::stopReplay()
{
    if (!m_replay)
        return;
    const PlayedFrom from = m_playedFrom;
    const auto goBack = [this, from] {
        if (from == PlayedFrom::ScoreCard && (m_opened.recording() != nullptr || m_grading.recording() != nullptr))
            m_context.window.navigation().openScore();
        else if (from == PlayedFrom::Attempts)
            m_context.window.navigation().goBackToHistory();
        else
            return false;
        return true;
    };
    if (!m_context.attempt.hasTooth()) {
        if (const auto practice = lessons::practiceOn(m_replayed)) {
            m_attempts.begin(*practice, {}, false);
            m_context.window.showMessage(tr("The tooth is intact. You can start drilling."));
        }
        static_cast<void>(goBack());
        return;
    }
    endReplay();
    m_context.window.setReplaying(false);
    m_context.window.setHandpieces(m_context.attempt.settings().handpieces);
    showOwn();
    m_context.window.showTooth(m_context.attempt.assignment().anatomy, m_context.attempt.generation(), {});
    m_context.window.view().restoreCamera();
    // A tooth that was taken a moment before the replay may still be on its way to the session.
    if (const auto own = m_context.session.toothSoFar(); own && own->anatomy == m_context.attempt.assignment().anatomy)
        m_context.window.view().setHeights(own->top);
    if (!goBack())
        m_context.window.showMessage(tr("You are back in your own work."));
}

}  // namespace app
