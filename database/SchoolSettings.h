// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

/// Settings and hardness presets as a school stores them.
namespace database {

/// Settings by name. Names and values are text, which the users of a setting interpret.
using SettingsMap = std::map<std::string, std::string>;

/// The outcome of replacing a setting.
struct ReplacedSetting
{
    bool isDone = false;
    std::string before;  ///< the value until then; empty: there was none
};

/// Setting of the school for the preset in use, as "name v2". Empty: the preset that is shipped with Cusp.
inline const std::string kPresetInUse = "preset.in_use";
/// Setting of the school for the names of the retired presets, which are no longer offered, one per line.
inline const std::string kRetiredPresets = "preset.retired";

/// A version of a hardness preset, with the content of its file.
struct KeptPreset
{
    std::string name;
    int version = 0;
    std::string hash;
    std::string json;
    bool operator==(const KeptPreset&) const = default;
};

}  // namespace database
