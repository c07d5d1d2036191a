// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "core/base/Result.h"
#include "core/tracking/Picture.h"
#include "core/tracking/PictureWatch.h"
#include "core/tracking/Tag.h"

/// The report of head tracking to the ui. Plain values.
namespace core::tracking {

/// The state of head tracking.
enum class TrackerStage : std::uint8_t {
    Opening,   ///< the camera is being opened
    NoCamera,  ///< it cannot be opened, or delivers no more pictures; TrackerReport::error says why. Retried
    NoTag,     ///< pictures arrive without the tag
    Tracking,
    Ended,  ///< the video has ended
};

/// The state of head tracking for the devices page.
struct TrackerReport
{
    TrackerStage stage = TrackerStage::Opening;
    Error error{};
    PictureTrouble trouble = PictureTrouble::None;
    int sameTags = 0;     ///< tags with the searched number in recent pictures
    double hz = 0.0;      ///< pictures per second
    double findMs = 0.0;  ///< medians of the last second
    double poseMs = 0.0;
    double latencyMs = 0.0;  ///< from the picture to the pose; 0 for a video
    double seenShare = 0.0;  ///< share of the pictures of the last second with the tag
    /// Root mean square of the filtered position around its mean, last second. 0 while the head moves.
    double jitterMm = 0.0;
    PosedTag tag;     ///< as last seen
    Picture picture;  ///< the last one; empty unless requested
};

}  // namespace core::tracking
