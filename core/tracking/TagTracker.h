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
    /// Of the tag on the head. Empty: all tags are reported, and each picture is searched whole.
    std::optional<int> id = 0;
    double tagMm = 50.0;                        ///< edge of its black square
    double fovDeg = CameraModel::kUsualFovDeg;  ///< horizontal field of view, if there is no calibration
    std::optional<CameraModel> calibration;
    bool refinesEdges = true;
    bool usesRegion = true;    ///< looks first where the tag was
    bool isThorough = false;   ///< each whole picture is searched for small tags too; else one of three is
    int searchDecimation = 3;  ///< of a whole picture
    int regionDecimation = 2;  ///< around the tag
};

/// Errors: OutOfRange with one sentence.
[[nodiscard]] Status check(const TrackerSettings& settings);

/// What one picture shows, and what finding it cost.
struct TagFrame
{
    /// Of the searched id: the one that is followed is first. Of all ids: the largest.
    std::vector<PosedTag> tags;
    int sameTags = 0;      ///< with the searched id, when a whole picture was searched last
    bool isWhole = false;  ///< the whole picture was searched
    double findMs = 0.0;
    double poseMs = 0.0;
};

/// Finds the tag on the head in picture after picture: around its last place, and in the whole picture if it is not
/// there. Now and then a whole picture is searched anyway, for a second tag with the same number. One thread at a time.
class TagTracker
{
public:
    /// @param settings  valid, see check()
    explicit TagTracker(const TrackerSettings& settings);

    /// Errors: OutOfRange if the calibration is for pictures of another size.
    [[nodiscard]] Result<TagFrame> look(const PictureView& picture);
    /// The camera that poses are computed with; for pictures of another size the next look() makes another.
    [[nodiscard]] const CameraModel& camera() const { return m_camera; }

private:
    void sortTags(std::vector<SeenTag>& tags) const;
    [[nodiscard]] std::vector<SeenTag> search(const PictureView& picture);
    [[nodiscard]] std::vector<SeenTag> searchRegion(const PictureView& picture, const SeenTag& last);

    TrackerSettings m_settings;
    TagDetector m_detector;
    CameraModel m_camera;
    std::optional<SeenTag> m_last;  ///< in the picture before
    int m_searches = 0;             ///< of whole pictures without a tag, in a row
    int m_followed = 0;             ///< pictures since a whole one was searched
    int m_sameTags = 0;
};

}  // namespace core::tracking
