// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "core/rt/Loop.h"
#include "core/session/LiveAssessor.h"
#include "core/session/SessionLoop.h"

namespace core::session {

/// How the present attempt goes, as of some tick of it.
struct Findings
{
    std::uint64_t generation = 0;  ///< of the tooth; 0: none yet
    std::uint64_t ticks = 0;
    grading::Process process;
    std::vector<grading::Infraction> infractions;
    std::uint8_t aids = 0;                        ///< bits of Aid: in use at any time
    std::optional<grading::Practised> practised;  ///< of an exercise; else nothing
};

/// An attempt at one tick, whole: what it is marked by, and what a replay of the recording comes to.
struct AttemptSnapshot
{
    recording::Recording recording;
    terrain::Tooth tooth;
    Findings findings;
};

/// Follows the attempt that goes on by replaying it a little behind the servo, 20 times a second, and examines what it
/// sees. So nothing is asked of the servo, and what is found live is what every later replay finds. Costs about a
/// hundredth of a core.
class LiveAssessmentLoop final : public rt::Loop
{
public:
    static constexpr std::chrono::milliseconds kPeriod{50};

    /// @param session  must outlive the loop
    explicit LiveAssessmentLoop(const SessionLoop& session) : m_session(session) {}

    void tick(std::chrono::microseconds dt) override;

    /// What is to be watched in the attempt at the tooth of this generation. Before or after that tooth is begun; an
    /// attempt that goes on is looked at anew. Any thread.
    void watch(std::uint64_t generation, Examination examination);
    /// Any thread.
    [[nodiscard]] Findings findings() const;
    /// The attempt up to now, to the tick: recording, tooth and findings that go together. Waits for what is still to
    /// be replayed, some milliseconds. Any thread; nothing before the first tooth.
    [[nodiscard]] std::optional<AttemptSnapshot> conclude();

private:
    void startOver(const recording::Recording& recording, std::uint64_t generation);
    void take(const std::vector<servo::ServoEvent>& events);
    [[nodiscard]] bool play(const servo::ServoEvent& event);
    [[nodiscard]] Findings found() const;

    const SessionLoop& m_session;
    mutable std::mutex m_mutex;  ///< guards all below
    std::uint64_t m_watchedGeneration = 0;
    Examination m_examination;
    std::uint64_t m_generation = 0;  ///< of what is followed; 0: nothing
    std::uint64_t m_events = 0;      ///< that have been played
    std::optional<recording::Replayer> m_replayer;
    std::optional<LiveAssessor> m_examiner;
};

}  // namespace core::session
