// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "core/recording/Replay.h"
#include "core/servo/ServoState.h"
#include "core/servo/StrokeDetector.h"

namespace core::recording {

/// A stroke of a recording: its first and its last tick that cut.
struct StrokeSpan
{
    std::uint64_t from = 0;
    std::uint64_t to = 0;
    bool operator==(const StrokeSpan&) const = default;
};

/// An event besides the motion of the hand: undo, another bur, an aid, a note, ...
struct MarkedEvent
{
    std::uint64_t tick = 0;  ///< the event follows this tick
    servo::ServoEvent event;
};

/// Gives access to any moment of an attempt, forwards and backwards, at any speed.
///
/// One pass through the replay (advance()) stores the bur every 4 ms, the lowered columns every 16 ms, and every 2 s
/// the whole tooth as a key frame; key frames share their unchanged tiles. A moment is built from the key frame before
/// it and the columns lowered since. All that is shown was computed by the same ticks that made the attempt; between
/// two stored times it is as at the earlier one.
///
/// One thread advances it; any thread may read what is ready meanwhile. It takes about 30 MB for ten minutes of cutting
/// at grid 150.
class Player
{
public:
    static constexpr std::uint64_t kTicksAPose = 4;
    static constexpr std::uint64_t kTicksAPatch = 16;
    static constexpr std::uint64_t kTicksAKeyFrame = 2048;

    /// Creates a player. The only possible error is invalid settings.
    [[nodiscard]] static Result<std::unique_ptr<Player>> make(Recording recording);

    /// Plays `ticks` more ticks. Returns false at the end of the recording. One thread at a time.
    /// @param afterEvent  called after every event, as in replay(); may be empty
    bool advance(std::uint64_t ticks,
                 const std::function<void(const servo::ServoEvent&, const Replayer&)>& afterEvent = {});

    [[nodiscard]] const Recording& recording() const { return m_recording; }
    /// Returns the number of ticks of the whole recording.
    [[nodiscard]] std::uint64_t ticks() const { return m_recording.ticks(); }
    /// Returns the number of ticks that are ready.
    [[nodiscard]] std::uint64_t readyTicks() const;

    /// Returns the time at which a tick ended, s from the start; tickAt() returns the last tick that ended by a time.
    /// Within the ready ticks.
    [[nodiscard]] double secondsAt(std::uint64_t tick) const;
    [[nodiscard]] std::uint64_t tickAt(double seconds) const;

    /// Returns bur, force, drill and removed volumes at a tick; without trail, generation and missed periods. At tick
    /// 0, and beyond what is ready, the nearest state.
    [[nodiscard]] servo::ServoState stateAt(std::uint64_t tick) const;
    /// Returns the top map at a tick, row by row, mm.
    [[nodiscard]] std::vector<float> heightsAt(std::uint64_t tick) const;

    /// Returns the strokes in the ready part, in order.
    [[nodiscard]] std::vector<StrokeSpan> strokes() const;
    /// Returns all events but the steps of the servo in the ready part, in order.
    [[nodiscard]] std::vector<MarkedEvent> marks() const;
    /// Returns the memory used for access to past moments.
    [[nodiscard]] std::size_t bytes() const;

private:
    /// A ServoState in less memory.
    struct Pose
    {
        glm::vec3 deviceMm;
        glm::vec3 anchorMm;
        glm::vec3 forceN;
        std::array<float, terrain::kMaterialCount> removedMm3;
        std::array<float, terrain::kMaterialCount> brokenMm3;
        float burRpm;
        float depthMm;
        double seconds;  ///< from the start
        std::uint32_t health;
        std::uint8_t burIndex;
        std::uint8_t handpieceIndex;
        terrain::Material material;
        bool touching;
        bool drillOn;
        bool cutting;
        bool handpieceOnCrown;
        bool hasDepth;
    };
    /// The columns lowered since the patch before: m_columns and m_heights up to `end`.
    struct Patch
    {
        std::uint64_t tick = 0;
        std::size_t end = 0;
    };
    struct KeyFrame
    {
        std::uint64_t tick = 0;
        std::size_t patches = 0;  ///< number of patches before it, which it includes
        history::TiledHeights top;
    };

    Player(Recording recording, Replayer servo);
    void play(const servo::ServoEvent& event);
    void keepPose(const servo::ServoState& state);
    void keepPatch();
    void keepKeyFrame();

    Recording m_recording;
    std::uint64_t m_nextEvent = 0;
    std::vector<servo::ServoEvent> m_events;  ///< unpacked, from m_nextEvent on
    std::size_t m_nextAtHand = 0;

    // Used by the thread that advances.
    Replayer m_servo;
    servo::StrokeDetector m_watch;
    std::vector<float> m_shown;  ///< the top map at the newest patch
    cutting::CutRect m_changed;  ///< since then
    std::chrono::microseconds m_time{0};

    mutable std::mutex m_mutex;  ///< guards the members below
    std::uint64_t m_ready = 0;
    std::vector<Pose> m_poses;  ///< at ticks 0, kTicksAPose, ...
    std::vector<Patch> m_patches;
    std::vector<std::uint32_t> m_columns;
    std::vector<float> m_heights;
    std::vector<KeyFrame> m_keyFrames;
    std::vector<StrokeSpan> m_strokes;
    std::vector<MarkedEvent> m_marks;
};

}  // namespace core::recording
