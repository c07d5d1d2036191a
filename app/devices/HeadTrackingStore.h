// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/devices/HeadTrackingSettings.h"

namespace app {

/// Settings of head tracking, as this computer stores them. A value that is missing or out of range is the default one.
[[nodiscard]] ui::devices::HeadTrackingSettings storedHeadTracking();
void storeHeadTracking(const ui::devices::HeadTrackingSettings& settings);

/// Gives the settings the field of view and the calibration that are stored for their camera or video.
void recallLens(ui::devices::HeadTrackingSettings& settings);

}  // namespace app
