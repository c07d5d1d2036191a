// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "database/SchoolSettings.h"

/// What a school sets for everybody, as it is kept.
namespace app {

inline const std::string kIdleMinutes = "idle.minutes";
inline constexpr int kUsualIdleMinutes = 10;

/// After how many minutes a place that was left is locked.
[[nodiscard]] int idleMinutesOf(const database::SettingsMap& settings);

}  // namespace app
