// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/simulated/Simulation.h"
#include "core/session/SessionChannels.h"

#include <cmath>
#include <ctime>

#include "core/session/SessionLoop.h"
#include "haptics/ServoLoop.h"

namespace haptics {
namespace {

using namespace core::session;
using namespace core::servo;

/// Number of ticks between two ticks of the session, as in the program: about 100 Hz at 1 kHz.
constexpr std::uint64_t kTicksPerSession = 10;

}  // namespace

double threadCpuUs()
{
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) * 1.0e6 + static_cast<double>(now.tv_nsec) * 1.0e-3;
}

core::Result<SimulationOutcome> simulate(
    const std::shared_ptr<const core::terrain::ToothAnatomy>& anatomy, HapticDevice& device, std::uint64_t ticks,
    const SimulationOptions& options,
    const std::function<std::optional<bool>(std::uint64_t, const ServoState&, const core::terrain::Tooth&)>& before,
    const std::function<void(std::uint64_t, const ServoState&)>& after)
{
    auto servoTick = makeServoTick(options.settings);
    if (!servoTick)
        return tl::unexpected(servoTick.error());
    const std::chrono::microseconds period(std::llround(1.0e6 / options.rateHz));
    const auto servoLinks = std::make_unique<ServoChannels>();
    const auto uiLinks = std::make_unique<UiChannels>();
    // A simulation never undoes, so the history needs no memory.
    SessionLoop session(*servoLinks, *uiLinks, options.settings, {options.record, 0});
    ServoLoop servo(device, std::move(*servoTick), *servoLinks, uiLinks->servo, period);

    bool drill = false;
    static_cast<void>(uiLinks->commands.tryPush(SetBur{static_cast<std::uint8_t>(options.burIndex)}));
    static_cast<void>(
        uiLinks->commands.tryPush(ReplaceTooth{std::make_unique<core::terrain::Tooth>(anatomy), 1, options.lesson}));
    session.tick(period);

    auto tickTimes = std::make_unique<TickTimes>();
    // Set until the servo has taken the tooth, in the first tick.
    std::optional<core::terrain::Tooth> uncut(anatomy);
    for (std::uint64_t tick = 0; tick < ticks; ++tick) {
        if (servo.tooth() != nullptr)
            uncut.reset();
        const std::optional<bool> wanted = before(tick, servo.state(), uncut ? *uncut : servo.tooth()->tooth());
        if (!wanted)
            break;
        if (*wanted != drill) {
            drill = *wanted;
            static_cast<void>(servoLinks->commands.tryPush(SetDrill{drill}));
        }
        const double start = threadCpuUs();
        servo.tick(period);
        tickTimes->add(threadCpuUs() - start);
        if (after)
            after(tick, servo.state());
        if (tick % kTicksPerSession == kTicksPerSession - 1) {
            session.tick(period);
            for (TilePatch patch; uiLinks->patches.tryPop(patch);)
                if (options.onPatch)
                    options.onPatch(patch);
        }
    }
    session.tick(period);
    core::terrain::Tooth tooth = servo.tooth() != nullptr ? servo.tooth()->tooth() : core::terrain::Tooth(anatomy);
    std::optional<core::recording::Recording> recording;
    if (options.record) {
        recording =
            session.recordingSoFar().value_or(core::recording::Recording(options.settings, anatomy, options.lesson));
        recording->setWitness({recording->ticks(), core::terrain::stateHash(tooth)});
    }
    return SimulationOutcome{std::move(tooth), servo.state(), std::move(recording), std::move(tickTimes)};
}

}  // namespace haptics
