// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "core/history/MomentId.h"
#include "core/rt/Loop.h"
#include "core/servo/ServoChannels.h"
#include "core/servo/ServoState.h"
#include "core/session/ResumableAttempt.h"
#include "core/session/SessionChannels.h"

namespace core::session {

/// What a session stores of an attempt. Both grow with the attempt, so a headless run stores only what it needs.
struct SessionMemory
{
    bool recording = true;
    std::size_t undoBytes = history::UndoTree::kDefaultLimitBytes;
};

/// The part of an attempt that a journal has not written yet.
struct RecordedPart
{
    std::uint64_t generation = 0;           ///< of the recorded tooth; 0: no tooth yet
    bool isWorthKeeping = false;            ///< material has been removed
    std::vector<servo::ServoEvent> events;  ///< the next events available; empty if another generation was requested
};

/// The partner of the servo that may wait and allocate (about 100 Hz): maintains a mirror of the tooth, the undo
/// history and the recording, builds restored teeth for the servo, and forwards cut tiles to the view.
class SessionLoop final : public rt::Loop
{
public:
    /// @param servo, ui  must outlive the loop
    /// @param settings   of the servo, until a command changes them
    SessionLoop(servo::ServoChannels& servo, UiChannels& ui, servo::ServoSettings settings,
                const SessionMemory& memory = {});
    ~SessionLoop() override;

    void tick(std::chrono::microseconds dt) override;
    void end() override;

    /// Returns the attempt so far, with the tooth at the mirror's tick as witness. Empty before the first tooth, and if
    /// nothing is recorded. Any thread.
    [[nodiscard]] std::optional<recording::Recording> recordingSoFar() const;
    /// Returns the generation of the recorded tooth; 0 if there is none. Any thread; constant time.
    [[nodiscard]] std::uint64_t recordedGeneration() const;
    /// Returns the recorded events of a tooth from event number `first` on. Any thread.
    [[nodiscard]] RecordedPart recordedSince(std::uint64_t generation, std::uint64_t first) const;
    /// Returns the top map that one of the last undo steps restored, by the tick after which the tooth had it. Empty if
    /// it is not stored any more. Any thread.
    [[nodiscard]] std::optional<history::TiledHeights> restored(std::uint64_t tick) const;
    /// Returns the mirror of the tooth. Empty before the first tooth. Any thread.
    [[nodiscard]] std::optional<terrain::Tooth> toothSoFar() const;

    /// Returns the moments of the history, oldest first. Empty before the first tooth. Any thread. Cheap, but only
    /// needed when SessionState::historyVersion has changed.
    [[nodiscard]] std::vector<history::MomentInfo> historySoFar() const;
    /// Returns the top map at a moment, row by row, mm, for a small picture. Empty if the moment is not stored any
    /// more. Any thread.
    [[nodiscard]] std::vector<float> momentHeights(history::MomentId id) const;

private:
    struct Upcoming
    {
        std::uint64_t generation = 0;
        recording::Recording recording;  ///< what it contains already
    };

    void freeRetired();
    void takeEvents();
    void takePatches();
    void applyGroup();
    void takeCommands();
    void apply(const Undo&);
    void apply(const Redo&);
    void apply(const Reload&);
    void apply(ReplaceTooth&& replace);
    void apply(ResumeAttempt&& resume);
    void apply(const SetAids& aids);
    void apply(const AddNote& note);
    void note(const servo::ServoEvent& event);
    void keep(const servo::ServoEvent& event);
    void take(ResumableAttempt attempt, std::uint64_t generation, bool resumed,
              std::unique_ptr<servo::ServoTick> servo);
    void apply(const servo::SetBur& bur);
    void apply(const servo::SetDrill& drill);
    void apply(const servo::SetHandpiece& handpiece);
    void apply(SetFixture&& held);
    void apply(const servo::BringHome& home);
    void apply(const servo::SetParameter& number);
    void apply(const GoTo& where);
    void step(const std::function<bool()>& go);
    void rememberUnfinished();
    void handOver();
    void forward();
    void publish();

    servo::ServoChannels& m_servo;
    UiChannels& m_ui;
    servo::ServoSettings m_settings;
    bool m_records;
    std::size_t m_undoBytes;

    mutable std::mutex m_mutex;  ///< guards members that other threads read; the servo never locks it
    std::optional<recording::Recording> m_recording;
    std::shared_ptr<const terrain::ToothAnatomy> m_anatomy;
    std::deque<std::pair<std::uint64_t, history::TiledHeights>> m_restored;  ///< the last maps that were given to the
                                                                             ///< servo
    std::uint64_t m_recordedGeneration = 0;                                  ///< the tooth of m_recording
    history::TiledHeights m_uncut;
    history::TiledHeights m_mirror;
    std::uint64_t m_mirrorTick = 0;
    history::TiledHeights m_vouched;  ///< the tooth after the newest group of patches; undo does not change it
    std::optional<std::uint64_t> m_vouchedTick;  ///< empty: no patches since the attempt was resumed
    history::UndoTree m_undo;

    std::deque<Upcoming> m_upcoming;         ///< given to the servo, not begun there yet
    std::vector<servo::ServoEvent> m_noted;  ///< for an attempt that has not begun there yet
    std::uint64_t m_historyVersion = 0;
    std::chrono::microseconds m_attemptTime{0};
    bool m_unfinished = false;  ///< the mirror differs from m_undo.current()
    bool m_hasCut = false;      ///< material has been removed from this tooth, even if it was restored
    int m_strokes = 0;
    std::uint64_t m_serial = 0;
    std::uint64_t m_generation = 0;
    terrain::PerMaterial m_wholeMm3{};
    history::RemovedTally m_removed;
    std::vector<servo::TilePatch> m_group;  ///< of the incomplete group
    std::deque<servo::TilePatch> m_toUi;
};

}  // namespace core::session
