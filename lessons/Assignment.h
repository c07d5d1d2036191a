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

/// The current task and how it is graded: a lesson with its tooth built and its ideal computed, or a tooth for free
/// practice. A plain value.
struct Assignment
{
    std::shared_ptr<const core::terrain::ToothAnatomy> anatomy;
    std::optional<Lesson> lesson;  ///< empty: free practice
    Rubric rubric;
    std::optional<core::grading::Preparation> ideal;  ///< the surface to be cut; empty if decay is to be removed
    std::optional<core::grading::Leeway> leeway;
    std::shared_ptr<const core::terrain::HeightMaps> neighbours;  ///< must not be touched; null: not checked
    std::optional<core::grading::Exercise> exercise;              ///< set for an exercise, in which nothing is cut

    /// Returns the ideal surface for view and section. Null if there is none, or if it would reveal the answer to the
    /// task.
    [[nodiscard]] core::grading::IdealTop shownIdeal() const;
};

/// An assignment with the importer's report on its tooth.
struct Assigned
{
    Assignment assignment;
    core::teeth::ToothReport report;
};

/// Returns the design of a lesson's block. Error, one sentence, if a shape or size is unknown or they do not fit.
[[nodiscard]] core::Result<core::teeth::BlockDesign> designOf(const Block& block);

/// Returns the servo settings for an attempt at a lesson, or without one (null). They combine the available handpieces,
/// the hardness of the lesson (otherwise of the preset) and the preset's forces.
/// @param usual   settings with the device's part of the force law
/// @param preset  used by the school
/// @param kind    of the tooth without a lesson
[[nodiscard]] core::servo::ServoSettings
servoSettings(const Lesson* lesson, core::servo::ServoSettings usual,
              const core::settings::FeelPreset& preset = shippedPresets().front(),
              const core::settings::ToothKind& kind = {});

/// Builds the tooth and the task of a lesson. Some tens of milliseconds; any thread but the ui thread.
/// @param drawn  seed for a block whose lesson has none; different for each attempt. The recording stores it with the
///               tooth, so that every replay has the same task
[[nodiscard]] core::Result<Assigned> assign(const Lesson& lesson, std::uint64_t drawn = 0);

/// Returns whether an uncut tooth is that of a lesson. The text of a lesson in a recording has no scan: use the lesson
/// of the file. Takes as long as assign().
[[nodiscard]] bool isToothOf(const Lesson& lesson, const core::terrain::ToothAnatomy& tooth);

/// Returns whether two assignments are of the same lesson, both as practice or both as an exam. False without a lesson.
[[nodiscard]] bool isSameLesson(const Assignment& a, const Assignment& b);

/// Returns the initial depth of the depth stop, mm below the original surface. For a Class I or II it is the depth of
/// the occlusal floor below the groove, where the bur enters. For an occlusal reduction it is the depth of most of the
/// surface. Otherwise it is the median over the columns of the ideal floor, or 1.5 if no ideal is shown.
[[nodiscard]] double depthToCutMm(const Assignment& assignment);

/// Returns whether the outline of the ideal is shown from the start. True in practice lessons with an ideal. In lessons
/// on decay the outline would reveal the decay, and in exams it is not allowed.
[[nodiscard]] bool beginsWithOutline(const Assignment& assignment);

/// Returns the rubric for a tooth without a lesson: removal of decay.
[[nodiscard]] core::Result<Rubric> practiceRubric();
/// Returns the assignment for a tooth without a lesson.
[[nodiscard]] core::Result<Assignment> practiceOn(std::shared_ptr<const core::terrain::ToothAnatomy> anatomy);

/// Returns the assignment that a recording was made for.
/// @param lessonJson  the lesson in the recording; empty: free practice
[[nodiscard]] core::Result<Assignment> assignmentOf(std::shared_ptr<const core::terrain::ToothAnatomy> anatomy,
                                                    const std::string& lessonJson);

/// Reads the expert's recording that the assignment's lesson names. The error names the file: it cannot be read, or is
/// of another tooth than the current one (OtherTooth; the order of a block's layers may differ). Fails for a lesson
/// from a recording, which contains only the name of the file. Call it in any thread but the ui thread.
[[nodiscard]] core::Result<core::recording::Recording> readExpert(const Assignment& assignment);

/// A measured and graded attempt.
struct Mark
{
    core::grading::Measured measured;
    ScoreSheet sheet;
};

/// The measured process of an attempt.
struct Conduct
{
    core::grading::Process process;
    std::vector<core::grading::Infraction> infractions;
    std::uint8_t aids = 0;                              ///< bits of core::servo::Aid that were in use
    std::optional<core::grading::Practised> practised;  ///< for an exercise

    /// Sets the measures of the process.
    void addTo(core::grading::Measured& measured) const;
};

/// Returns the examination for an assignment.
[[nodiscard]] core::session::Examination examinationOf(const Assignment& assignment);

/// Measures a tooth of the assignment's anatomy and grades it. Takes a few milliseconds at 150 x 150. Call it in any
/// thread that owns the tooth.
/// @param conduct  empty if only the tooth is known: the process is then not measured
[[nodiscard]] core::Result<Mark> mark(const Assignment& assignment, const core::terrain::Tooth& tooth,
                                      const std::optional<Conduct>& conduct = {});

/// The result of replaying and grading a recording.
struct Remarked
{
    core::recording::ReplayOutcome outcome;
    Mark mark;
    Conduct conduct;
};

/// Replays a recording and grades it for its lesson, with the rule violations and their times. The results are
/// bit-identical to those of the attempt.
/// @param afterEvent  as in core::recording::replay()
[[nodiscard]] core::Result<Remarked>
markAgain(const core::recording::Recording& recording,
          const std::function<void(const core::servo::ServoEvent&, const core::recording::Replayer&)>& afterEvent = {});

}  // namespace lessons
