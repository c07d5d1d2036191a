// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/StiffnessLimit.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <glm/common.hpp>

#include "lab/Block.h"

namespace lab {
namespace {

constexpr double kStride = 1.2;
constexpr double kPrecision = 1.02;
constexpr double kHeightMm = 2.0;
constexpr double kThrowMmPerS = 50.0;
constexpr double kPushN = 2.0;
constexpr double kTrialS = 2.0;
constexpr double kWatchedS = 0.5;
constexpr double kRestMm = 0.15;

/// One trial: does the grip come to rest? Settings must have been checked.
bool comesToRest(core::contact::LiveTooth& tooth, const ClosedLoop& loop)
{
    const auto servo = *core::session::makeServoTick(loop.settings);
    servo->swapTooth(&tooth, true);
    haptics::HandFigures hand = loop.hand;
    hand.tremorMm = 0.0;
    hand.driftMm = 0.0;
    haptics::SimulatedFalcon falcon(loop.falcon, hand, 1.0 / loop.rateHz, 1, {0.0, 0.0, kHeightMm});
    falcon.follow({0.0, 0.0, -1000.0 * kPushN / hand.stiffnessNPerM});
    falcon.push({0.0, 0.0, -kThrowMmPerS});
    const std::chrono::microseconds period(std::llround(1.0e6 / loop.rateHz));
    glm::dvec3 low(1.0e9);
    glm::dvec3 high(-1.0e9);
    const auto ticks = static_cast<int>(kTrialS * loop.rateHz);
    const auto unwatched = static_cast<int>((kTrialS - kWatchedS) * loop.rateHz);
    for (int tick = 0; tick < ticks; ++tick) {
        const haptics::DeviceSample sample = falcon.exchange(servo->state().forceN);
        servo->step(&sample.tipInToothMm, period);
        if (tick >= unwatched) {
            low = glm::min(low, falcon.tipMm());
            high = glm::max(high, falcon.tipMm());
        }
    }
    return glm::all(glm::lessThan(high - low, glm::dvec3(kRestMm)));
}

}  // namespace

core::Result<double> stiffnessLimit(const ClosedLoop& loop)
{
    if (const auto sound = core::session::makeServoTick(loop.settings); !sound)
        return tl::unexpected(sound.error());
    core::contact::LiveTooth tooth{core::terrain::Tooth(enamelBlock([](glm::dvec2) { return 0.0; }))};
    ClosedLoop tried = loop;
    const auto holdsAt = [&](double nPerMm) {
        tried.settings.force.stiffnessNPerMm = nPerMm;
        return comesToRest(tooth, tried);
    };
    // Upwards first: the lattice method comes to rest again at stiffnesses far above the first that fails.
    double holds = 0.0;
    double fails = kSoftestNPerMm;
    while (holdsAt(fails)) {
        if (fails >= kStiffestNPerMm)
            return kStiffestNPerMm;
        holds = fails;
        fails = std::min(kStride * fails, kStiffestNPerMm);
    }
    while (holds > 0.0 && fails > kPrecision * holds) {
        const double middle = std::sqrt(holds * fails);
        (holdsAt(middle) ? holds : fails) = middle;
    }
    return holds;
}

}  // namespace lab
