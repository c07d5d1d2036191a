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

/// A stroke of a recording, in ticks: the first that cut and the last.
struct StrokeSpan
{
    std::uint64_t from = 0;
    std::uint64_t to = 0;
    bool operator==(const StrokeSpan&) const = default;
};

/// What happened at a moment beside the motion of the hand: undo, another bur, an aid, a note, ...
struct MarkedEvent
{
    std::uint64_t tick = 0;  ///< it came after this one
    servo::ServoEvent event;
};

/// An attempt that can be looked at at any moment, forward and back, as fast as one likes.
///
/// One pass through the replay (advance()) keeps what is seen of it: the bur every 4 ms, the columns that were lowered
/// every 16 ms, and every 2 s the whole tooth, of which the key frames share what they have in common. To go to a
/// moment is to take the key frame before it and lower its columns up to there. What is shown was computed by the very
/// ticks that made it; between two of the times above it is as it was at the earlier one.
///
/// One thread advances it; any thread may ask meanwhile for what is behind. It takes some 30 MB for ten minutes of
/// cutting at grid 150.
class Player
{
public:
    static constexpr std::uint64_t kTicksAPose = 4;
    static constexpr std::uint64_t kTicksAPatch = 16;
    static constexpr std::uint64_t kTicksAKeyFrame = 2048;

    /// Only the settings can be wrong.
    [[nodiscard]] static Result<std::unique_ptr<Player>> make(Recording recording);

    /// Plays so many ticks more. False when the recording is at its end. One thread, the same or with its own order.
    /// @param afterEvent  called after every event, as by replay(); may be empty
    bool advance(std::uint64_t ticks,
                 const std::function<void(const servo::ServoEvent&, const Replayer&)>& afterEvent = {});

    [[nodiscard]] const Recording& recording() const { return m_recording; }
    /// Of the whole recording.
    [[nodiscard]] std::uint64_t ticks() const { return m_recording.ticks(); }
    /// Up to here it can be looked at.
    [[nodiscard]] std::uint64_t readyTicks() const;

    /// When a tick was over, since the beginning, and the last tick that was over then. Within what is ready.
    [[nodiscard]] double secondsAt(std::uint64_t tick) const;
    [[nodiscard]] std::uint64_t tickAt(double seconds) const;

    /// Bur, force, drill and removed volumes as they were; without trail, generation and missed periods. At tick 0, and
    /// beyond what is ready, the nearest there is.
    [[nodiscard]] servo::ServoState stateAt(std::uint64_t tick) const;
    /// The top map, row by row, mm.
    [[nodiscard]] std::vector<float> heightsAt(std::uint64_t tick) const;

    /// Strokes so far, in order.
    [[nodiscard]] std::vector<StrokeSpan> strokes() const;
    /// All events but the steps of the servo so far, in order.
    [[nodiscard]] std::vector<MarkedEvent> marks() const;
    /// Memory that looking back takes.
    [[nodiscard]] std::size_t bytes() const;

private:
    /// A ServoState, as small as it may be.
    struct Pose
    {
        glm::vec3 deviceMm;
        glm::vec3 anchorMm;
        glm::vec3 forceN;
        std::array<float, terrain::kMaterialCount> removedMm3;
        std::array<float, terrain::kMaterialCount> brokenMm3;
        float burRpm;
        float depthMm;
        double seconds;  ///< since the beginning
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
    /// The columns that were lowered since the patch before: m_columns and m_heights up to `end`.
    struct Patch
    {
        std::uint64_t tick = 0;
        std::size_t end = 0;
    };
    struct KeyFrame
    {
        std::uint64_t tick = 0;
        std::size_t patches = 0;  ///< those before it, which it includes
        history::TiledHeights top;
    };

    Player(Recording recording, Replayer servo);
    void play(const servo::ServoEvent& event);
    void keepPose(const servo::ServoState& state);
    void keepPatch();
    void keepKeyFrame();

    Recording m_recording;
    std::uint64_t m_nextEvent = 0;
    std::vector<servo::ServoEvent> m_events;  ///< at hand, from m_nextEvent on
    std::size_t m_nextAtHand = 0;

    // Of the thread that advances.
    Replayer m_servo;
    servo::StrokeDetector m_watch;
    std::vector<float> m_shown;  ///< the top map as of the newest patch
    cutting::CutRect m_changed;  ///< since then
    std::chrono::microseconds m_time{0};

    mutable std::mutex m_mutex;  ///< guards what follows
    std::uint64_t m_ready = 0;
    std::vector<Pose> m_poses;  ///< of tick 0, kTicksAPose, ...
    std::vector<Patch> m_patches;
    std::vector<std::uint32_t> m_columns;
    std::vector<float> m_heights;
    std::vector<KeyFrame> m_keyFrames;
    std::vector<StrokeSpan> m_strokes;
    std::vector<MarkedEvent> m_marks;
};

}  // namespace core::recording
