// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <vector>

#include "core/audio/ServoSound.h"
#include "core/guidance/Fixture.h"
#include "core/rt/Loop.h"
#include "core/rt/TripleBuffer.h"
#include "core/servo/ServoChannels.h"
#include "core/servo/ServoState.h"
#include "core/servo/ServoTick.h"
#include "core/servo/StrokeDetector.h"
#include "haptics/HapticDevice.h"

namespace haptics {

/// The 1 kHz loop: reads the device, computes with ServoTick, applies the force, and publishes the state. Only this
/// loop accesses the live tooth. tick() never allocates, locks, throws, logs or waits.
class ServoLoop final : public core::rt::Loop
{
public:
    /// Longest step that is computed, unless the period is longer. After a pause of the thread, the bur does not cut
    /// for the missed time.
    static constexpr std::chrono::microseconds kLongestStep{4000};

    /// @param device, links, state  must outlive the loop
    /// @param period  of the loop, at most 50 ms; longer ticks count as missed periods
    ServoLoop(HapticDevice& device, std::unique_ptr<core::servo::ServoTick> tick, core::servo::ServoChannels& links,
              core::rt::TripleBuffer<core::servo::ServoState>& state, std::chrono::microseconds period);
    ~ServoLoop() override;

    /// Publishes the sound of the bur in every tick. Call before the first tick.
    /// @param sound  must outlive the loop
    void publishSound(core::rt::TripleBuffer<core::audio::SoundState>& sound) noexcept { m_soundOut = &sound; }

    /// Lets the loop rest, or continues it. While it rests, it executes commands, but does not read the device, move
    /// the bur or publish. Any thread.
    void setResting(bool rests) noexcept { m_restWanted.store(rests, std::memory_order_release); }
    /// Returns whether the loop rests, so that others may use the device and the channels it writes. Follows
    /// setResting() in the next tick. Any thread.
    [[nodiscard]] bool isResting() const noexcept { return m_rests.load(std::memory_order_acquire); }

    void tick(std::chrono::microseconds dt) noexcept override;
    bool waitForBeat(std::chrono::steady_clock::time_point due) override { return m_device.waitForReading(due); }

    /// Return the state and the tooth after the last tick; for single-threaded use.
    [[nodiscard]] const core::servo::ServoState& state() const noexcept { return m_tick->state(); }
    [[nodiscard]] const core::contact::LiveTooth* tooth() const noexcept { return m_tick->tooth(); }

private:
    void apply(const core::servo::SwapTooth& swap) noexcept;
    void apply(const core::servo::SetBur& bur) noexcept;
    void apply(const core::servo::SetDrill& drill) noexcept;
    void apply(const core::servo::SetHandpiece& handpiece) noexcept;
    void apply(const core::servo::SetFixture& fixture) noexcept;
    void apply(const core::servo::BringHome& home) noexcept;
    void apply(const core::servo::SetParameter& number) noexcept;
    void followPedal(const std::optional<bool>& pedal) noexcept;
    void turnBur(bool on) noexcept;
    void guide(double seconds) noexcept;
    void watchDelay(float delayS, double seconds) noexcept;
    void forgetDelay() noexcept;
    void setSpring(std::uint64_t percent) noexcept;
    void setSpeed(std::uint64_t percent) noexcept;
    void record(const core::servo::ServoEvent& event) noexcept;
    void markDirty(const core::cutting::CutRect& rect) noexcept;
    void sendPatches() noexcept;
    void carryOutCommands() noexcept;
    [[nodiscard]] bool rest() noexcept;

    HapticDevice& m_device;
    std::unique_ptr<core::servo::ServoTick> m_tick;
    core::servo::ServoChannels& m_links;
    core::rt::TripleBuffer<core::servo::ServoState>& m_stateOut;
    std::chrono::microseconds m_period;
    core::rt::TripleBuffer<core::audio::SoundState>* m_soundOut = nullptr;  ///< null: not published
    core::audio::ServoSound m_sound;

    std::uint64_t m_generation = 0;
    std::uint64_t m_serial = 0;
    std::uint64_t m_missedPeriods = 0;
    std::array<core::servo::Pose, 16> m_trail{};
    std::size_t m_nextPose = 0;
    std::uint32_t m_health = 0;
    std::array<float, 4> m_lateS{};  ///< the last delays that the device reported
    std::size_t m_nextLate = 0;
    float m_delayS = 0.0F;  ///< longest of the recent delays
    std::uint64_t m_springPercent = 100;
    std::uint64_t m_speedPercent = 100;
    bool m_drillIsOn = false;  ///< switched on by SetDrill
    bool m_pedalIsUp = false;
    std::unique_ptr<const core::guidance::Fixture> m_fixture;  ///< null: the hand is free
    double m_fixtureShare = 0.0;                               ///< share of its force; rises gradually to 1
    glm::dvec3 m_guideN{0.0};                                  ///< force of the guidance in the last tick

    std::atomic<bool> m_restWanted{false};
    std::atomic<bool> m_rests{false};

    std::vector<std::uint8_t> m_isDirty;  ///< one entry per tile
    std::vector<std::uint16_t> m_dirty;   ///< tiles to send, at most one entry per tile
    int m_tilesPerSide = 0;
    int m_ticksSinceSent = 0;
    core::servo::StrokeDetector m_stroke;
    bool m_strokeEnded = false;
    core::servo::TilePatch m_patch;
};

}  // namespace haptics
