// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "core/tracking/TrackerReport.h"
#include "ui/devices/DeviceWords.h"
#include "ui/devices/HeadTrackingSettings.h"

/// States of head tracking in the user's language.
namespace ui::devices {

struct TrackingState
{
    bool isInBuild = true;  ///< false: this program was built without head tracking
    HeadTrackingSettings settings;
    core::tracking::TrackerReport report;  ///< without its picture; counts while head tracking is on
};

/// Pictures come in, and the tag may be looked for in them.
[[nodiscard]] bool hasPictures(const TrackingState& state);
[[nodiscard]] Sign signOf(const TrackingState& state);
/// "The tag is not in the picture."
[[nodiscard]] QString stateWords(const TrackingState& state);
/// What to do about the state, one or two sentences.
[[nodiscard]] QString helpWords(const TrackingState& state);

}  // namespace ui::devices
