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

/// The assessment of the current attempt at some tick.
struct Findings
{
    std::uint64_t generation = 0;  ///< of the tooth; 0: no tooth yet
    std::uint64_t ticks = 0;
    grading::Process process;
    std::vector<grading::Infraction> infractions;
    std::uint8_t aids = 0;                        ///< bits of servo::Aid that were in use at any time
    std::optional<grading::Practised> practised;  ///< empty unless the lesson is an exercise
};

/// An attempt at one tick: its recording, its tooth and its assessment, which belong together.
struct AttemptSnapshot
{
    recording::Recording recording;
    terrain::Tooth tooth;
    Findings findings;
};

/// Assesses the current attempt by replaying it a little behind the servo, 20 times a second. So the servo has no extra
/// work, and live results are those of every later replay. Costs about a hundredth of a core.
class LiveAssessmentLoop final : public rt::Loop
{
public:
    static constexpr std::chrono::milliseconds kPeriod{50};

    /// @param session  must outlive the loop
    explicit LiveAssessmentLoop(const SessionLoop& session) : m_session(session) {}

    void tick(std::chrono::microseconds dt) override;

    /// Sets the examination for the tooth of this generation, before or after that tooth begins. An attempt that has
    /// begun is assessed again from its start. Any thread.
    void watch(std::uint64_t generation, Examination examination);
    /// Returns the current assessment. Any thread.
    [[nodiscard]] Findings findings() const;
    /// Returns the attempt up to now, exact to the tick. Waits some milliseconds until the rest is replayed. Empty
    /// before the first tooth. Any thread.
    [[nodiscard]] std::optional<AttemptSnapshot> conclude();

private:
    void startOver(const recording::Recording& recording, std::uint64_t generation);
    void take(const std::vector<servo::ServoEvent>& events);
    [[nodiscard]] bool play(const servo::ServoEvent& event);
    [[nodiscard]] Findings found() const;

    const SessionLoop& m_session;
    mutable std::mutex m_mutex;  ///< guards all members below
    std::uint64_t m_watchedGeneration = 0;
    Examination m_examination;
    std::uint64_t m_generation = 0;  ///< of the replayed tooth; 0: none
    std::uint64_t m_events = 0;      ///< number of events replayed
    std::optional<recording::Replayer> m_replayer;
    std::optional<LiveAssessor> m_examiner;
};

}  // namespace core::session
