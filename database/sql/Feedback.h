// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "database/AttemptRecord.h"
#include "database/sql/DatabaseContext.h"

namespace database::sql {

/// Those attempts of a person of which others have said something, a comment or another score; what was said last comes
/// first, and whether that person has seen it.
[[nodiscard]] core::Result<std::vector<Feedback>> feedbackFor(const DatabaseContext& school, const Login& session,
                                                              PersonId person);

/// The session's person has seen what was said of an attempt so far.
[[nodiscard]] core::Status seeFeedback(const DatabaseContext& school, const Login& session,
                                       const AttemptRecord& attempt);

}  // namespace database::sql
