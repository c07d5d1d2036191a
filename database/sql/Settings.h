// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "core/base/Result.h"
#include "database/SchoolSettings.h"
#include "database/sql/DatabaseContext.h"

namespace database::sql {

using database::ReplacedSetting;
using database::SettingsMap;

/// Returns the settings of the user and of the school. A user cannot override a setting of the school.
[[nodiscard]] core::Result<SettingsMap> readSettings(const DatabaseContext& school, const Login& session);
/// Changes a setting of the school. OutOfRange: the value has more than 16,000 characters.
[[nodiscard]] core::Status changeSetting(const DatabaseContext& school, const Login& session, const std::string& name,
                                         const std::string& value);

/// Like changeSetting(), and returns the value before.
/// @param of  changes the setting only if this is its present value; empty: always
[[nodiscard]] core::Result<ReplacedSetting> replaceSetting(const DatabaseContext& school, const Login& session,
                                                           const std::string& name, const std::string& value,
                                                           const std::optional<std::string>& of = {});
/// Changes a setting of the user. OutOfRange as above.
[[nodiscard]] core::Status changeOwnSetting(const DatabaseContext& school, const Login& session,
                                            const std::string& name, const std::string& value);

/// Changes a setting of the school and records it in the audit, inside a transaction of the caller. The caller calls
/// takeTurn() and checks the permission.
/// @param actor  uid, or "system"
[[nodiscard]] core::Status putSetting(const DatabaseContext& school, const std::string& actor, const std::string& name,
                                      const std::string& value);

}  // namespace database::sql
