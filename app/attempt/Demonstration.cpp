// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/attempt/Demonstration.h"
#include "core/rt/TripleBuffer.h"
#include "core/servo/ServoState.h"

#include <algorithm>

#include "core/bur/Bur.h"
#include "haptics/falcon/FalconFeel.h"
#include "haptics/pointer/PointerDevice.h"
#include "haptics/simulated/DecayCavity.h"
#include "haptics/simulated/GuidedFalcon.h"

namespace app {
namespace {

constexpr std::uint64_t kMostTicks = 600'000;  ///< ten minutes
constexpr std::uint64_t kTicksPerDecision = 16;
constexpr std::uint64_t kTicksAfterwards = 500;

/// Returns options with the settings and the first bur of the lesson of an assignment.
haptics::SimulationOptions optionsFor(const lessons::Assignment& assignment)
{
    haptics::SimulationOptions options;
    options.settings = lessons::servoSettings(assignment.lesson ? &*assignment.lesson : nullptr, {});
    if (assignment.lesson && !assignment.lesson->burs.empty())
        options.burIndex = core::bur::findBur(assignment.lesson->burs.front()).value_or(options.burIndex);
    return options;
}

core::Result<haptics::SimulationOutcome> letWork(haptics::IdealHand hand, const lessons::Assignment& assignment,
                                                 const haptics::SimulationOptions& options, bool simulatedFalcon)
{
    core::rt::TripleBuffer<core::servo::PointerInput> pointer;
    const double stiffness = options.settings.force.stiffnessNPerMm;
    haptics::PointerDevice plain(pointer, stiffness, 1.0 / options.rateHz);
    haptics::GuidedFalcon guided(pointer, stiffness, 1.0 / options.rateHz);
    haptics::HapticDevice& device = simulatedFalcon ? static_cast<haptics::HapticDevice&>(guided) : plain;
    std::uint64_t doneAt = kMostTicks;
    return haptics::simulate(assignment.anatomy, device, kMostTicks, options,
                             [&](std::uint64_t tick, const core::servo::ServoState& state,
                                 const core::terrain::Tooth& now) -> std::optional<bool> {
                                 if (tick % kTicksPerDecision == 0)
                                     pointer.publish(hand.decide(state, now));
                                 if (hand.isDone())
                                     doneAt = std::min(doneAt, tick);
                                 if (tick >= doneAt + kTicksAfterwards)
                                     return std::nullopt;
                                 return !hand.isDone();
                             },
                             {});
}

}  // namespace

haptics::IdealHand handFor(const lessons::Assignment& assignment, std::size_t burIndex)
{
    const core::bur::Bur& bur = core::bur::burs()[burIndex];
    const core::terrain::ToothAnatomy& anatomy = *assignment.anatomy;
    const std::vector<float> wanted = assignment.ideal ? *assignment.ideal->top : haptics::decayCavity(anatomy, bur);
    return haptics::IdealHand(anatomy, wanted, bur, assignment.neighbours.get());
}

core::Result<haptics::SimulationOutcome> cutInstead(const lessons::Assignment& assignment,
                                                    const std::vector<float>& wanted)
{
    const haptics::SimulationOptions options = optionsFor(assignment);
    const core::bur::Bur& bur = core::bur::burs()[options.burIndex];
    return letWork(haptics::IdealHand(*assignment.anatomy, wanted, bur, assignment.neighbours.get()), assignment,
                   options, false);
}

core::Result<haptics::SimulationOutcome> demonstrate(const lessons::Assignment& assignment, bool simulatedFalcon)
{
    if (assignment.exercise)
        return core::unexpected(core::ErrorCode::WrongKind,
                                "nothing is to be cut in this exercise, so there is nothing to show; choose a lesson "
                                "in which something is");
    haptics::SimulationOptions options = optionsFor(assignment);
    options.record = true;
    if (simulatedFalcon)
        haptics::falcon::addFalconFeel(options.settings.force);
    if (assignment.lesson)
        options.lesson = assignment.lesson->json;
    return letWork(handFor(assignment, options.burIndex), assignment, options, simulatedFalcon);
}

}  // namespace app
