// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <vector>

#include "core/grading/Exercise.h"
#include "core/grading/Process.h"
#include "core/grading/RuleChecker.h"
#include "core/recording/IdleIntervals.h"
#include "core/recording/Replay.h"

namespace core::session {

/// Force limit above which time is counted if a lesson sets none, N: the highest force that six prosthodontists and six
/// students used on crowns was 4.9, their means below 1.8 (docs/facts/haptics.md, section 8.5).
inline constexpr double kUsualForceLimitN = 3.0;

/// The criteria of an assessment.
struct Examination
{
    grading::Rules rules;
    grading::IdealTop ideal;                    ///< the surface to be cut; may be null
    std::optional<grading::Exercise> exercise;  ///< the exercise to be practised; empty if something is to be cut
};

/// Assesses an attempt from its replay, live or later: the process and the infractions. Because it reads the replay and
/// not the servo, live results equal later ones. One thread; about 0.1 us per tick, more when material is removed.
class LiveAssessor
{
public:
    LiveAssessor(const Examination& examination, std::shared_ptr<const terrain::ToothAnatomy> anatomy);

    /// Processes an event of the recording, after the replay has played it.
    void take(const servo::ServoEvent& event, const recording::Replayer& replayed);

    /// Returns the bits of servo::Aid that were in use at any time.
    [[nodiscard]] std::uint8_t aids() const { return m_aids; }
    [[nodiscard]] grading::Process process() const { return m_meter->process(); }
    [[nodiscard]] const std::vector<grading::Infraction>& infractions() const { return m_infractions; }
    /// Returns the result of the exercise; empty if there is none.
    [[nodiscard]] std::optional<grading::Practised> practised() const;
    /// Returns the time on the recording, s, of a moment of the working time `atS`, which excludes rests.
    [[nodiscard]] double recordedS(double atS) const;

private:
    /// An interval of the recording that does not count as working time.
    struct Rest
    {
        std::chrono::microseconds after;  ///< working time before it
        std::chrono::microseconds length{0};
    };

    std::unique_ptr<grading::ProcessMeter> m_meter;
    grading::RuleChecker m_referee;
    std::optional<grading::ExerciseMeter> m_exercise;
    std::uint8_t m_aids = 0;
    recording::IdleIntervals m_rests;
    bool m_leftOut = false;  ///< the last step did not count as working time
    std::chrono::microseconds m_worked{0};
    std::vector<Rest> m_left;
    std::vector<grading::Infraction> m_infractions;
};

}  // namespace core::session
