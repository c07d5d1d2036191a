// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "app/school/GradedMarker.h"
#include "core/grading/RuleChecker.h"
#include "core/servo/ServoState.h"
#include "core/session/LiveAssessmentLoop.h"
#include "lessons/Assignment.h"

namespace app {

/// The state of the attempt that is in progress. docs/ARCHITECTURE.md shows the states and their transitions. The class
/// uses no window, no database and no clock: controllers report events and ask which steps are allowed next. Ui thread.
class CurrentAttempt
{
public:
    enum class State : std::uint8_t {
        Empty,       ///< no tooth has been loaded yet
        Ready,       ///< the tooth can be worked on
        Settling,    ///< a grade was requested; the bur must leave the tooth first
        Predicting,  ///< the work to grade is fixed; the student may be asked which score they expect
        Graded,      ///< the work has a grade; further work on the tooth is another attempt
    };

    /// Whether the attempt is an exam, and whether it counts as one of the student's attempts.
    enum class Exam : std::uint8_t {
        None,      ///< the attempt is not an exam
        NotBegun,  ///< nothing has been cut yet, so the exam does not count
        Checking,  ///< begun; the answer of the database, whether an attempt is left, has not arrived
        Counted,   ///< counts as an attempt, whether or not it is graded
        Refused,   ///< no attempt was left, so the work does not count
    };

    /// Starts an attempt: changes to Ready from any state.
    /// @param generation  number of its tooth; greater than the number of every earlier tooth
    void begin(std::uint64_t generation, const lessons::Assignment& assignment,
               const core::servo::ServoSettings& settings);

    /// Marks the attempt that has just begun as the continuation of an unfinished one. An exam then counts already.
    /// @param atTick  the tick up to which the attempt had been recorded
    /// @param seen    set if the student has seen the score but it was not saved; then nothing can be cut any more
    void resume(std::uint64_t atTick, const std::optional<GradedMarker>& seen);

    [[nodiscard]] State state() const { return m_state; }
    [[nodiscard]] std::uint64_t generation() const { return m_generation; }
    /// Returns the assignment of the attempt. Its anatomy is null in the state Empty.
    [[nodiscard]] const lessons::Assignment& assignment() const { return m_assignment; }
    [[nodiscard]] const core::servo::ServoSettings& settings() const { return m_settings; }
    [[nodiscard]] bool hasTooth() const { return m_assignment.anatomy != nullptr; }
    [[nodiscard]] bool isExam() const { return m_exam != Exam::None; }
    [[nodiscard]] bool isResumed() const { return m_isResumed; }
    [[nodiscard]] const std::optional<GradedMarker>& seenBefore() const { return m_seenBefore; }

    /// Requests a grade: changes to Settling. Returns false if there is no tooth or a grade was requested already.
    bool settle();
    /// Cancels the request: changes back to the state before settle().
    void stopSettling();
    /// Fixes the work that will be graded: changes to Predicting. After the end of an exam, that is the work at its
    /// end.
    /// @param now         returns the present work; not called if the work at the end of the exam is known
    /// @param isExamOver  whether the exam has ended, so that `now` returns the work at its end
    template <class Now>
    void conclude(const Now& now, bool isExamOver)
    {
        if (m_examsEnd)
            m_toGrade = m_examsEnd;
        else
            m_toGrade = now();
        if (isExamOver && !m_examsEnd)
            m_examsEnd = m_toGrade;
        m_state = State::Predicting;
    }
    /// Returns the work to grade, once, and changes to Graded. Returns nullopt in every state other than Predicting,
    /// and if there is no work or it belongs to another tooth.
    [[nodiscard]] std::optional<core::session::AttemptSnapshot> grade();
    /// Returns whether this attempt has been graded.
    [[nodiscard]] bool isGraded() const { return m_isGraded; }

    /// Sets whether the attempt pauses while a recording is played in its place. begin() ends the pause.
    void setResting(bool isResting) { m_isResting = isResting; }
    [[nodiscard]] bool isResting() const { return m_isResting; }

    [[nodiscard]] Exam exam() const { return m_exam; }
    /// Reports the first cut of an exam. Returns true the first time: the caller must count the exam. A resumed exam is
    /// then Counted at once, any other is Checking until answerExam().
    bool startExam();
    /// Reports whether an attempt was left: changes from Checking to Counted or Refused. Does nothing in any other
    /// case.
    /// @param generation  number of the tooth in the request; the answer for another tooth is ignored
    /// @returns whether the exam has been refused by this call
    bool answerExam(std::uint64_t generation, bool isAllowed);

    /// Returns the violation that is explained to the student next: the gravest one that has not been reported yet. In
    /// an exam returns nullopt. Violations before the tick at which the attempt was resumed count as reported.
    /// @param found  all violations of the attempt, in the order of their ticks
    [[nodiscard]] std::optional<core::grading::Infraction>
    nextViolation(const std::vector<core::grading::Infraction>& found);

private:
    State m_state = State::Empty;
    State m_beforeSettling = State::Empty;
    Exam m_exam = Exam::None;
    std::uint64_t m_generation = 0;
    lessons::Assignment m_assignment;
    core::servo::ServoSettings m_settings;
    bool m_isResumed = false;
    bool m_isGraded = false;
    bool m_isResting = false;
    std::uint64_t m_resumedAtTick = 0;
    std::optional<GradedMarker> m_seenBefore;
    std::size_t m_violationsReported = 0;
    std::optional<core::session::AttemptSnapshot> m_toGrade;
    std::optional<core::session::AttemptSnapshot> m_examsEnd;  ///< the work at the end of the exam
};

}  // namespace app
