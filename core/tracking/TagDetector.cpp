// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/TagDetector.h"

#include <algorithm>
#include <cmath>

#include <apriltag/apriltag.h>
#include <apriltag/tag36h11.h>

namespace core::tracking {
namespace {

constexpr double kSharpening = 0.25;   ///< AprilTag's own default
constexpr double kLeastMargin = 30.0;  ///< tags on photographs have 43 or more, false detections less
constexpr int kLeastSidePx = 16;
/// Least distance of a corner from the border, as a share of the tag's edge; the white border is an eighth wide. If a
/// corner of the square is cut off, the detector finds it some pixels away from its true position.
constexpr double kLeastFromBorder = 0.08;
/// Bits that may be corrected: AprilTag's default for all ids. For a single id, one bit is enough, and needs one
/// megabyte instead of nineteen.
constexpr int kCorrectedOfAll = 2;
constexpr int kCorrectedOfOne = 1;

bool isWhole(const apriltag_detection_t& found, int width, int height)
{
    double edges = 0.0;
    double border = width;
    for (std::size_t n = 0; n < 4; ++n) {
        const double* const corner = found.p[n];
        const double* const next = found.p[(n + 1) % 4];
        edges += std::hypot(next[0] - corner[0], next[1] - corner[1]);
        border = std::min({border, corner[0], corner[1], width - corner[0], height - corner[1]});
    }
    return border >= kLeastFromBorder * 0.25 * edges;
}

}  // namespace

struct TagDetector::Parts
{
    apriltag_family_t* family = tag36h11_create();
    apriltag_detector_t* detector = apriltag_detector_create();

    explicit Parts(int correctedBits)
    {
        apriltag_detector_add_family_bits(detector, family, correctedBits);
        detector->nthreads = 1;  // with several, its union-find has a data race
        detector->quad_sigma = 0.0F;
        detector->decode_sharpening = kSharpening;
    }
    ~Parts()
    {
        apriltag_detector_destroy(detector);
        tag36h11_destroy(family);
    }
    Parts(const Parts&) = delete;
    Parts& operator=(const Parts&) = delete;
};

bool hasTagDetector() noexcept
{
    return true;
}

TagDetector::TagDetector(std::optional<int> id)
    : m_parts(std::make_unique<Parts>(id ? kCorrectedOfOne : kCorrectedOfAll)), m_id(id)
{}

TagDetector::~TagDetector() = default;

std::vector<SeenTag> TagDetector::find(const PictureView& picture, const Region& region, const Effort& effort)
{
    const int left = std::clamp(region.x, 0, picture.width);
    const int top = std::clamp(region.y, 0, picture.height);
    const int width = std::clamp(region.x + region.width, left, picture.width) - left;
    const int height = std::clamp(region.y + region.height, top, picture.height) - top;
    const int decimation = std::max(1, effort.decimation);
    if (width < kLeastSidePx * decimation || height < kLeastSidePx * decimation)
        return {};
    apriltag_detector_t& detector = *m_parts->detector;
    detector.quad_decimate = static_cast<float>(decimation);
    detector.refine_edges = effort.refinesEdges;
    // AprilTag only reads the picture, although its type is not const.
    auto* const first =
        const_cast<std::uint8_t*>(picture.pixels) + static_cast<std::ptrdiff_t>(top) * picture.stride + left;
    image_u8_t image{width, height, picture.stride, first};
    zarray_t* const found = apriltag_detector_detect(&detector, &image);
    std::vector<SeenTag> tags;
    for (int n = 0; n < zarray_size(found); ++n) {
        const apriltag_detection_t* one = nullptr;
        zarray_get(found, n, &one);
        if ((m_id && one->id != *m_id) || one->decision_margin < kLeastMargin || !isWhole(*one, width, height))
            continue;
        SeenTag tag;
        tag.id = one->id;
        tag.correctedBits = one->hamming;
        tag.margin = static_cast<double>(one->decision_margin);
        for (std::size_t corner = 0; corner < tag.cornersPx.size(); ++corner)
            tag.cornersPx[corner] = {one->p[corner][0] + left, one->p[corner][1] + top};
        tags.push_back(tag);
    }
    apriltag_detections_destroy(found);
    return tags;
}

}  // namespace core::tracking
