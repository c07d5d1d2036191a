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

/// What a session remembers of an attempt. It grows with the attempt, so a headless run keeps only what it asks for.
struct SessionMemory
{
    bool recording = true;
    std::size_t undoBytes = history::UndoTree::kDefaultLimitBytes;
};

/// What of an attempt a journal is still to write.
struct RecordedPart
{
    std::uint64_t generation = 0;           ///< of the tooth that is being recorded; 0: none yet
    bool isWorthKeeping = false;            ///< something has come off it
    std::vector<servo::ServoEvent> events;  ///< the next that are at hand; empty where another generation was asked for
};

/// The servo's patient partner (about 100 Hz): keeps a mirror of the tooth, the undo history and the recording, builds
/// restored teeth and hands them over, passes cut tiles on to the view. It may wait and allocate; the servo never does.
class SessionLoop final : public rt::Loop
{
public:
    /// @param servo, ui  must outlive the loop
    /// @param settings   of the servo, until a command brings another
    SessionLoop(servo::ServoChannels& servo, UiChannels& ui, servo::ServoSettings settings,
                const SessionMemory& memory = {});
    ~SessionLoop() override;

    void tick(std::chrono::microseconds dt) override;
    void end() override;

    /// The attempt so far, with what the tooth was at the mirror's tick. Any thread; empty before the first tooth, and
    /// where no recording is kept.
    [[nodiscard]] std::optional<recording::Recording> recordingSoFar() const;
    /// Which tooth's attempt is being recorded; 0 where none is. Any thread; constant time.
    [[nodiscard]] std::uint64_t recordedGeneration() const;
    /// What has been recorded of a tooth from event number `first` on. Any thread.
    [[nodiscard]] RecordedPart recordedSince(std::uint64_t generation, std::uint64_t first) const;
    /// The top map that was put back by one of the last steps through the history, by the tick after which the tooth
    /// had stood so. Any thread.
    [[nodiscard]] std::optional<history::TiledHeights> restored(std::uint64_t tick) const;
    /// The tooth as the mirror has it. Any thread; empty before the first tooth.
    [[nodiscard]] std::optional<terrain::Tooth> toothSoFar() const;

    /// The moments that can be gone back to, oldest first. Any thread; empty before the first tooth. Cheap, but ask
    /// only when SessionState::historyVersion is another than before.
    [[nodiscard]] std::vector<history::MomentInfo> historySoFar() const;
    /// The top map at a moment, row by row, mm, for a small picture of it. Any thread; empty if it is not known any
    /// more.
    [[nodiscard]] std::vector<float> momentHeights(history::MomentId id) const;

private:
    struct Upcoming
    {
        std::uint64_t generation = 0;
        recording::Recording recording;  ///< what is on it already
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

    mutable std::mutex m_mutex;  ///< guards what other threads ask for; the servo never comes here
    std::optional<recording::Recording> m_recording;
    std::shared_ptr<const terrain::ToothAnatomy> m_anatomy;
    std::deque<std::pair<std::uint64_t, history::TiledHeights>> m_restored;  ///< what was handed over of late
    std::uint64_t m_recordedGeneration = 0;                                  ///< the tooth that m_recording is about
    history::TiledHeights m_uncut;
    history::TiledHeights m_mirror;
    std::uint64_t m_mirrorTick = 0;
    history::TiledHeights m_vouched;  ///< the newest group of patches made the tooth this; undo does not touch it
    std::optional<std::uint64_t> m_vouchedTick;  ///< nothing: since the attempt was resumed there was none
    history::UndoTree m_undo;

    std::deque<Upcoming> m_upcoming;         ///< handed to the servo, not yet begun there
    std::vector<servo::ServoEvent> m_noted;  ///< of an attempt that has not begun there
    std::uint64_t m_historyVersion = 0;
    std::chrono::microseconds m_attemptTime{0};
    bool m_unfinished = false;  ///< the mirror differs from m_undo.current()
    bool m_hasCut = false;      ///< something has come off this tooth, and be it put back
    int m_strokes = 0;
    std::uint64_t m_serial = 0;
    std::uint64_t m_generation = 0;
    terrain::PerMaterial m_wholeMm3{};
    history::RemovedTally m_removed;
    std::vector<servo::TilePatch> m_group;  ///< patches of a group that is not complete yet
    std::deque<servo::TilePatch> m_toUi;
};

}  // namespace core::session
