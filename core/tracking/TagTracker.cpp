// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/TagTracker.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace core::tracking {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kGrowth = 0.6;  ///< growth of the region on every side, as a share of the tag's size
constexpr int kWholeEvery = 30;  ///< every so many pictures, the whole picture is searched although the tag is followed
constexpr int kFineEvery = 3;    ///< every so many searches also look for small tags
constexpr int kFineDecimation = 2;
constexpr int kAllEvery = 9;           ///< every so many searches use every pixel, for a small tag tilted by 45 degrees
constexpr double kSmallEdgePx = 80.0;  ///< smaller tags are followed with every pixel, which halves the noise of depth
constexpr int kAllDecimation = 1;
constexpr int kTilePx = 4;  ///< AprilTag computes the local contrast in squares of this many searched pixels

double msSince(Clock::time_point begun)
{
    return std::chrono::duration<double, std::milli>(Clock::now() - begun).count();
}

}  // namespace

Status check(const TrackerSettings& settings)
{
    if (settings.id && (*settings.id < 0 || *settings.id >= kTagCount))
        return unexpected(ErrorCode::OutOfRange, "The number of a tag must be 0 to 586.");
    if (!(settings.tagMm >= 5.0 && settings.tagMm <= 1000.0))
        return unexpected(ErrorCode::OutOfRange, "The edge of a tag must be 5 to 1000 mm.");
    if (!(settings.fovDeg >= 10.0 && settings.fovDeg <= 150.0))
        return unexpected(ErrorCode::OutOfRange, "The field of view must be 10 to 150 degrees.");
    return settings.calibration ? settings.calibration->check() : Status{};
}

TagTracker::TagTracker(const TrackerSettings& settings) : m_settings(settings), m_detector(settings.id)
{
    if (settings.calibration)
        m_camera = *settings.calibration;
}

Result<TagFrame> TagTracker::look(const PictureView& picture)
{
    if (picture.width != m_camera.width || picture.height != m_camera.height) {
        if (m_settings.calibration)
            return unexpected(
                ErrorCode::OutOfRange,
                LocalizableText{"The calibration is for pictures of %1 x %2 pixels, and these have %3 x %4. Calibrate "
                                "the camera at this size.",
                                {noted(std::to_string(m_camera.width)), noted(std::to_string(m_camera.height)),
                                 noted(std::to_string(picture.width)), noted(std::to_string(picture.height))}});
        m_camera = CameraModel::withFieldOfView(picture.width, picture.height, m_settings.fovDeg);
        m_last.reset();
    }
    TagFrame frame;
    const auto begun = Clock::now();
    std::vector<SeenTag> seen;
    const bool follows = m_settings.usesRegion && m_settings.id && m_last;
    if (follows && ++m_followed < kWholeEvery)
        seen = searchRegion(picture, *m_last);
    if (seen.empty()) {
        frame.isWhole = true;
        m_followed = 0;
        seen = search(picture);
        m_sameTags = static_cast<int>(seen.size());
        if (seen.empty() && follows)
            seen = searchRegion(picture, *m_last);  // small tags are not found in a whole picture
    }
    m_sameTags = std::max(m_sameTags, seen.empty() ? 0 : 1);
    frame.sameTags = m_sameTags;
    sortTags(seen);
    frame.findMs = msSince(begun);
    m_last.reset();
    if (!seen.empty()) {
        m_searches = 0;
        m_last = seen.front();
    }
    const auto found = Clock::now();
    for (const SeenTag& tag : seen)
        if (const auto posed = poseOf(tag, m_camera, m_settings.tagMm))
            frame.tags.push_back(*posed);
    frame.poseMs = msSince(found);
    return frame;
}

/// Sorts the tags by their distance from the last one. Without a last one, or if all ids are searched, sorts them by
/// size, largest first.
void TagTracker::sortTags(std::vector<SeenTag>& tags) const
{
    if (m_last && m_settings.id)
        std::sort(tags.begin(), tags.end(), [at = m_last->centrePx()](const SeenTag& a, const SeenTag& b) {
            return glm::distance(a.centrePx(), at) < glm::distance(b.centrePx(), at);
        });
    else
        std::sort(tags.begin(), tags.end(), [](const SeenTag& a, const SeenTag& b) { return a.edgePx() > b.edgePx(); });
}

std::vector<SeenTag> TagTracker::search(const PictureView& picture)
{
    if (!m_settings.id)
        return m_detector.find(picture, {kAllDecimation, m_settings.refinesEdges});
    auto seen = m_detector.find(picture, {m_settings.searchDecimation, m_settings.refinesEdges});
    if (!seen.empty())
        return seen;
    ++m_searches;
    const bool usesAll = m_settings.isThorough || m_searches % kAllEvery == 0;
    const int fine = usesAll ? kAllDecimation : kFineDecimation;
    if (fine < m_settings.searchDecimation && (usesAll || m_searches % kFineEvery == 0))
        seen = m_detector.find(picture, {fine, m_settings.refinesEdges});
    return seen;
}

std::vector<SeenTag> TagTracker::searchRegion(const PictureView& picture, const SeenTag& last)
{
    glm::dvec2 low = last.cornersPx[0];
    glm::dvec2 high = low;
    for (const glm::dvec2& corner : last.cornersPx) {
        low = glm::min(low, corner);
        high = glm::max(high, corner);
    }
    const glm::dvec2 margin = (high - low) * kGrowth;  // the white border and a little more
    low -= margin;
    high += margin;
    const int decimation = last.edgePx() < kSmallEdgePx ? 1 : m_settings.regionDecimation;
    // If a region began elsewhere, it would be sampled at other pixels, and the corners would move a little.
    const int step = kTilePx * decimation;
    const glm::ivec2 first = glm::ivec2(glm::floor(glm::max(low, 0.0) / static_cast<double>(step))) * step;
    const TagDetector::Region region{first.x, first.y, static_cast<int>(std::ceil(high.x)) - first.x,
                                     static_cast<int>(std::ceil(high.y)) - first.y};
    return m_detector.find(picture, region, {decimation, m_settings.refinesEdges});
}

}  // namespace core::tracking
