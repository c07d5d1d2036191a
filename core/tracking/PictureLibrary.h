// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/tracking/Picture.h"

/// What the library `cusp_pictures` offers. It is loaded when the first camera, video or image is opened: OpenCV's
/// videoio brings some 220 libraries along, which cost each start of Cusp 0.1 s and 60 MB.
namespace core::tracking {

/// A camera or a video file. One thread at a time.
class PictureReader
{
public:
    PictureReader() = default;
    virtual ~PictureReader() = default;
    PictureReader(const PictureReader&) = delete;
    PictureReader& operator=(const PictureReader&) = delete;

    /// Reads the next picture; false if there is none. Leaves the name alone.
    [[nodiscard]] virtual bool read(Picture& picture) = 0;
    /// Of a video, as its header has it; 0 for what that leaves open.
    struct Length
    {
        double seconds = 0.0;
        double pictures = 0.0;
    };
    [[nodiscard]] virtual Length length() const = 0;
};

/// Functions of the library; none throws.
struct PictureLibrary
{
    /// Null if the camera gives no picture.
    PictureReader* (*openCamera)(int number, int width, int height, double hz);
    /// Null if the file is no video.
    PictureReader* (*openVideo)(const char* path);
    /// False if the file is no image, or is cut off.
    bool (*readImage)(const char* path, Picture& picture);
};

/// Name of the function that returns the library's functions.
inline constexpr const char* kEntry = "cuspPictures";
using Entry = const PictureLibrary* (*)();

}  // namespace core::tracking
