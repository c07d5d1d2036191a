// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "database/Repositories.h"
#include "database/sql/DatabaseContext.h"

namespace database::sql {

/// Returns the repositories of users over a connection, which has to outlive them. Call them in the thread of the
/// connection.
[[nodiscard]] std::unique_ptr<LessonRepository> lessonRepository(const DatabaseContext& school);
[[nodiscard]] std::unique_ptr<LoginRepository> loginRepository(const DatabaseContext& school);

}  // namespace database::sql
