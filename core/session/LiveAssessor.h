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

/// Time over so much force is counted where a lesson sets no limit, N: the largest that six prosthodontists and six
/// students used on crowns was 4.9, their means below 1.8 (docs/facts/haptics.md, section 8.5).
inline constexpr double kUsualForceLimitN = 3.0;

/// What an examiner looks at.
struct Examination
{
    grading::Rules rules;
    grading::IdealTop ideal;                    ///< what is to be cut; may be null
    std::optional<grading::Exercise> exercise;  ///< what is to be practised; nothing where something is to be cut
};

/// Looks at an attempt as it is replayed, live or afterwards, and says how it goes: the process and the infractions.
/// Since it looks at the replay and not at the servo, what it says live is what is said later. Any one thread; about
/// 0.1 us a tick, more where material comes away.
class LiveAssessor
{
public:
    LiveAssessor(const Examination& examination, std::shared_ptr<const terrain::ToothAnatomy> anatomy);

    /// An event of the recording, after the replay has played it.
    void take(const servo::ServoEvent& event, const recording::Replayer& replayed);

    /// Bits of servo::Aid: those that were in use at any time.
    [[nodiscard]] std::uint8_t aids() const { return m_aids; }
    [[nodiscard]] grading::Process process() const { return m_meter->process(); }
    [[nodiscard]] const std::vector<grading::Infraction>& infractions() const { return m_infractions; }
    /// How the exercise goes; nothing where there is none.
    [[nodiscard]] std::optional<grading::Practised> practised() const;
    /// When something was on the recording that was `atS` seconds into the work, of which rests are none.
    [[nodiscard]] double recordedS(double atS) const;

private:
    /// Time on the recording that is none of the work.
    struct Rest
    {
        std::chrono::microseconds after;  ///< of work
        std::chrono::microseconds length{0};
    };

    std::unique_ptr<grading::ProcessMeter> m_meter;
    grading::RuleChecker m_referee;
    std::optional<grading::ExerciseMeter> m_exercise;
    std::uint8_t m_aids = 0;
    recording::IdleIntervals m_rests;
    bool m_leftOut = false;  ///< the last step was none of the work
    std::chrono::microseconds m_worked{0};
    std::vector<Rest> m_left;
    std::vector<grading::Infraction> m_infractions;
};

}  // namespace core::session
