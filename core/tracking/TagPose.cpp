// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/TagPose.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <opencv2/calib3d.hpp>

namespace core::tracking {
namespace {

constexpr double kNearestMm = 10.0;

/// Returns the corners of a tag in its own frame, in the order of SeenTag::cornersPx.
std::array<glm::dvec3, 4> cornersMm(double edgeMm)
{
    const double half = 0.5 * edgeMm;
    return {glm::dvec3(-half, half, 0.0), {half, half, 0.0}, {half, -half, 0.0}, {-half, -half, 0.0}};
}

double errorPx(const Pose& pose, const SeenTag& tag, const CameraModel& camera, double edgeMm)
{
    const auto corners = cornersMm(edgeMm);
    double sum = 0.0;
    for (std::size_t n = 0; n < corners.size(); ++n) {
        const glm::dvec2 apart = camera.pixelOf(pose.positionMm + pose.rotation * corners[n]) - tag.cornersPx[n];
        sum += glm::dot(apart, apart);
    }
    return std::sqrt(sum / static_cast<double>(corners.size()));
}

/// Converts a pose. Our frame has y down and z into the tag, that of OpenCV's square has y up and z out of the tag.
Pose poseFrom(const cv::Mat& rotationVector, const cv::Mat& translation)
{
    cv::Matx33d turn;
    cv::Rodrigues(rotationVector, turn);
    Pose pose;
    for (int row = 0; row < 3; ++row) {
        pose.positionMm[row] = translation.at<double>(row);
        for (int column = 0; column < 3; ++column)
            pose.rotation[column][row] = column == 0 ? turn(row, column) : -turn(row, column);
    }
    return pose;
}

bool isSound(const Pose& pose)
{
    return std::isfinite(pose.positionMm.x) && std::isfinite(pose.positionMm.y) && pose.positionMm.z > kNearestMm &&
           glm::determinant(pose.rotation) > 0.0;
}

}  // namespace

std::optional<PosedTag> poseOf(const SeenTag& tag, const CameraModel& camera, double edgeMm)
{
    const double half = 0.5 * edgeMm;
    const std::array<cv::Point3d, 4> square{
        {{-half, half, 0.0}, {half, half, 0.0}, {half, -half, 0.0}, {-half, -half, 0.0}}};
    std::array<cv::Point2d, 4> seen;  // the order of IPPE_SQUARE: upper left, upper right, lower right, lower left
    for (std::size_t n = 0; n < seen.size(); ++n) {
        const glm::dvec2 at = camera.directionOf(tag.cornersPx[seen.size() - 1 - n]);
        seen[n] = {at.x, at.y};
    }
    std::vector<Pose> poses;
    try {
        std::vector<cv::Mat> rotations;
        std::vector<cv::Mat> translations;
        cv::solvePnPGeneric(square, seen, cv::Matx33d::eye(), cv::noArray(), rotations, translations, false,
                            cv::SOLVEPNP_IPPE_SQUARE);
        for (std::size_t n = 0; n < rotations.size(); ++n)
            if (const Pose pose = poseFrom(rotations[n], translations[n]); isSound(pose))
                poses.push_back(pose);
    } catch (const cv::Exception&) {
        return std::nullopt;
    }
    if (poses.empty())
        return std::nullopt;
    PosedTag posed;
    posed.tag = tag;
    posed.pose = poses.front();
    posed.other = poses.back();
    posed.reprojectionPx = errorPx(posed.pose, tag, camera, edgeMm);
    posed.otherPx = errorPx(posed.other, tag, camera, edgeMm);
    if (posed.otherPx < posed.reprojectionPx) {
        std::swap(posed.pose, posed.other);
        std::swap(posed.reprojectionPx, posed.otherPx);
    }
    return posed;
}

}  // namespace core::tracking
