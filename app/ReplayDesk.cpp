// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/ReplayDesk.h"

namespace app {
namespace {

using namespace std::chrono_literals;
using ui::shell::MainWindow;

constexpr std::chrono::microseconds kPlayingPeriod = 10ms;
constexpr std::chrono::microseconds kPreparingPeriod = 5ms;
constexpr int kWatchMs = 100;

}  // namespace

core::Result<std::unique_ptr<ReplayDesk>> ReplayDesk::make(const core::recording::Recording& recording,
                                                           core::session::UiLinks& links, MainWindow& window,
                                                           std::uint64_t generation)
{
    auto attempt = ReplayTrack::make(recording, links, generation);
    if (!attempt)
        return tl::unexpected(attempt.error());
    return std::unique_ptr<ReplayDesk>(new ReplayDesk(std::move(*attempt), window));
}

ReplayDesk::ReplayDesk(std::unique_ptr<ReplayTrack> attempt, MainWindow& window)
    : m_window(window), m_loop(std::move(attempt))
{
    connect(&m_window, &MainWindow::replayPauseRequested, this, [this](bool paused) { m_loop.setPaused(paused); });
    connect(&m_window, &MainWindow::replaySpeedChosen, this, [this](double times) { m_loop.setSpeed(times); });
    connect(&m_window, &MainWindow::seekWanted, this, [this](double seconds) { m_loop.seek(seconds); });
    m_watch.setInterval(kWatchMs);
    connect(&m_watch, &QTimer::timeout, this, &ReplayDesk::watch);
}

ReplayDesk::~ReplayDesk() = default;

void ReplayDesk::start()
{
    m_preparing = std::make_unique<LoopThread>(m_loop.preparing(), kPreparingPeriod, LoopThread::Urgency::Normal);
    m_playing = std::make_unique<LoopThread>(m_loop, kPlayingPeriod, LoopThread::Urgency::Normal);
    m_preparing->start(QThread::LowPriority);
    m_playing->start();
    m_watch.start();
    watch();
}

void ReplayDesk::holdAt(double seconds)
{
    m_loop.seek(seconds);
    m_loop.setPaused(true);
    m_window.showReplayPaused(true);
}

void ReplayDesk::watch()
{
    // The course of what is known so far, again while more of it becomes known.
    if (const double readyS = attempt().readyS(); readyS != m_toldReadyS) {
        m_toldReadyS = readyS;
        m_window.setReplayCourse(attempt().course());
    }
    if (m_loop.takeEnd())
        m_window.showReplayEnd();
}

}  // namespace app
