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

/// The tooth, the lesson and the attempt in the practice room, and the replay in their place. The window owns one, and
/// its parts share it. Ui thread.
struct PracticeState
{
    std::shared_ptr<const core::terrain::ToothAnatomy> tooth;  ///< the tooth that is shown; null before the first
    core::grading::IdealTop ideal;                             ///< of that tooth; null: there is none
    std::uint64_t ownGeneration = 0;                           ///< generation of the student's tooth
    core::servo::ServoState servo;                             ///< of the last frame
    core::session::SessionState session;                       ///< of the last frame

    std::optional<lessons::Assignment> assignment;  ///< of the student's tooth
    lessons::Aids aids;                             ///< those that the lesson allows
    bool isGraded = false;                          ///< the student's attempt has a score
    bool isExamOver = false;                        ///< cutting is disabled
    bool isExamRefused = false;                     ///< the attempt does not count: another one was begun elsewhere
    bool isUsedUp = false;                          ///< the student has no attempt left

    bool isReplaying = false;
    std::optional<lessons::Lesson> replayedLesson;  ///< of the recording; unset: free practice
    core::terrain::PerMaterial workAtRest{};        ///< the student's work while a recording is played

    [[nodiscard]] bool isExam() const { return assignment && assignment->lesson && assignment->lesson->exam; }
    /// Returns whether the student's exam has begun and has no score yet.
    [[nodiscard]] bool isExamRunning() const { return isExam() && !isGraded && !isExamRefused; }
    /// Returns whether the tooth that is shown belongs to the student's assignment.
    [[nodiscard]] bool isAssigned() const { return assignment && assignment->anatomy == tooth; }
    /// Returns the lesson of the attempt that is shown, which is the student's or the replayed one; null: none.
    [[nodiscard]] const lessons::Lesson* lesson() const;
    /// Returns the title of that lesson, otherwise of the tooth.
    [[nodiscard]] QString title() const;
    /// Returns the volume that the student has removed from the present tooth, by material.
    [[nodiscard]] core::terrain::PerMaterial ownWork() const;
};

}  // namespace ui::window
