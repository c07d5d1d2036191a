// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "core/base/Result.h"
#include "core/tracking/Picture.h"
#include "core/tracking/PictureWatch.h"
#include "core/tracking/Tag.h"

/// What head tracking reports to the ui. Plain values.
namespace core::tracking {

/// How far head tracking has come.
enum class TrackerStage : std::uint8_t {
    Opening,   ///< the camera is being opened
    NoCamera,  ///< it cannot be opened, or gives no pictures any more; TrackerReport::error says why. Tried again
    NoTag,     ///< pictures come in; the tag is not in them
    Tracking,
    Ended,  ///< a video is over
};

/// What the page of devices shows of head tracking.
struct TrackerReport
{
    TrackerStage stage = TrackerStage::Opening;
    Error error{};
    PictureTrouble trouble = PictureTrouble::None;
    int sameTags = 0;     ///< tags with the searched number that were in a picture lately
    double hz = 0.0;      ///< pictures a second
    double findMs = 0.0;  ///< medians of the last second
    double poseMs = 0.0;
    double latencyMs = 0.0;  ///< from the picture to the pose; 0 for a video
    double seenShare = 0.0;  ///< of the pictures of the last second
    /// Root mean square of the filtered position around its mean, last second. 0 while the head moves.
    double jitterMm = 0.0;
    PosedTag tag;     ///< as seen last
    Picture picture;  ///< the last one; empty unless it was asked for
};

}  // namespace core::tracking
