// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/falcon/CalibrationSteps.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/geometric.hpp>

#include "haptics/falcon/Kinematics.h"

namespace haptics::falcon {
namespace {

using core::ErrorCode;

constexpr double kLowestRad = 15.0 * std::numbers::pi / 180.0;
constexpr double kHighestRad = 55.0 * std::numbers::pi / 180.0;
constexpr int kLooks = 400;  ///< angles tried, a tenth of a degree apart
constexpr double kNearEnoughMm = 0.3;

}  // namespace

core::Result<Calibration> withDistance(const Calibration& calibration, const glm::dvec3& nearMm,
                                       const glm::dvec3& farMm, double distanceMm)
{
    const auto nearArms = armsAt(nearMm, calibration.geometry);
    const auto farArms = armsAt(farMm, calibration.geometry);
    std::optional<Calibration> best;
    double bestErrorMm = kNearEnoughMm;
    for (int look = 0; nearArms && farArms && look <= kLooks; ++look) {
        const double homeRad = kLowestRad + (kHighestRad - kLowestRad) * look / kLooks;
        Calibration tried = calibration;
        tried.homeRad = glm::dvec3(homeRad);
        const glm::dvec3 turned = tried.homeRad - calibration.homeRad;
        const auto from = gripAt(nearArms->angleRad + turned, nearMm, calibration.geometry);
        const auto to = gripAt(farArms->angleRad + turned, farMm, calibration.geometry);
        const double errorMm = from && to ? std::abs(glm::distance(*from, *to) - distanceMm) : bestErrorMm;
        if (errorMm < bestErrorMm) {
            bestErrorMm = errorMm;
            best = tried;
        }
    }
    if (!best)
        return core::unexpected(ErrorCode::OutOfRange,
                                "No angle at the index marks explains this distance. Measure it again.");
    return *best;
}

core::Result<Calibration> withWeight(const Calibration& calibration, double emptyN, double loadedN, double weightN)
{
    const double share = (loadedN - emptyN) / weightN;
    Calibration found = calibration;
    found.commandPerNm = calibration.commandPerNm * share;
    found.gripWeightN = std::max(0.0, emptyN / share);
    if (!(weightN > 0.0) || !std::isfinite(share) || !check(found))
        return core::unexpected(ErrorCode::OutOfRange,
                                "The forces with and without the weight do not fit together. Try again, with the "
                                "grip at rest and the weight hanging freely.");
    return found;
}

}  // namespace haptics::falcon
