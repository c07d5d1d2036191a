// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/PictureWatch.h"

#include <algorithm>
#include <cstddef>

namespace core::tracking {
namespace {

constexpr int kSamplesASide = 64;
constexpr int kDarkMean = 8;  ///< in grey levels
constexpr int kBrightMean = 240;
constexpr int kTroubleAfter = 30;  ///< pictures in a row: a second. Even a dark room gives no two equal pictures

}  // namespace

PictureTrouble PictureWatch::take(const PictureView& picture)
{
    // FNV-1a over a grid of pixels.
    std::uint64_t digest = 14695981039346656037ULL;
    std::uint64_t sum = 0;
    std::uint64_t count = 0;
    const int stepX = std::max(1, picture.width / kSamplesASide);
    const int stepY = std::max(1, picture.height / kSamplesASide);
    for (int y = stepY / 2; y < picture.height; y += stepY)
        for (int x = stepX / 2; x < picture.width; x += stepX) {
            const std::uint8_t level = picture.pixels[static_cast<std::ptrdiff_t>(y) * picture.stride + x];
            digest = (digest ^ level) * 1099511628211ULL;
            sum += level;
            ++count;
        }
    m_same = digest == m_last ? m_same + 1 : 0;
    m_last = digest;
    m_dark = sum < kDarkMean * count ? m_dark + 1 : 0;
    m_bright = sum > kBrightMean * count ? m_bright + 1 : 0;
    if (m_dark >= kTroubleAfter)
        return PictureTrouble::Dark;
    if (m_bright >= kTroubleAfter)
        return PictureTrouble::Bright;
    return m_same >= kTroubleAfter ? PictureTrouble::Frozen : PictureTrouble::None;
}

}  // namespace core::tracking
