// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace core::tracking {

/// View of a grey picture, whose pixels another object owns. Rows are stored from the top, `stride` bytes apart.
struct PictureView
{
    const std::uint8_t* pixels = nullptr;
    int width = 0;
    int height = 0;
    int stride = 0;
};

/// Grey picture of a camera, with the time at which it was taken.
struct Picture
{
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> pixels;  ///< width * height
    double timeS = 0.0;                ///< of a camera: std::chrono::steady_clock; of a video: from its start
    std::string name;                  ///< of the file; empty for a camera

    [[nodiscard]] PictureView view() const { return {pixels.data(), width, height, width}; }
};

}  // namespace core::tracking
