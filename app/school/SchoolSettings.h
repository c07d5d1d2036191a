// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "database/SchoolSettings.h"

/// Settings that apply to all users of a school.
namespace app {

inline const std::string kIdleMinutes = "idle.minutes";
inline constexpr int kUsualIdleMinutes = 10;

/// Returns the number of minutes without input after which the window is locked.
[[nodiscard]] int idleMinutesOf(const database::SettingsMap& settings);

}  // namespace app
