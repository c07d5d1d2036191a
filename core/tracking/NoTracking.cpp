// SPDX-License-Identifier: GPL-3.0-or-later
// Replaces BoardCalibration.cpp, TagCells.cpp, TagDetector.cpp and TagPose.cpp in a program built without AprilTag or
// OpenCV.
#include "core/tracking/BoardCalibration.h"
#include "core/tracking/TagCells.h"
#include "core/tracking/TagDetector.h"
#include "core/tracking/TagPose.h"

namespace core::tracking {

struct TagDetector::Parts
{};

bool hasTagDetector() noexcept
{
    return false;
}

TagCells cellsOf(int /*id*/)
{
    TagCells cells;
    cells.fill(true);
    return cells;
}

TagDetector::TagDetector(std::optional<int> id) : m_id(id) {}

TagDetector::~TagDetector() = default;

std::vector<SeenTag> TagDetector::find(const PictureView& /*picture*/, const Region& /*region*/,
                                       const Effort& /*effort*/)
{
    return {};
}

std::optional<PosedTag> poseOf(const SeenTag& /*tag*/, const CameraModel& /*camera*/, double /*edgeMm*/)
{
    return std::nullopt;
}

BoardCalibration::Look BoardCalibration::take(const PictureView& /*picture*/)
{
    return Look::NoBoard;
}

Result<BoardCalibration::Found> BoardCalibration::solve() const
{
    return unexpected(ErrorCode::BadStructure, "This program was built without head tracking.");
}

}  // namespace core::tracking
