// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "database/SchoolSettings.h"
#include "database/sql/DatabaseContext.h"

namespace database::sql {

using database::KeptPreset;

/// Returns all versions of all presets, by name, the newest version of each first. All users.
[[nodiscard]] core::Result<std::vector<KeptPreset>> listPresets(const DatabaseContext& school, const Login& session);
/// Stores a version, which is never changed. OutOfRange if that version exists with different contents. Does nothing if
/// it exists with the same contents. Admins.
[[nodiscard]] core::Status addPreset(const DatabaseContext& school, const Login& session, const KeptPreset& preset);

}  // namespace database::sql
