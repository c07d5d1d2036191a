// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>

#include "core/base/Result.h"
#include "database/sql/DatabaseContext.h"

namespace database::sql {

/// Names and values as texts; what they mean is for who uses them.
using SettingsMap = std::map<std::string, std::string>;

/// The session's own, and the school's, over which nobody has a say for himself.
[[nodiscard]] core::Result<SettingsMap> readSettings(const DatabaseContext& school, const Login& session);
/// For everybody here. OutOfRange: the value has more than 16,000 characters.
[[nodiscard]] core::Status changeSetting(const DatabaseContext& school, const Login& session, const std::string& name,
                                         const std::string& value);

struct ReplacedSetting
{
    bool isDone = false;
    std::string before;  ///< what was there until then; empty: nothing
};
/// The same, and tells in the place of what.
/// @param of  only where that is still what is there; nothing: whatever is
[[nodiscard]] core::Result<ReplacedSetting> replaceSetting(const DatabaseContext& school, const Login& session,
                                                           const std::string& name, const std::string& value,
                                                           const std::optional<std::string>& of = {});
/// For the session's person alone. OutOfRange as above.
[[nodiscard]] core::Status changeOwnSetting(const DatabaseContext& school, const Login& session,
                                            const std::string& name, const std::string& value);

/// For everybody here, into the audit, too: inside a transaction of others, who have taken their turn and looked
/// whether it is allowed.
/// @param actor  uid, or "system"
[[nodiscard]] core::Status putSetting(const DatabaseContext& school, const std::string& actor, const std::string& name,
                                      const std::string& value);

}  // namespace database::sql
