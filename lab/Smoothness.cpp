// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/Smoothness.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <glm/geometric.hpp>

namespace lab {
namespace {

constexpr double kBeatS = 0.001;
constexpr double kDownMm = 1.0;
constexpr double kDownMmPerS = 5.0;
constexpr int kRestTicks = 200;  ///< before the hand starts

}  // namespace

core::Result<std::vector<ForceChange>> forceChanges(const std::shared_ptr<const core::terrain::ToothAnatomy>& anatomy,
                                                    double yMm, const core::servo::ServoSettings& settings)
{
    auto made = core::servo::makeServoTick(settings);
    if (!made)
        return tl::unexpected(made.error());
    core::servo::ServoTick& servo = **made;
    core::contact::LiveTooth uncut{core::terrain::Tooth(anatomy)};
    uncut.selectBur(kSmoothnessBur);
    core::contact::LiveTooth tooth{core::terrain::Tooth(anatomy)};
    servo.setBur(kSmoothnessBur);
    servo.swapTooth(&tooth, true);

    glm::dvec3 hand(0.0);
    const auto step = [&](double xMm, double aboveMm) {
        const double height = uncut.touchAt({xMm, yMm}, 1.0e9, core::contact::Edges::Sides).heightMm;
        const glm::vec3 tip(xMm, yMm, height - kSmoothnessDepthMm + aboveMm);
        hand = glm::dvec3(tip);
        servo.step(&tip, std::chrono::milliseconds(1));
    };
    const auto spring = [&] { return servo.state().anchorMm - hand; };
    for (double above = kDownMm; above > 0.0; above -= kDownMmPerS * kBeatS)
        step(-kSmoothnessReachMm, above);
    for (int tick = 0; tick < kRestTicks; ++tick)
        step(-kSmoothnessReachMm, 0.0);

    const double nPerMm = settings.force.stiffnessNPerMm;
    std::vector<ForceChange> changes;
    const int ticks = static_cast<int>(std::lround(2.0 * kSmoothnessReachMm / (kSmoothnessMmPerS * kBeatS)));
    for (int tick = 1; tick <= ticks; ++tick) {
        const glm::dvec3 forceN = servo.state().forceN;
        const glm::dvec3 stretch = spring();
        const double x = -kSmoothnessReachMm + kSmoothnessMmPerS * kBeatS * tick;
        step(x, 0.0);
        changes.push_back({x, glm::length(servo.state().forceN - forceN) / nPerMm, glm::length(spring() - stretch)});
    }
    return changes;
}

double percentile99(std::vector<double> values)
{
    if (values.empty())
        return 0.0;
    const auto place = values.begin() + static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), place, values.end());
    return *place;
}

}  // namespace lab
