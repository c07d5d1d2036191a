// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "database/SchoolSettings.h"

/// Settings of a school for everybody.
namespace app {

inline const std::string kIdleMinutes = "idle.minutes";
inline constexpr int kUsualIdleMinutes = 10;

/// After how many minutes without input a station is locked.
[[nodiscard]] int idleMinutesOf(const database::SettingsMap& settings);

}  // namespace app
