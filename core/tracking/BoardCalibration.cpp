// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/BoardCalibration.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

#include <glm/geometric.hpp>
#include <opencv2/calib3d.hpp>

namespace core::tracking {
namespace {

constexpr double kAlike = 0.02;          ///< mean distance of the corners, as a share of the picture's width
constexpr double kMostUncertain = 0.02;  ///< standard deviation of the focal length, as a share of it
constexpr double kMostErrorPx = 2.0;     ///< in a picture that is kUsualWidth wide
constexpr double kUsualWidth = 1280.0;
constexpr double kHalfPixel = 0.5;  ///< OpenCV places the centre of the first pixel at (0, 0)

tl::unexpected<Error> noFit()
{
    return unexpected(ErrorCode::OutOfRange,
                      "No camera fits these pictures. The board must be flat and the pictures sharp.");
}

}  // namespace

BoardCalibration::Look BoardCalibration::take(const PictureView& picture)
{
    if (!m_views.empty() && (picture.width != m_width || picture.height != m_height))
        return Look::OtherSize;
    // OpenCV only reads the picture, although its type is not const.
    const cv::Mat image(picture.height, picture.width, CV_8UC1, const_cast<std::uint8_t*>(picture.pixels),
                        static_cast<std::size_t>(picture.stride));
    std::vector<cv::Point2f> corners;
    try {
        // The options of this function make it five times slower, or make the corners less exact.
        if (!cv::findChessboardCornersSB(image, {kColumns, kRows}, corners, 0))
            return Look::NoBoard;
    } catch (const cv::Exception&) {
        return Look::NoBoard;
    }
    View view;
    for (const cv::Point2f& corner : corners)
        view.emplace_back(static_cast<double>(corner.x) + kHalfPixel, static_cast<double>(corner.y) + kHalfPixel);
    m_width = picture.width;
    m_height = picture.height;
    if (isAlike(view))
        return Look::Alike;
    if (views() == kMostViews)
        m_views.erase(m_views.begin());
    m_views.push_back(std::move(view));
    return Look::Taken;
}

bool BoardCalibration::isAlike(const View& view) const
{
    return std::any_of(m_views.begin(), m_views.end(), [&](const View& known) {
        double sum = 0.0;
        for (std::size_t n = 0; n < view.size(); ++n)
            sum += glm::distance(view[n], known[n]);
        return sum < kAlike * m_width * static_cast<double>(view.size());
    });
}

Result<BoardCalibration::Found> BoardCalibration::solve() const
{
    if (views() < kLeastViews)
        return unexpected(ErrorCode::BadStructure,
                          "The board was found at " + std::to_string(views()) + " places, and " +
                              std::to_string(kLeastViews) +
                              " are needed. Show the whole board at more places, and tilted to all sides.");
    std::vector<cv::Point3f> board;
    for (int row = 0; row < kRows; ++row)
        for (int column = 0; column < kColumns; ++column)
            board.emplace_back(static_cast<float>(column), static_cast<float>(row), 0.0F);
    const std::vector<std::vector<cv::Point3f>> boards(m_views.size(), board);
    std::vector<std::vector<cv::Point2f>> seen;
    for (const View& view : m_views) {
        auto& corners = seen.emplace_back();
        for (const glm::dvec2& corner : view)
            corners.emplace_back(static_cast<float>(corner.x - kHalfPixel), static_cast<float>(corner.y - kHalfPixel));
    }
    cv::Matx33d matrix = cv::Matx33d::eye();
    cv::Mat lens;
    cv::Mat deviations;
    Found found;
    try {
        std::vector<cv::Mat> rotations;
        std::vector<cv::Mat> translations;
        // A webcam's lens needs no third radial coefficient, which would make the others uncertain.
        found.errorPx = cv::calibrateCamera(boards, seen, {m_width, m_height}, matrix, lens, rotations, translations,
                                            deviations, cv::noArray(), cv::noArray(), cv::CALIB_FIX_K3);
    } catch (const cv::Exception&) {
        return noFit();
    }
    CameraModel& camera = found.camera;
    camera.width = m_width;
    camera.height = m_height;
    camera.focalPx = {matrix(0, 0), matrix(1, 1)};
    camera.centrePx = {matrix(0, 2) + kHalfPixel, matrix(1, 2) + kHalfPixel};
    for (std::size_t n = 0; n < camera.distortion.size(); ++n)
        camera.distortion.at(n) = lens.at<double>(static_cast<int>(n));
    if (!(found.errorPx < kMostErrorPx * std::max(1.0, m_width / kUsualWidth)) || !camera.check())
        return noFit();
    if (!(deviations.at<double>(0) < kMostUncertain * camera.focalPx.x))
        return unexpected(
            ErrorCode::BadStructure,
            "The focal length stays uncertain. Show the board tilted by 30 degrees and more, to all sides.");
    return found;
}

}  // namespace core::tracking
