// SPDX-License-Identifier: GPL-3.0-or-later
// The library cusp_pictures: cameras, videos and images with OpenCV.
#include <array>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <memory>
#include <new>
#include <string>
#include <string_view>

#include <opencv2/core/utils/logger.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>

#include "core/tracking/PictureLibrary.h"

namespace core::tracking::pictures {
namespace {

constexpr int kLargestPx = 16384;

/// Converts an image in grey or colour to a grey picture. Returns false if there is no image.
bool take(const cv::Mat& image, Picture& picture)
{
    if (image.empty() || image.depth() != CV_8U || image.cols > kLargestPx || image.rows > kLargestPx)
        return false;
    picture.width = image.cols;
    picture.height = image.rows;
    picture.pixels.resize(static_cast<std::size_t>(image.cols) * static_cast<std::size_t>(image.rows));
    cv::Mat grey(image.rows, image.cols, CV_8UC1, picture.pixels.data());
    switch (image.channels()) {
    case 1:
        image.copyTo(grey);
        return true;
    case 3:
        cv::cvtColor(image, grey, cv::COLOR_BGR2GRAY);
        return true;
    case 4:
        cv::cvtColor(image, grey, cv::COLOR_BGRA2GRAY);
        return true;
    default:
        return false;
    }
}

class VideoReader final : public PictureReader
{
public:
    VideoReader(const cv::VideoCapture& capture, bool isCamera) : m_capture(capture), m_isCamera(isCamera) {}

    bool read(Picture& picture) override
    {
        try {
            if (!m_capture.grab())
                return false;
            picture.timeS = m_isCamera ? now() : m_capture.get(cv::CAP_PROP_POS_MSEC) / 1000.0;
            return m_capture.retrieve(m_image) && take(m_image, picture);
        } catch (const std::exception&) {
            return false;
        }
    }

    Length length() const override
    {
        if (m_isCamera)
            return {};
        const double hz = m_capture.get(cv::CAP_PROP_FPS);
        const double pictures = m_capture.get(cv::CAP_PROP_FRAME_COUNT);
        return {hz > 0.0 ? pictures / hz : 0.0, pictures};
    }

private:
    static double now()
    {
        return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
    }

    cv::VideoCapture m_capture;
    cv::Mat m_image;
    bool m_isCamera;
};

PictureReader* openCamera(int number, int width, int height, double hz)
{
    try {
        cv::VideoCapture capture(number, cv::CAP_V4L2);
        if (!capture.isOpened())
            return nullptr;
        // Most cameras deliver only a few uncompressed pictures per second at this size.
        capture.set(cv::CAP_PROP_FOURCC, cv::VideoWriter::fourcc('M', 'J', 'P', 'G'));
        if (width > 0 && height > 0) {
            capture.set(cv::CAP_PROP_FRAME_WIDTH, width);
            capture.set(cv::CAP_PROP_FRAME_HEIGHT, height);
        }
        if (hz > 0.0)
            capture.set(cv::CAP_PROP_FPS, hz);
        capture.set(cv::CAP_PROP_BUFFERSIZE, 1);  // returns the newest picture instead of the oldest of a queue
        return new VideoReader(capture, true);
    } catch (const std::exception&) {
        return nullptr;
    }
}

PictureReader* openVideo(const char* path)
{
    try {
        cv::VideoCapture capture(path, cv::CAP_ANY);
        return capture.isOpened() ? new VideoReader(capture, false) : nullptr;
    } catch (const std::exception&) {
        return nullptr;
    }
}

/// Returns whether a file is a JPEG without its end. OpenCV would fill the missing lower part with grey.
bool isCutOffJpeg(const char* path)
{
    std::ifstream file(path, std::ios::binary);
    std::array<char, 4> head{};
    constexpr std::string_view kStart = "\xFF\xD8";
    if (!file.read(head.data(), 2) || std::string_view(head.data(), 2) != kStart)
        return false;
    // Skips segments by their lengths, up to the first scan, because a thumbnail in one of them has its own end.
    constexpr char kScan = '\xDA';
    while (file.read(head.data(), 4) && head[1] != kScan) {
        const int length = 256 * static_cast<std::uint8_t>(head[2]) + static_cast<std::uint8_t>(head[3]);
        file.seekg(length - 2, std::ios::cur);
    }
    const std::string scans{std::istreambuf_iterator<char>(file), {}};
    return scans.find("\xFF\xD9") == std::string::npos;
}

bool readImage(const char* path, Picture& picture)
{
    try {
        if (isCutOffJpeg(path))
            return false;
        picture.timeS = 0.0;
        return take(cv::imread(path, cv::IMREAD_GRAYSCALE), picture);
    } catch (const std::exception&) {
        return false;
    }
}

constexpr PictureLibrary kLibrary{&openCamera, &openVideo, &readImage};

}  // namespace
}  // namespace core::tracking::pictures

extern "C" __attribute__((visibility("default"))) const core::tracking::PictureLibrary* cuspPictures()
{
    // Cusp reports errors itself.
    setenv("OPENCV_FFMPEG_LOGLEVEL", "-8", 0);
    setenv("OPENCV_VIDEOIO_V4L_SELECT_TIMEOUT", "2", 0);  // timeout in seconds, for a camera that sends nothing
    cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
    std::cerr.setstate(std::ios::badbit);  // hides OpenCV's messages; Cusp itself does not use std::cerr
    cv::setNumThreads(1);
    return &core::tracking::pictures::kLibrary;
}
