// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/tracking/CameraModel.h"
#include "core/tracking/TagDetector.h"
#include "core/tracking/TagPose.h"

namespace core::tracking {

struct TrackerSettings
{
    /// Id of the tag on the head. Empty: all tags are reported, and each picture is searched whole.
    std::optional<int> id = 0;
    double tagMm = 50.0;                        ///< edge of its black square
    double fovDeg = CameraModel::kUsualFovDeg;  ///< horizontal field of view, used without a calibration
    std::optional<CameraModel> calibration;
    bool refinesEdges = true;
    bool usesRegion = true;    ///< searches around the last place of the tag first
    bool isThorough = false;   ///< each whole picture is also searched for small tags; otherwise one in three
    int searchDecimation = 3;  ///< of a whole picture
    int regionDecimation = 2;  ///< around the tag
};

/// Checks the settings. Error OutOfRange with one sentence.
[[nodiscard]] Status check(const TrackerSettings& settings);

/// The tags in one picture, and the time that finding them took.
struct TagFrame
{
    /// With a searched id: the followed tag first. With all ids: the largest first.
    std::vector<PosedTag> tags;
    int sameTags = 0;      ///< number of tags with the searched id, when a whole picture was last searched
    bool isWhole = false;  ///< the whole picture was searched
    double findMs = 0.0;
    double poseMs = 0.0;
};

/// Finds the tag on the head in successive pictures: around its last place, and in the whole picture if it is not
/// there. Regularly searches a whole picture anyway, for a second tag with the same number. One thread at a time.
class TagTracker
{
public:
    /// @param settings  valid, see check()
    explicit TagTracker(const TrackerSettings& settings);

    /// Searches a picture. Error OutOfRange if the calibration is for pictures of another size.
    [[nodiscard]] Result<TagFrame> look(const PictureView& picture);
    /// Returns the camera used for poses; for pictures of another size the next look() creates another.
    [[nodiscard]] const CameraModel& camera() const { return m_camera; }

private:
    void sortTags(std::vector<SeenTag>& tags) const;
    [[nodiscard]] std::vector<SeenTag> search(const PictureView& picture);
    [[nodiscard]] std::vector<SeenTag> searchRegion(const PictureView& picture, const SeenTag& last);

    TrackerSettings m_settings;
    TagDetector m_detector;
    CameraModel m_camera;
    std::optional<SeenTag> m_last;  ///< in the picture before
    int m_searches = 0;             ///< number of whole pictures searched without a tag, in a row
    int m_followed = 0;             ///< number of pictures since a whole one was searched
    int m_sameTags = 0;
};

}  // namespace core::tracking
