// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/devices/HeadTrackingSettings.h"

namespace app {

/// Returns the settings of head tracking that are stored on this computer. A value that is missing or out of range is
/// replaced by the default value.
[[nodiscard]] ui::devices::HeadTrackingSettings storedHeadTracking();
void storeHeadTracking(const ui::devices::HeadTrackingSettings& settings);

/// Sets the field of view and the calibration to the values that are stored for the camera or video of the settings.
void recallLens(ui::devices::HeadTrackingSettings& settings);

}  // namespace app
