// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <QByteArray>

#include "database/AttemptRecord.h"
#include "lessons/Assignment.h"

namespace database {

/// Sets the fields of an attempt that its recording proves: tooth, lesson, score, criteria, duration, forces and the
/// state of the tooth.
/// @param stateHash  core::terrain::stateHash() of the graded tooth
void setProven(AttemptRecord& attempt, const lessons::Assignment& assignment, const lessons::ScoreSheet& sheet,
               const lessons::Conduct& conduct, std::uint64_t stateHash);

/// Marks the recording of an attempt again and compares the result with what the station that made it has reported.
/// Practice without a lesson is compared only if it was graded by the rubric of this program. Replaying takes up to a
/// second per minute of the attempt; any thread.
/// @param assigned  the version of the lesson that the school stores; empty: not known. The tooth of a scan can be
///                  compared only with it
/// @param starts    the exams at this lesson that the person has begun, of which the recording of an exam must name one
///                  that is long enough ago; empty: not known, and not compared
[[nodiscard]] Doubt checkAttempt(const AttemptRecord& attempt, const QByteArray& recording,
                                 const std::optional<lessons::Lesson>& assigned = {},
                                 const std::optional<std::vector<ExamStart>>& starts = {});

}  // namespace database
