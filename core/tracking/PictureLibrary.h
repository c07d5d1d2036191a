// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/tracking/Picture.h"

/// The functions of the library `cusp_pictures`. It is loaded when the first camera, video or image is opened: OpenCV's
/// videoio loads about 220 libraries, which would cost each start of Cusp 0.1 s and 60 MB.
namespace core::tracking {

/// A camera or a video file. One thread at a time.
class PictureReader
{
public:
    PictureReader() = default;
    virtual ~PictureReader() = default;
    PictureReader(const PictureReader&) = delete;
    PictureReader& operator=(const PictureReader&) = delete;

    /// Reads the next picture; false if there is none. Does not change the name.
    [[nodiscard]] virtual bool read(Picture& picture) = 0;
    /// Length of a video from its header; 0 for missing values.
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
    /// Returns null if the camera delivers no picture.
    PictureReader* (*openCamera)(int number, int width, int height, double hz);
    /// Returns null if the file is no video.
    PictureReader* (*openVideo)(const char* path);
    /// Returns false if the file is no image, or is truncated.
    bool (*readImage)(const char* path, Picture& picture);
};

/// Name of the function that returns the library's functions.
inline constexpr const char* kEntry = "cuspPictures";
using Entry = const PictureLibrary* (*)();

}  // namespace core::tracking
