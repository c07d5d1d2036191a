// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/Result.h"
#include "core/grading/MeasureTable.h"
#include "core/recording/Recording.h"
#include "core/session/LiveAssessor.h"
#include "core/teeth/ToothBuilder.h"
#include "lessons/Lesson.h"
#include "lessons/PresetFile.h"

namespace lessons {

/// What lies on the table and how it will be marked: a lesson with its tooth made and its ideal worked out, or a tooth
/// to practise on freely. A plain value.
struct Assignment
{
    std::shared_ptr<const core::terrain::ToothAnatomy> anatomy;
    std::optional<Lesson> lesson;  ///< none: practised freely
    Rubric rubric;
    std::optional<core::grading::Preparation> ideal;  ///< what is to be cut; nothing where decay is to be removed
    std::optional<core::grading::Leeway> leeway;
    std::shared_ptr<const core::terrain::HeightMaps> neighbours;  ///< to be spared; null: not watched
    std::optional<core::grading::Exercise> exercise;  ///< what is to be practised; nothing is to be cut then

    /// The surface that is asked for, for view and section; null if nothing is, or if it would tell what is to be felt.
    [[nodiscard]] core::grading::IdealTop shownIdeal() const;
};

/// An assignment and what the importer had to say about its tooth.
struct Assigned
{
    Assignment assignment;
    core::teeth::ToothReport report;
};

/// The block that a lesson names, with its sizes; a sentence where there is no such shape or size, or they do not fit.
[[nodiscard]] core::Result<core::teeth::BlockDesign> designOf(const Block& block);

/// What computes an attempt at a lesson, or without one (null): the handpieces at hand, the hardness of the lesson or
/// else of the preset, and the preset's forces.
/// @param usual   what the device adds to the force law
/// @param preset  in use in the school
/// @param kind    of what lies there without a lesson
[[nodiscard]] core::servo::ServoSettings
servoSettings(const Lesson* lesson, core::servo::ServoSettings usual,
              const core::settings::FeelPreset& preset = shippedPresets().front(),
              const core::settings::ToothKind& kind = {});

/// Makes the tooth of a lesson and what is asked of it. Some tens of milliseconds; any thread that may wait.
/// @param drawn  the seed of a block whose lesson names none, another for each attempt. It goes with the tooth into the
///               recording, so that every replay asks the same
[[nodiscard]] core::Result<Assigned> assign(const Lesson& lesson, std::uint64_t drawn = 0);

/// Returns whether two assignments are of the same lesson, both in practice or both as an exam. False without a lesson.
[[nodiscard]] bool isSameLesson(const Assignment& a, const Assignment& b);

/// Returns the depth that the depth stop starts with, mm below the original surface. For a Class I or II, it is the
/// depth of the occlusal floor below the groove, where the bur enters; for an occlusal reduction, that of most of the
/// surface; otherwise the median over the columns of the
/// ideal floor, or 1.5 if no ideal is shown.
[[nodiscard]] double depthToCutMm(const Assignment& assignment);

/// Returns whether the outline of the ideal is shown from the start: in practice lessons with an ideal. In lessons on
/// decay it would show where the decay is, and in exams it is locked.
[[nodiscard]] bool beginsWithOutline(const Assignment& assignment);

/// What a tooth without a lesson is marked by: removal of decay.
[[nodiscard]] core::Result<Rubric> practiceRubric();
/// A tooth without a lesson.
[[nodiscard]] core::Result<Assignment> practiceOn(std::shared_ptr<const core::terrain::ToothAnatomy> anatomy);

/// The assignment that a recording was made for.
/// @param lessonJson  what the recording keeps; empty: practised freely
[[nodiscard]] core::Result<Assignment> assignmentOf(std::shared_ptr<const core::terrain::ToothAnatomy> anatomy,
                                                    const std::string& lessonJson);

/// The expert's recording that the assignment's lesson names. An error names the file: where it cannot be read, and
/// where it is of another tooth than lies on the table (of layers to be told apart, the order may differ; OtherTooth).
/// A lesson that a recording took along knows the file's name and not its folder: that is an error as well. Any thread
/// that may wait.
[[nodiscard]] core::Result<core::recording::Recording> readExpert(const Assignment& assignment);

/// An attempt, measured and marked.
struct Mark
{
    core::grading::Measured measured;
    ScoreSheet sheet;
};

/// How an attempt went, as an examiner found it.
struct Conduct
{
    core::grading::Process process;
    std::vector<core::grading::Infraction> infractions;
    std::uint8_t aids = 0;                              ///< bits of core::servo::Aid that were in use
    std::optional<core::grading::Practised> practised;  ///< of an exercise

    /// Sets what is measured of the way of an attempt.
    void addTo(core::grading::Measured& measured) const;
};

/// What an examiner of this assignment watches.
[[nodiscard]] core::session::Examination examinationOf(const Assignment& assignment);

/// Measures a tooth of the assignment's anatomy and marks it. A few milliseconds at 150 x 150. Any thread that owns the
/// tooth.
/// @param conduct  nothing where only the tooth is known: what is about the way is not measured then
[[nodiscard]] core::Result<Mark> mark(const Assignment& assignment, const core::terrain::Tooth& tooth,
                                      const std::optional<Conduct>& conduct = {});

/// What replaying a recording came to.
struct Remarked
{
    core::recording::ReplayOutcome outcome;
    Mark mark;
    Conduct conduct;
};

/// Replays a recording, marks it for the lesson it was made for, and says what went wrong when: what was said while it
/// was made, to the bit.
/// @param afterEvent  as in core::recording::replay
[[nodiscard]] core::Result<Remarked>
markAgain(const core::recording::Recording& recording,
          const std::function<void(const core::servo::ServoEvent&, const core::recording::Replayer&)>& afterEvent = {});

}  // namespace lessons
