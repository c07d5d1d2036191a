// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/settings/StabilityBound.h"

#include <cmath>

namespace core::settings {
namespace {

constexpr double kImpactMPerS = 0.05;
constexpr double kDampingShare = 0.6;
constexpr double kLatenessShare = 0.27;
constexpr double kMPerMm = 0.001;

/// Two decimals, rounded down: a bound that is told can be set.
std::string told(double value)
{
    return plainNumber(std::floor(value * 100.0) / 100.0);
}

}  // namespace

StabilityBound stabilityBound(const FeelPreset& preset, const LoopFigures& loop, double periodS)
{
    const double late = 0.5 * periodS + loop.delayS + loop.motorLagS;
    const double fastMPerS = contact::ForceLaw::kFastMmPerS * kMPerMm;
    const double square = kImpactMPerS * kImpactMPerS;
    const double damping = loop.viscousNSPerM + preset.dampingNSPerM +
                           preset.fastDampingNSPerM * square / (square + fastMPerS * fastMPerS) +
                           loop.coulombN / kImpactMPerS;
    StabilityBound bound{kDampingShare * damping / late * kMPerMm, StabilityBound::Set::Damping};
    if (const double most = kLatenessShare * loop.massKg / (late * late) * kMPerMm; most < bound.stiffnessNPerMm)
        bound = {most, StabilityBound::Set::Lateness};
    if (const double most = 2.0 * loop.coulombN / loop.countMm; most < bound.stiffnessNPerMm)
        bound = {most, StabilityBound::Set::Buzz};
    return bound;
}

Status checkStability(const FeelPreset& preset, const LoopFigures& loop, double periodS)
{
    if (auto sound = check(preset); !sound)
        return sound;
    if (preset.clampN > loop.forceLimitN)
        return unexpected(ErrorCode::OutOfRange, "the force limit is " + plainNumber(preset.clampN) +
                                                     " N, and the device gives at most " +
                                                     plainNumber(loop.forceLimitN) + " N; lower it");
    const StabilityBound bound = stabilityBound(preset, loop, periodS);
    if (preset.stiffnessNPerMm <= bound.stiffnessNPerMm)
        return {};
    std::string why = "with this damping";
    if (bound.set == StabilityBound::Set::Lateness)
        why = "however it is damped";
    else if (bound.set == StabilityBound::Set::Buzz)
        why = "before it buzzes";
    return unexpected(ErrorCode::OutOfRange, "the stiffness is " + plainNumber(preset.stiffnessNPerMm) +
                                                 " N/mm, and a light hand at " + plainNumber(1000.0 * loop.delayS) +
                                                 " ms of delay is held up to " + told(bound.stiffnessNPerMm) +
                                                 " N/mm " + why + "; lower the stiffness" +
                                                 (bound.set == StabilityBound::Set::Damping ? ", or damp more" : ""));
}

}  // namespace core::settings
