// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "database/SchoolSettings.h"
#include "database/sql/DatabaseContext.h"

namespace database::sql {

using database::KeptPreset;

/// Returns all versions of all presets, by name, the newest version of each first. Everybody.
[[nodiscard]] core::Result<std::vector<KeptPreset>> listPresets(const DatabaseContext& school, const Login& session);
/// Stores a version, which is never changed. OutOfRange if that version exists with other contents; the same contents
/// are not stored again. Admins.
[[nodiscard]] core::Status addPreset(const DatabaseContext& school, const Login& session, const KeptPreset& preset);

}  // namespace database::sql
