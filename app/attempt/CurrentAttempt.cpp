// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/attempt/CurrentAttempt.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace app {

void CurrentAttempt::begin(std::uint64_t generation, const lessons::Assignment& assignment,
                           const core::servo::ServoSettings& settings)
{
    assert(generation > m_generation);
    assert(assignment.anatomy != nullptr);
    m_state = State::Ready;
    m_beforeSettling = State::Ready;
    m_generation = generation;
    m_assignment = assignment;
    m_settings = settings;
    m_exam = assignment.lesson && assignment.lesson->exam ? Exam::NotBegun : Exam::None;
    m_isResumed = false;
    m_isGraded = false;
    m_isResting = false;
    m_resumedAtTick = 0;
    m_seenBefore.reset();
    m_violationsReported = 0;
    m_toGrade.reset();
    m_examsEnd.reset();
}

void CurrentAttempt::resume(std::uint64_t atTick, const std::optional<GradedMarker>& seen)
{
    assert(m_state == State::Ready && !m_isResumed);
    m_isResumed = true;
    m_resumedAtTick = atTick;
    m_seenBefore = seen;
}

bool CurrentAttempt::settle()
{
    if (m_state == State::Empty || m_state == State::Settling)
        return false;
    m_beforeSettling = std::exchange(m_state, State::Settling);
    return true;
}

void CurrentAttempt::stopSettling()
{
    if (m_state == State::Settling)
        m_state = m_beforeSettling;
}

std::optional<core::session::AttemptSnapshot> CurrentAttempt::grade()
{
    if (m_state != State::Predicting)
        return std::nullopt;
    auto toGrade = std::exchange(m_toGrade, std::nullopt);
    if (!toGrade || toGrade->findings.generation != m_generation) {
        m_state = m_isGraded ? State::Graded : State::Ready;
        return std::nullopt;
    }
    m_state = State::Graded;
    m_isGraded = true;
    return toGrade;
}

bool CurrentAttempt::startExam()
{
    if (m_exam != Exam::NotBegun || m_isGraded)
        return false;
    m_exam = m_isResumed ? Exam::Counted : Exam::Checking;
    return true;
}

bool CurrentAttempt::answerExam(std::uint64_t generation, bool isAllowed)
{
    if (generation != m_generation || m_exam != Exam::Checking)
        return false;
    m_exam = isAllowed ? Exam::Counted : Exam::Refused;
    return !isAllowed;
}

std::optional<core::grading::Infraction>
CurrentAttempt::nextViolation(const std::vector<core::grading::Infraction>& found)
{
    if (found.size() <= m_violationsReported)
        return std::nullopt;
    const auto first =
        std::find_if(found.begin() + static_cast<std::ptrdiff_t>(m_violationsReported), found.end(),
                     [this](const core::grading::Infraction& one) { return one.tick > m_resumedAtTick; });
    m_violationsReported = found.size();
    if (isExam() || first == found.end())
        return std::nullopt;
    return *std::min_element(first, found.end(), [](const auto& a, const auto& b) { return a.breach < b.breach; });
}

}  // namespace app
