// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/scoring/ScorePage.h"

namespace app {

/// The circumstances that decide where a grade is saved.
struct GradeCircumstances
{
    bool hasDatabase = false;
    bool isGuest = false;      ///< nobody is logged in
    bool isExam = false;       ///< the lesson of the attempt is an exam
    bool isResumed = false;    ///< the attempt continues an unfinished one
    bool isSimulated = false;  ///< a simulated hand did the work
    bool isTrial = false;      ///< the tooth is a block on which a preset is tried
    bool isOverLimit = false;  ///< the student had no attempt left
};

/// Returns where a new grade is saved: Nowhere, Guest (saved if the guest logs in) or Pending (in the database). For a
/// guest, exams and resumed attempts are saved nowhere: a guest could repeat an exam and log in for the best result,
/// and an unfinished attempt may belong to another guest.
[[nodiscard]] constexpr ui::scoring::ScorePage::Keeping destinationOf(const GradeCircumstances& of)
{
    using Keeping = ui::scoring::ScorePage::Keeping;
    const bool isNobodys =
        of.isSimulated || of.isTrial || of.isOverLimit || (of.isGuest && (of.isExam || of.isResumed));
    if (!of.hasDatabase || isNobodys)
        return Keeping::Nowhere;
    return of.isGuest ? Keeping::Guest : Keeping::Pending;
}

}  // namespace app
