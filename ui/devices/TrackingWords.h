// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "core/tracking/TrackerReport.h"
#include "ui/devices/DeviceWords.h"
#include "ui/devices/HeadTrackingSettings.h"

/// Texts about head tracking in the user's language.
namespace ui::devices {

struct TrackingState
{
    bool isInBuild = true;  ///< false: this program was built without head tracking
    HeadTrackingSettings settings;
    core::tracking::TrackerReport report;  ///< without its picture; valid while head tracking is on
};

/// Returns whether the camera delivers pictures.
[[nodiscard]] bool hasPictures(const TrackingState& state);
[[nodiscard]] Sign signOf(const TrackingState& state);
/// Returns a sentence on the state, such as "The tag is not in the picture."
[[nodiscard]] QString stateWords(const TrackingState& state);
/// Returns one or two sentences on what to do in this state.
[[nodiscard]] QString helpWords(const TrackingState& state);

}  // namespace ui::devices
