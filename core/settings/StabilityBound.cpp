// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/settings/StabilityBound.h"

#include <cmath>

namespace core::settings {
namespace {

constexpr double kImpactMPerS = 0.05;
constexpr double kDampingShare = 0.598;
constexpr double kLatenessShare = 0.27;
constexpr double kMPerMm = 0.001;

/// Returns a value with two decimals, rounded down, because the bound that is shown must be a valid setting.
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
        return unexpected(ErrorCode::OutOfRange,
                          LocalizableText{"the force limit is %1 N, and the device gives at most %2 N; lower it",
                                          {noted(plainNumber(preset.clampN)), noted(plainNumber(loop.forceLimitN))}});
    const StabilityBound bound = stabilityBound(preset, loop, periodS);
    if (preset.stiffnessNPerMm <= bound.stiffnessNPerMm)
        return {};
    const char* why = "the stiffness is %1 N/mm, and a light hand at %2 ms of delay is held up to %3 N/mm with this "
                      "damping; lower the stiffness, or damp more";
    if (bound.set == StabilityBound::Set::Lateness)
        why =
            "the stiffness is %1 N/mm, and a light hand at %2 ms of delay is held up to %3 N/mm however it is damped; "
            "lower the stiffness";
    else if (bound.set == StabilityBound::Set::Buzz)
        why = "the stiffness is %1 N/mm, and a light hand at %2 ms of delay is held up to %3 N/mm before it buzzes; "
              "lower the stiffness";
    return unexpected(ErrorCode::OutOfRange,
                      LocalizableText{why,
                                      {noted(plainNumber(preset.stiffnessNPerMm)),
                                       noted(plainNumber(1000.0 * loop.delayS)), noted(told(bound.stiffnessNPerMm))}});
}

}  // namespace core::settings
