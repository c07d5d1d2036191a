// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/scoring/ScorePage.h"

namespace app {

/// The circumstances that decide whose grade it is.
struct GradeCircumstances
{
    bool hasDatabase = false;
    bool isGuest = false;      ///< nobody is logged in
    bool isExam = false;       ///< of the attempt's lesson
    bool isResumed = false;    ///< the attempt had been left unfinished
    bool isSimulated = false;  ///< a simulated hand did the work
    bool isTrial = false;      ///< the tooth is a block on which a preset is tried
    bool isOverLimit = false;  ///< the student had no attempt left
};

/// Returns where a new grade goes: Nowhere, Guest (shown, and saved if they log in for it) or Pending (to the
/// database). A guest could repeat an exam at will and log in for the best one, and an unfinished attempt may be
/// another guest's: neither is saved.
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
