// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "core/tracking/Picture.h"

namespace core::tracking {

/// What is wrong with the pictures of a camera that works.
enum class PictureTrouble : std::uint8_t {
    None,
    Dark,    ///< nearly black: a lid, or no light
    Bright,  ///< nearly white: a lamp or a window before the camera
    Frozen,  ///< the same picture again and again
};

/// Notices dark, bright and frozen pictures. A few thousand pixels of each are looked at.
class PictureWatch
{
public:
    PictureTrouble take(const PictureView& picture);

private:
    std::uint64_t m_last = 0;  ///< digest of the last picture
    int m_same = 0;            ///< pictures in a row that are alike to the bit
    int m_dark = 0;
    int m_bright = 0;
};

}  // namespace core::tracking
