// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "core/audio/ServoSound.h"
#include "core/history/RemovedTally.h"
#include "core/recording/Player.h"
#include "core/servo/ServoState.h"
#include "core/session/LiveAssessor.h"
#include "core/session/SessionChannels.h"
#include "core/session/Sight.h"
#include "lessons/Lesson.h"
#include "ui/replay/AttemptTimeline.h"

namespace app {

/// One attempt that is shown in one view, at any moment of it. For the view it stands in for the servo and the session
/// loop: like them it writes states, patches and sound to channels.
class ReplayTrack
{
public:
    /// @param links       must outlive the track
    /// @param generation  what the view has been told the tooth's number is
    [[nodiscard]] static core::Result<std::unique_ptr<ReplayTrack>>
    make(const core::recording::Recording& recording, core::session::UiChannels& links, std::uint64_t generation);

    [[nodiscard]] double lengthS() const { return m_lengthS; }
    /// What the lesson asks for that the attempt was made for; null: nothing.
    [[nodiscard]] const core::grading::IdealTop& ideal() const { return m_ideal; }
    /// That lesson; nothing: it was practised freely, or the lesson cannot be read.
    [[nodiscard]] const std::optional<lessons::Lesson>& lesson() const { return m_lesson; }

    /// Works out so many ticks more; false when all are. One thread, the same or with its own order.
    bool prepare(std::uint64_t ticks);
    /// Up to here it can be shown. Any thread.
    [[nodiscard]] double readyS() const;
    /// Any thread.
    [[nodiscard]] ui::replay::AttemptTimeline course() const;

    /// Returns from where the student looked at a moment. Empty if the recording has no note of it. Any thread.
    [[nodiscard]] std::optional<core::session::Sight> sightAt(double seconds) const;
    /// Returns where the tip of the bur was at a moment, tooth frame, mm. Any thread.
    [[nodiscard]] glm::dvec3 burAtMm(double seconds) const;

    /// Shows the student's hand in place of the recorded one; nothing: the recorded. The thread that shows.
    void setHand(const std::optional<glm::dvec3>& tipMm) { m_hand = tipMm; }
    /// The tip of the bur as it was shown last, tooth frame. The thread that shows.
    [[nodiscard]] const glm::dvec3& tipMm() const { return m_tipMm; }

    /// Shows a moment: what the view has not room for yet goes with the next call. What is not worked out yet is shown
    /// as far as it is. One thread.
    void show(double seconds);

private:
    ReplayTrack(std::unique_ptr<core::recording::Player> player, const core::session::Examination& examination,
                core::session::UiChannels& links, std::uint64_t generation);
    void takeRest(const core::recording::MarkedEvent& marked, ui::replay::AttemptTimeline& course) const;
    [[nodiscard]] std::string nameOf(ui::replay::Mark::Kind kind, std::uint64_t value) const;
    [[nodiscard]] std::uint64_t shownTick(double seconds, std::uint64_t ready) const;
    void sendPatches(std::uint64_t tick, bool isSettled);
    void publish(std::uint64_t tick);
    void publishSound(const core::servo::ServoState& state, std::uint64_t tick);

    std::unique_ptr<core::recording::Player> m_player;
    double m_lengthS;
    core::grading::IdealTop m_ideal;
    std::optional<lessons::Lesson> m_lesson;

    // Of the thread that prepares.
    core::session::LiveAssessor m_examiner;
    std::size_t m_found = 0;
    mutable std::mutex m_mutex;  ///< guards m_infractions and m_points
    std::vector<core::grading::Infraction> m_infractions;
    std::vector<ui::replay::TouchPoint> m_points;

    // Of the thread that shows.
    core::session::UiChannels& m_links;
    std::uint64_t m_generation;
    core::history::TiledHeights m_shown;  ///< what the view has been sent
    std::uint64_t m_shownTick = 0;
    std::optional<glm::dvec3> m_hand;
    glm::dvec3 m_tipMm{0.0};
    bool m_isSettled = false;  ///< nothing that happened at m_shownTick can be missing
    core::history::RemovedTally m_removed;
    std::deque<core::servo::TilePatch> m_toSend;
    core::session::SessionState m_session;
    core::audio::ServoSound m_sound;
    std::uint64_t m_heardTick = 0;
    int m_sameTick = 0;  ///< times in a row that m_heardTick was shown
};

}  // namespace app
