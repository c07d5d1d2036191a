// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "database/sql/DatabaseContext.h"

namespace database::sql {

/// Among the school's settings: "name v2" of the preset that is in use, where that is not the one that is shipped; and
/// the names of those that are offered to nobody any more, one a line.
inline const std::string kPresetInUse = "preset.in_use";
inline const std::string kRetiredPresets = "preset.retired";

/// A version of a hardness preset, as it is kept: what its file says.
struct KeptPreset
{
    std::string name;
    int version = 0;
    std::string hash;
    std::string json;
    bool operator==(const KeptPreset&) const = default;
};

/// All versions of all presets, by name, the newest version of each first. Everybody.
[[nodiscard]] core::Result<std::vector<KeptPreset>> listPresets(const DatabaseContext& school, const Login& session);
/// Keeps a version, which is never changed. OutOfRange where there is one of that name and number already with another
/// content; the same again costs nothing. Admins.
[[nodiscard]] core::Status addPreset(const DatabaseContext& school, const Login& session, const KeptPreset& preset);

}  // namespace database::sql
