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

/// The attempt that is in progress, and where it is in its life. docs/ARCHITECTURE.md draws the states. It knows no
/// window, no database and no clock: controllers report what has happened, and ask what may happen next. Ui thread.
class CurrentAttempt
{
public:
    enum class State : std::uint8_t {
        Empty,       ///< no tooth has been loaded yet
        Ready,       ///< the tooth can be worked on
        Settling,    ///< a grade was requested; the bur has to leave the tooth first
        Predicting,  ///< the work to grade is fixed; the student may be asked which score they expect
        Graded,      ///< it has a grade; further work on it is another attempt
    };

    /// Whether an exam counts among the student's attempts.
    enum class Exam : std::uint8_t {
        None,      ///< the attempt is not an exam
        NotBegun,  ///< nothing has been cut yet, so that it does not count
        Checking,  ///< begun; the database is asked whether an attempt is left
        Counted,   ///< counts as an attempt, whether or not it is graded
        Refused,   ///< no attempt was left; the work counts as nothing
    };

    /// Starts an attempt: Ready, from any state.
    /// @param generation  of its tooth; greater than that of every earlier one
    void begin(std::uint64_t generation, const lessons::Assignment& assignment,
               const core::servo::ServoSettings& settings);

    /// Marks the attempt that has just begun as one that was left unfinished. An exam that was left is counted already.
    /// @param atTick  the tick up to which it had been recorded
    /// @param seen    the score was seen, and is saved nowhere: nothing can be cut any more
    void resume(std::uint64_t atTick, const std::optional<GradedMarker>& seen);

    [[nodiscard]] State state() const { return m_state; }
    [[nodiscard]] std::uint64_t generation() const { return m_generation; }
    /// Its anatomy is null in the state Empty.
    [[nodiscard]] const lessons::Assignment& assignment() const { return m_assignment; }
    [[nodiscard]] const core::servo::ServoSettings& settings() const { return m_settings; }
    [[nodiscard]] bool hasTooth() const { return m_assignment.anatomy != nullptr; }
    [[nodiscard]] bool isExam() const { return m_exam != Exam::None; }
    [[nodiscard]] bool isResumed() const { return m_isResumed; }
    [[nodiscard]] const std::optional<GradedMarker>& seenBefore() const { return m_seenBefore; }

    /// Requests a grade: Settling, from any state with a tooth. Returns false if one was requested already.
    bool settle();
    /// Withdraws the request: back to the state before settle().
    void stopSettling();
    /// Fixes the work that will be graded: Predicting. If the exam's time is over, the work as it was then.
    /// @param now  the work of this moment; not called where the end of the exam is known
    /// @param isExamOver  nothing can be cut any more, so that `now` is the end of the exam
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
    /// Returns the work to grade, once: Graded. Empty in any other state than Predicting, and where there is none or it
    /// belongs to another tooth.
    [[nodiscard]] std::optional<core::session::AttemptSnapshot> grade();
    /// Whether a grade was given to this attempt.
    [[nodiscard]] bool isGraded() const { return m_isGraded; }

    /// Sets whether the attempt rests while a recording is played in its place. Another attempt ends the rest.
    void setResting(bool isResting) { m_isResting = isResting; }
    [[nodiscard]] bool isResting() const { return m_isResting; }

    [[nodiscard]] Exam exam() const { return m_exam; }
    /// Reports the first cut of an exam. Returns true the first time: the exam has to be counted. Then it is Counted at
    /// once if it was resumed, else Checking until answerExam().
    bool startExam();
    /// Reports whether an attempt was left: Counted or Refused, from Checking only.
    /// @param generation  for which it was asked; another one's answer changes nothing
    /// @returns whether the exam is refused now
    bool answerExam(std::uint64_t generation, bool isAllowed);

    /// Returns the violation that is explained to the student next: of those not reported yet the gravest; in an exam
    /// none. Violations from before an attempt was resumed were reported then.
    /// @param found  all of the attempt, in the order of their ticks
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
    std::optional<core::session::AttemptSnapshot> m_examsEnd;  ///< the work as the exam's time ran out
};

}  // namespace app
