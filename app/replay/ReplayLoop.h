// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>

#include "app/replay/ReplayTrack.h"
#include "core/rt/Loop.h"
#include "haptics/GuideLoop.h"

namespace app {

/// Plays an attempt into the view at any speed, forward, and goes to any moment of it; and another one beside it, at
/// the same share of its time, so that both begin and end together.
class ReplayLoop final : public core::rt::Loop
{
public:
    /// Begins at the beginning, as fast as the attempt was made.
    explicit ReplayLoop(std::unique_ptr<ReplayTrack> attempt) : m_attempt(std::move(attempt)) {}

    /// Shows another attempt beside; null: none. While nobody beats the loop.
    void putBeside(std::unique_ptr<ReplayTrack> attempt) { m_beside = std::move(attempt); }

    /// Leads a hand along what is shown: along the attempt beside where there is one. While nobody beats the loop.
    void setGuide(haptics::GuideLinks* guide) { m_guide = guide; }

    void tick(std::chrono::microseconds dt) override;
    /// Works the attempts out ahead of what is shown; for another thread, at its own beat.
    [[nodiscard]] core::rt::Loop& preparing() { return m_preparing; }
    /// All of it at once, and the end of it is shown. While nobody beats the loops.
    void goToEnd();

    [[nodiscard]] const ReplayTrack& attempt() const { return *m_attempt; }
    [[nodiscard]] const ReplayTrack* beside() const { return m_beside.get(); }

    // Any thread.

    /// Goes to a moment of the attempt.
    void seek(double seconds) { m_wishedS.store(seconds, std::memory_order_relaxed); }
    /// Plays so many times as fast as it was made.
    void setSpeed(double times) { m_speed.store(times, std::memory_order_relaxed); }
    /// Holds it where it is, or lets it go on; from its end, begins anew.
    void setPaused(bool paused);
    /// What the guide has said of the hand last.
    enum class Hand : std::uint8_t { Free, Led, Pushed, Lost };
    [[nodiscard]] Hand hand() const { return m_hand.load(std::memory_order_relaxed); }
    /// True once each time that playing has come to the end.
    [[nodiscard]] bool takeEnd() { return m_ended.exchange(false, std::memory_order_acq_rel); }

private:
    class Preparing final : public core::rt::Loop
    {
    public:
        explicit Preparing(ReplayLoop& replay) : m_replay(replay) {}
        void tick(std::chrono::microseconds) override { m_replay.prepare(); }

    private:
        ReplayLoop& m_replay;
    };

    void prepare();
    void lead();

    std::unique_ptr<ReplayTrack> m_attempt;
    std::unique_ptr<ReplayTrack> m_beside;
    Preparing m_preparing{*this};
    haptics::GuideLinks* m_guide = nullptr;
    std::uint64_t m_aims = 0;
    double m_atS = 0.0;
    std::atomic<double> m_wishedS{-1.0};  ///< negative: nothing
    std::atomic<double> m_speed{1.0};
    std::atomic<bool> m_paused{false};
    std::atomic<bool> m_isAtEnd{false};
    std::atomic<bool> m_ended{false};
    std::atomic<Hand> m_hand{Hand::Free};
};

}  // namespace app
