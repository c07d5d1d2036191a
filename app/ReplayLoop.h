// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <deque>
#include <vector>

#include "core/history/RemovedTally.h"
#include "core/recording/Replay.h"
#include "core/rt/Loop.h"

namespace app {

/// Plays a recording into the view, at first at the speed at which it was made. It stands in for the servo and the
/// session loop, which must rest meanwhile: like them it writes states and patches, and only those.
class ReplayLoop final : public core::rt::Loop
{
public:
    /// @param links  must outlive the loop
    /// @param generation  what the view has been told the tooth's number is
    [[nodiscard]] static core::Result<std::unique_ptr<ReplayLoop>>
    make(const core::recording::Recording& recording, core::session::UiLinks& links, std::uint64_t generation);

    void tick(std::chrono::microseconds dt) override;

    /// Any thread: plays so many times as fast as it was made.
    void setSpeed(int times) { m_speed.store(times, std::memory_order_relaxed); }
    /// Any thread: holds the recording where it is, or lets it go on.
    void setPaused(bool paused) { m_paused.store(paused, std::memory_order_relaxed); }
    /// Any thread: the last event has been played.
    [[nodiscard]] bool isFinished() const { return m_finished.load(std::memory_order_acquire); }

private:
    ReplayLoop(const core::recording::Recording& recording, core::session::UiLinks& links, std::uint64_t generation,
               core::recording::Replayer servo);

    void sendPatches();
    void publish();

    core::session::UiLinks& m_links;
    std::uint64_t m_generation;
    core::recording::Replayer m_servo;
    std::vector<core::session::ServoEvent> m_events;
    std::size_t m_next = 0;
    std::chrono::microseconds m_due{0};
    std::chrono::microseconds m_played{0};
    core::history::TiledHeights m_shown;  ///< what the view has been sent
    core::history::RemovedTally m_removed;
    std::deque<core::session::TilePatch> m_toSend;
    core::session::SessionState m_session;
    std::atomic<int> m_speed{1};
    std::atomic<bool> m_paused{false};
    std::atomic<bool> m_finished{false};
};

}  // namespace app
