// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/replay/ReplayController.h"
#include "core/session/SessionChannels.h"

#include <algorithm>
#include <utility>

#include "ui/tooth/ToothView.h"

namespace app {
namespace {

using namespace std::chrono_literals;
using ui::window::MainWindow;

constexpr std::chrono::microseconds kPlayingPeriod = 10ms;
constexpr std::chrono::microseconds kPreparingPeriod = 5ms;
constexpr std::chrono::microseconds kLeadingPeriod = 1ms;
constexpr int kWatchMs = 100;

}  // namespace

core::Result<std::unique_ptr<ReplayController>> ReplayController::make(const core::recording::Recording& recording,
                                                                       core::session::UiChannels& links,
                                                                       MainWindow& window, std::uint64_t generation,
                                                                       haptics::HapticDevice* device)
{
    auto attempt = ReplayTrack::make(recording, links, generation);
    if (!attempt)
        return tl::unexpected(attempt.error());
    return std::unique_ptr<ReplayController>(new ReplayController(std::move(*attempt), window, device));
}

ReplayController::ReplayController(std::unique_ptr<ReplayTrack> attempt, MainWindow& window,
                                   haptics::HapticDevice* device)
    : m_window(window), m_loop(std::move(attempt)), m_device(device)
{
    using ui::window::ReplayView;
    ReplayView* const view = &m_window.replayView();
    connect(view, &ReplayView::pauseRequested, this, [this](bool paused) { m_loop.setPaused(paused); });
    connect(view, &ReplayView::speedChosen, this, [this](double times) { m_loop.setSpeed(times); });
    connect(view, &ReplayView::seekRequested, this, [this](double seconds) { m_loop.seek(seconds); });
    connect(view, &ReplayView::leadRequested, this, &ReplayController::lead);
    connect(view, &ReplayView::besideCloseRequested, this, &ReplayController::closeBeside);
    m_watch.setInterval(kWatchMs);
    connect(&m_watch, &QTimer::timeout, this, &ReplayController::watch);
}

ReplayController::~ReplayController()
{
    stopThreads();
    m_window.replayView().hideBeside();
}

void ReplayController::start()
{
    startThreads();
    m_watch.start();
    watch();
}

void ReplayController::startThreads()
{
    m_preparing = std::make_unique<LoopThread>(m_loop.preparing(), kPreparingPeriod, LoopThread::Urgency::Normal);
    m_playing = std::make_unique<LoopThread>(m_loop, kPlayingPeriod, LoopThread::Urgency::Normal);
    m_preparing->start(QThread::LowPriority);
    m_playing->start();
    if (m_guide) {
        m_leading = std::make_unique<LoopThread>(*m_guide, kLeadingPeriod, LoopThread::Urgency::RealTime);
        m_leading->start(QThread::TimeCriticalPriority);
    }
}

void ReplayController::stopThreads()
{
    m_leading.reset();
    m_playing.reset();
    m_preparing.reset();
}

void ReplayController::playTo(double momentS)
{
    m_momentS = std::min(momentS, attempt().lengthS());
    m_loop.seek(std::max(0.0, *m_momentS - ui::replay::kBeforeMomentS));
}

/// Turns the view to where the bur was at the moment, once the replay is prepared up to there.
void ReplayController::lookAtMoment()
{
    if (!m_momentS || attempt().readyS() < *m_momentS)
        return;
    m_window.view().lookAt(attempt().sightAt(*m_momentS), attempt().burAtMm(*m_momentS));
    m_momentS.reset();
}

core::Status ReplayController::putBeside(const core::recording::Recording& recording, const QString& name)
{
    constexpr std::uint64_t kGeneration = 1;
    auto links = std::make_unique<core::session::UiChannels>();
    auto track = ReplayTrack::make(recording, *links, kGeneration);
    if (!track)
        return tl::unexpected(track.error());
    closeBeside();
    stopThreads();
    m_besideLinks = std::move(links);
    m_window.showBeside(*m_besideLinks, recording.anatomy(), kGeneration, (*track)->ideal(), name);
    m_loop.putBeside(std::move(*track));
    m_toldBesideS = -1.0;
    startThreads();
    return {};
}

void ReplayController::closeBeside()
{
    if (!m_besideLinks)
        return;
    stopThreads();
    m_loop.putBeside(nullptr);
    m_window.replayView().hideBeside();
    m_besideLinks.reset();
    startThreads();
}

/// The device is read from the first wish on; without a lead it is free.
void ReplayController::lead(bool wanted)
{
    if (m_device == nullptr)
        return;
    m_guideLinks.wanted.store(wanted, std::memory_order_relaxed);
    m_toldHand = ReplayLoop::Hand::Free;
    if (!wanted || m_guide)
        return;
    stopThreads();
    m_guide = std::make_unique<haptics::GuideLoop>(*m_device, m_guideLinks);
    m_loop.setGuide(&m_guideLinks);
    startThreads();
}

void ReplayController::watch()
{
    // The course of what is known so far, again while more of it becomes known.
    if (const double readyS = attempt().readyS(); readyS != m_toldReadyS) {
        m_toldReadyS = readyS;
        m_window.replayView().setCourse(attempt().course());
    }
    lookAtMoment();
    if (const ReplayTrack* beside = m_loop.beside(); beside != nullptr && beside->readyS() != m_toldBesideS) {
        m_toldBesideS = beside->readyS();
        m_window.replayView().setBesideCourse(beside->course());
    }
    if (m_loop.takeEnd())
        m_window.replayView().showEnd();
    if (m_guide)
        watchHand();
}

/// A lead that the hand or the device has ended is wanted no longer.
void ReplayController::watchHand()
{
    const ReplayLoop::Hand hand = m_loop.hand();
    if (hand == std::exchange(m_toldHand, hand) || !m_guideLinks.wanted.load(std::memory_order_relaxed))
        return;
    if (hand != ReplayLoop::Hand::Pushed && hand != ReplayLoop::Hand::Lost)
        return;
    m_guideLinks.wanted.store(false, std::memory_order_relaxed);
    m_window.replayView().showLeadEnd(hand == ReplayLoop::Hand::Pushed);
}

}  // namespace app
