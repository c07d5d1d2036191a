// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "database/AttemptRecord.h"
#include "database/sql/DatabaseContext.h"

namespace database::sql {

/// Returns the attempts of a person with feedback of others (a comment or an override), newest feedback first, and
/// whether that person has seen it.
[[nodiscard]] core::Result<std::vector<Feedback>> feedbackFor(const DatabaseContext& school, const Login& session,
                                                              PersonId person);

/// Records that the user has seen the feedback on an attempt.
[[nodiscard]] core::Status seeFeedback(const DatabaseContext& school, const Login& session,
                                       const AttemptRecord& attempt);

}  // namespace database::sql
