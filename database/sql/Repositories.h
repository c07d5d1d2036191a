// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "database/Repositories.h"
#include "database/sql/DatabaseContext.h"

namespace database::sql {

/// Calls `use` with the repositories of a school over its connection. They live until this function returns. Call it in
/// the thread of the connection.
void withRepositories(const DatabaseContext& school, const std::function<void(const Repositories&)>& use);

}  // namespace database::sql
