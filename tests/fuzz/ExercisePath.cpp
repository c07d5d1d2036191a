// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/Exercises.h"

#include <cmath>

#include "core/recording/DevicePath.h"

namespace fuzz {
namespace {

using namespace core::recording;

bool isNear(const glm::dvec3& tip)
{
    return std::abs(tip.x) <= kMaxPathMm && std::abs(tip.y) <= kMaxPathMm && std::abs(tip.z) <= kMaxPathMm;
}

}  // namespace

void exercisePath(std::string_view bytes)
{
    for (const bool needDrill : {true, false}) {
        const auto path = parseDevicePath(bytes, needDrill);
        if (!path) {
            promise(!path.error().detail.empty() && path.error().detail.find('\n') == std::string::npos);
            continue;
        }
        promise(!path->points.empty());
        for (std::size_t k = 0; k < path->points.size(); ++k) {
            promise(isNear(path->points[k].tipMm));
            promise(k == 0 || path->points[k].timeS > path->points[k - 1].timeS);
        }
        PathCursor cursor(*path);
        const std::uint64_t ticks = path->ticks(1000.0);
        promise(ticks >= 1 && ticks <= 86'400'001);
        for (int n = 0; n <= 100; ++n)
            promise(isNear(cursor.at(path->durationS() * n / 100.0).tipMm));
    }
}

}  // namespace fuzz
