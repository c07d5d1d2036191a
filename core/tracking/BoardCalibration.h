// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <glm/vec2.hpp>

#include "core/base/Result.h"
#include "core/tracking/CameraModel.h"
#include "core/tracking/Picture.h"

namespace core::tracking {

/// Computes the focal length and the distortion of a camera from pictures of a chessboard with 10 x 7 squares (Zhang
/// 2000, "A flexible new technique for camera calibration", by OpenCV). The size of the squares does not matter.
/// One thread at a time.
class BoardCalibration
{
public:
    static constexpr int kColumns = 9;  ///< of inner corners
    static constexpr int kRows = 6;
    static constexpr int kLeastViews = 6;
    static constexpr int kMostViews = 25;

    enum class Look {
        Taken,
        NoBoard,
        Alike,      ///< the board is in the same place as in an earlier picture
        OtherSize,  ///< than the pictures before
    };
    /// Searches for the board. Takes a fifth of a second or more.
    Look take(const PictureView& picture);
    /// Returns the number of pictures used.
    [[nodiscard]] int views() const { return static_cast<int>(m_views.size()); }

    struct Found
    {
        CameraModel camera;
        double errorPx = 0.0;  ///< root mean square distance of the corners from their computed places
    };
    /// Computes the camera. Errors: BadStructure (fewer than kLeastViews pictures, or the board is tilted too little in
    /// them), OutOfRange (no camera fits the pictures).
    [[nodiscard]] Result<Found> solve() const;

private:
    using View =
        std::vector<glm::dvec2>;  ///< inner corners, row by row; the centre of the first pixel is at (0.5, 0.5)

    [[nodiscard]] bool isAlike(const View& view) const;

    std::vector<View> m_views;
    int m_width = 0;
    int m_height = 0;
};

}  // namespace core::tracking
