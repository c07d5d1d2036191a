// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "core/tracking/Picture.h"

namespace core::tracking {

/// Faults in the pictures of a working camera.
enum class PictureTrouble : std::uint8_t {
    None,
    Dark,    ///< nearly black: a lid, or no light
    Bright,  ///< nearly white: a lamp or a window in front of the camera
    Frozen,  ///< the same picture repeatedly
};

/// Detects dark, bright and frozen pictures from a few thousand pixels of each.
class PictureWatch
{
public:
    PictureTrouble take(const PictureView& picture);

private:
    std::uint64_t m_last = 0;  ///< digest of the last picture
    int m_same = 0;            ///< identical pictures in a row
    int m_dark = 0;
    int m_bright = 0;
};

}  // namespace core::tracking
