// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include <QString>

#include "core/grading/IdealCavity.h"
#include "core/servo/ServoState.h"
#include "core/session/SessionChannels.h"
#include "core/terrain/Tooth.h"
#include "lessons/Assignment.h"

namespace ui::window {

/// The tooth, the lesson and the attempt in the practice room, and the replay that is shown in their place. The window
/// owns the only object of this type, and its parts share it. Ui thread.
struct PracticeState
{
    std::shared_ptr<const core::terrain::ToothAnatomy> tooth;  ///< the tooth that is shown; null before the first
    core::grading::IdealTop ideal;                             ///< ideal of that tooth; null: there is none
    std::uint64_t ownGeneration = 0;                           ///< generation of the student's tooth
    core::servo::ServoState servo;                             ///< state at the last frame
    core::session::SessionState session;                       ///< state at the last frame

    std::optional<lessons::Assignment> assignment;  ///< assignment of the student's tooth
    lessons::Aids aids;                             ///< aids that the lesson allows
    bool isGraded = false;                          ///< the student's attempt has a score
    bool isOver = false;         ///< cutting is disabled: the exam has ended, or the attempt is as long as one may be
    bool isExamRefused = false;  ///< the exam does not count: another attempt was begun elsewhere
    bool isUsedUp = false;       ///< the student has no attempt left

    bool isReplaying = false;
    std::optional<lessons::Lesson> replayedLesson;  ///< lesson of the recording; unset: free practice
    core::terrain::PerMaterial workAtRest{};        ///< removed volume of the student's tooth during a replay, mm³

    [[nodiscard]] bool isExam() const { return assignment && assignment->lesson && assignment->lesson->exam; }
    /// Returns whether the student's attempt is an exam that has no score yet and has not been refused.
    [[nodiscard]] bool isExamRunning() const { return isExam() && !isGraded && !isExamRefused; }
    /// Returns whether the tooth that is shown belongs to the student's assignment.
    [[nodiscard]] bool isAssigned() const { return assignment && assignment->anatomy == tooth; }
    /// Returns the lesson of the attempt that is shown, the student's or the replayed one. Null if there is none.
    [[nodiscard]] const lessons::Lesson* lesson() const;
    /// Returns the title of that lesson, or of the tooth if there is no lesson.
    [[nodiscard]] QString title() const;
    /// Returns the volume that the student has removed from their tooth, by material, mm³.
    [[nodiscard]] core::terrain::PerMaterial ownWork() const;
};

}  // namespace ui::window
