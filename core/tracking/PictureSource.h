// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/Result.h"
#include "core/tracking/Picture.h"

namespace core::tracking {

/// A camera of this computer.
struct CameraInfo
{
    int number = 0;    ///< N of /dev/videoN
    std::string name;  ///< as reported by its driver
};

/// Returns the cameras that can take pictures now, by number.
[[nodiscard]] std::vector<CameraInfo> cameras();

/// Values requested from a camera, which may choose others. 0 leaves a value to the camera.
struct CameraWish
{
    int width = 1280;
    int height = 720;
    double hz = 30.0;
};

/// A source of pictures: a camera, a video file or a folder of images. One thread at a time.
class PictureSource
{
public:
    PictureSource() = default;
    virtual ~PictureSource() = default;
    PictureSource(const PictureSource&) = delete;
    PictureSource& operator=(const PictureSource&) = delete;

    /// Waits for the next picture. Returns false at the end of a file or folder. Errors: ConnectionLost (a camera
    /// delivers no more pictures), FileTruncated (a video ends long before its time), WrongKind (an unreadable image;
    /// the next call continues with the one after it).
    [[nodiscard]] virtual Result<bool> next(Picture& picture) = 0;
    /// Returns whether pictures arrive in real time. Those of a video and a folder have times of their own.
    [[nodiscard]] virtual bool isLive() const = 0;
};

/// Open a source. Errors: FileMissing (no such camera or file), NotAllowed, Busy (another program uses the camera),
/// WrongKind (not a video, or no image in the folder), FileUnreadable (the part of Cusp that reads pictures is not
/// installed).
[[nodiscard]] Result<std::unique_ptr<PictureSource>> openCamera(int number, const CameraWish& wish);
[[nodiscard]] Result<std::unique_ptr<PictureSource>> openVideo(const std::string& path);
/// Opens a folder of pictures as a source.
/// @param path  of a folder; its images are read in the order of their names
[[nodiscard]] Result<std::unique_ptr<PictureSource>> openFolder(const std::string& path);

}  // namespace core::tracking
