// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "database/sql/DatabaseContext.h"

namespace database::sql {

/// Names of school settings: "name v2" of the preset in use, if it is not the shipped one; and the names of retired
/// presets, one per line.
inline const std::string kPresetInUse = "preset.in_use";
inline const std::string kRetiredPresets = "preset.retired";

/// A stored version of a hardness preset, with the contents of its file.
struct KeptPreset
{
    std::string name;
    int version = 0;
    std::string hash;
    std::string json;
    bool operator==(const KeptPreset&) const = default;
};

/// Returns all versions of all presets, by name, the newest version of each first. Everybody.
[[nodiscard]] core::Result<std::vector<KeptPreset>> listPresets(const DatabaseContext& school, const Login& session);
/// Stores a version, which is never changed. OutOfRange if that version exists with other contents; the same contents
/// are not stored again. Admins.
[[nodiscard]] core::Status addPreset(const DatabaseContext& school, const Login& session, const KeptPreset& preset);

}  // namespace database::sql
