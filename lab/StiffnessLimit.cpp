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
constexpr double kProbedS = 0.5;
constexpr double kRestMm = 0.15;

/// A Falcon that does not measure its delay.
class SilentFalcon final : public haptics::HapticDevice
{
public:
    SilentFalcon(const ClosedLoop& loop, const haptics::HandFigures& hand, const glm::dvec3& start)
        : falcon(loop.falcon, hand, 1.0 / loop.rateHz, 1, start)
    {}
    haptics::DeviceSample exchange(const glm::dvec3& forceOnHandN) noexcept override
    {
        haptics::DeviceSample sample = falcon.exchange(forceOnHandN);
        sample.delayS = 0.0F;
        return sample;
    }
    haptics::SimulatedFalcon falcon;
};

/// Returns whether the grip comes to rest in one trial. The settings must have been checked.
bool comesToRest(const core::terrain::Tooth& flat, const ClosedLoop& loop)
{
    haptics::HandFigures hand = loop.hand;
    hand.tremorMm = 0.0;
    hand.driftMm = 0.0;
    SilentFalcon device(loop, hand, {0.0, 0.0, kHeightMm});
    device.falcon.follow({0.0, 0.0, -1000.0 * kPushN / hand.stiffnessNPerM});
    device.falcon.push({0.0, 0.0, -kThrowMmPerS});
    const auto servo =
        *makeContestant(loop.settings, loop.ceds, device, std::make_unique<core::contact::LiveTooth>(flat), false,
                        std::chrono::microseconds(std::llround(1.0e6 / loop.rateHz)));
    glm::dvec3 low(1.0e9);
    glm::dvec3 high(-1.0e9);
    const auto ticks = static_cast<int>(kTrialS * loop.rateHz);
    const auto unwatched = static_cast<int>((kTrialS - kProbedS) * loop.rateHz);
    for (int tick = 0; tick < ticks; ++tick) {
        servo->tick();
        if (tick >= unwatched) {
            low = glm::min(low, device.falcon.tipMm());
            high = glm::max(high, device.falcon.tipMm());
        }
    }
    return glm::all(glm::lessThan(high - low, glm::dvec3(kRestMm)));
}

}  // namespace

core::Result<double> stiffnessLimit(const ClosedLoop& loop)
{
    if (const core::Status sound = checkContestant(loop.settings); !sound)
        return tl::unexpected(sound.error());
    const core::terrain::Tooth flat(enamelBlock([](glm::dvec2) { return 0.0; }));
    ClosedLoop tried = loop;
    const auto holdsAt = [&](double nPerMm) {
        tried.settings.force.stiffnessNPerMm = nPerMm;
        return comesToRest(flat, tried);
    };
    // Upwards first: the lattice method comes to rest again at stiffnesses far above its first failure.
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
